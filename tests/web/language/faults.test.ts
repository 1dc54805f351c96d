/** Faults told in English by the core, the builder and the page's workers, in German; and that these still say them so. */
import { afterEach, expect, test } from '@jest/globals';
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { en } from '../../../web/language/en.ts';
import { pageFaults } from '../../../web/language/en/page-faults.ts';
import { inOurWords } from '../../../web/language/faults.ts';
import { unpackedPlan } from '../../../web/room-maker/plan-code.mjs';
import { outlines } from '../../../web/room-maker/plan-shapes.mjs';
import { planOf, readPlan, usualItem } from '../../../web/room-maker/room-plan.mjs';
import { speak, words } from '../../../web/language/language.ts';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../..');

afterEach(() => speak('en'));

test('a fault is told in the language of the page, with what it tells of its own', async () => {
  const fault = "hall.glb: it requires the extension 'KHR_x', which is not understood; export without it";
  expect(inOurWords(fault)).toBe(fault);
  await speak('de');
  expect(inOurWords(fault)).toBe(
    'hall.glb: Die Datei verlangt die Erweiterung „KHR_x“, die hier nicht gelesen wird; ohne sie exportieren',
  );
  expect(inOurWords('the computation stopped (its script cannot be loaded); try again')).toMatch(
    /\(ihr Skript kann nicht geladen werden\); noch einmal versuchen$/,
  );
  expect(
    inOurWords('the room is only 0.4 m wide: pass --scale with the metres of one unit of the file'),
  ).toMatch(/nur 0,4 m breit/);
  expect(
    inOurWords(
      'spot.ies: line 12: the candela multiplier is 1.5e9, but must lie within 0 and 1000; correct it or export the file again',
    ),
  ).toBe(
    'spot.ies: Zeile 12: der Faktor der Lichtstärken ist 1.5e9, erlaubt ist 0 bis 1000; berichtigen oder die Datei noch einmal exportieren',
  );
  expect(
    inOurWords(
      "a.pdf: this is a PDF document, not a photometric file; take the luminaire's .ies or .ldt file",
    ),
  ).toMatch(/^a\.pdf: Das ist ein PDF-Dokument, keine/);
  expect(
    inOurWords('lamp.ldt: symmetry 2 (line 3) needs C plane 3 to be 180; correct the symmetry or the list'),
  ).toBe(
    'lamp.ldt: Symmetrie 2 (Zeile 3) verlangt für C-Ebene 3 den Winkel 180; die Symmetrie oder die Liste berichtigen',
  );
  expect(inOurWords('this is a GLDF container; unzip it and take out a.ldt, b.ies and others')).toBe(
    'Das ist ein GLDF-Container; entpacken und daraus a.ldt, b.ies und andere nehmen',
  );
  expect(
    inOurWords(
      'No layout found can give at least 2.47 lm/m2 on every patch of yellow wall: even the means fall short.',
    ),
  ).toBe(
    'Keine gefundene Anordnung gibt mindestens 2,47 lm/m2 auf jeder Teilfläche von yellow wall: Schon die Mittelwerte reichen nicht.',
  );
  expect(
    inOurWords(
      "material 'Verre' and 2 more: called glass but opaque, so it counts as a wall; where light is to pass, make it transparent (alpha BLEND)",
    ),
  ).toMatch(/^Material „Verre“ und 2 weitere: heißt Glas/);
  expect(
    inOurWords(
      'the room is open: 21.3 % of the light of its luminaires meets nothing and is lost; it leaves upward (97 %), to the east (20 %)',
    ),
  ).toMatch(/21,3 % des Lichts .* es entweicht nach oben \(97 %\), nach Osten \(20 %\)$/);
  expect(inOurWords('[r1] Height=high is not a number')).toBe('[r1] Height=high ist keine Zahl');
  expect(inOurWords('something that nobody foresaw')).toBe('something that nobody foresaw');
});

test('a rule that leaves no layout is told of one luminaire and of many', async () => {
  const told = (what: string) =>
    inOurWords(
      `arrangement: found no ${what} on the free sites; change the count, give it a range, or free the arrangement`,
    );
  expect(told('regular field of 1 luminaires')).toMatch(
    /^there is no regular field of 1 luminaire on the free/,
  );
  expect(told('layout in rows of 7 luminaires, at least 3 in each,')).toMatch(
    /^there is no layout in rows of 7 lum.* 3 in each/,
  );
  await speak('de');
  expect(told('symmetric layout of 9 luminaires')).toMatch(
    /gibt es keine symmetrische Anordnung von 9 Leuchten/,
  );
  expect(told('layout in rows of 7 luminaires, at least 3 in each,')).toMatch(
    /keine Anordnung in Reihen von 7 Leuchten, mindestens 3/,
  );
});

test('what is too much for memory is told with numbers that can be read', async () => {
  const told = (many: string) =>
    inOurWords(
      `this would need 9.5 GB of memory, and a page may use 1.5: ${many}, make the room smaller, or use the command`,
    );
  expect(told('100000 patches are too many; take larger ones')).toMatch(
    /: 100\u202f000 patches are too many; /,
  );
  await speak('de');
  expect(told('100000 patches are too many; take larger ones')).toMatch(
    / 9,5 GB .* 100\u202f000 Teilflächen /,
  );
  expect(told('9000 places for luminaires are too many; take a wider grid')).toMatch(
    /9\u202f000 Plätze .* Raster/,
  );
});

/** The text of what says them, its broken strings joined. */
function sources(
  folders: readonly string[] = [
    'core',
    'precompute',
    'web/solver',
    'web/builder',
    'web/document',
    'web/room-maker',
  ],
): string {
  const files = folders.flatMap((folder) =>
    readdirSync(path.join(root, folder), { recursive: true, encoding: 'utf8' })
      .filter((name) => /\.(cpp|h|mjs|ts)$/.test(name))
      .map((name) => readFileSync(path.join(root, folder, name), 'utf8')),
  );
  return files.join('\n').replace(/"\s*\n?\s*"/g, '');
}

test('remarks on a model are told in the language of the page, to their last clause', async () => {
  await speak('de');
  const told = (remark: string) => inOurWords(remark);
  expect(
    told(
      'as metres the model would be 556 x 559 m and 549 m high: it is taken to be in centimetres, 5.56 x 5.59 m and 5.49 m high; --scale 1 refuses that',
    ),
  ).toBe(
    'Als Meter gelesen wäre das Modell 556 × 559 m groß und 549 m hoch; es gilt als in Zentimetern gezeichnet: 5,56 × 5,59 m groß und 5,49 m hoch',
  );
  expect(
    told(
      'with y up the model would be 6 m high: it is taken to have z up, 6 x 4 m and 2.8 m high; --up y refuses that',
    ),
  ).toMatch(/^Mit Y nach oben wäre das Modell 6 m hoch; .*: 6 × 4 m groß und 2,8 m hoch$/);
  expect(
    told(
      '1 mesh has no material: ceilings are taken to reflect 0.7, walls 0.5, floors 0.2, other things 0.4',
    ),
  ).toMatch(/^Ein Netz hat kein Material: Decken gelten mit Reflexionsgrad 0,7, Wände 0,5, Böden 0,2, /);
  expect(
    told(
      "12 meshes have no material but white ('Default'): ceilings are taken to reflect 0.7, walls 0.5, floors 0.2, other things 0.4",
    ),
  ).toMatch(/^12 Netze haben kein Material außer Weiß \(„Default“\):/);
  expect(
    told(
      'only the place around 1,1.2,3 stays, 4 x 5 m and 2.8 m high: 1 of 6 rooms, and the rest is left out; --doors N takes in what lies behind so many open doors',
    ),
  ).toMatch(
    /^Nur der Ort um 1,1.2,3 bleibt, 4 × 5 m groß und 2,8 m hoch: 1 von 6 Räumen, alles andere ist weggelassen$/,
  );
  expect(
    told(
      "no mount is marked: luminaires are proposed to hang on 'slab' (54.2 m2, 2.94 m above the floor), of other storeys 'roof' (50 m2, 2.5 m above the floor); choose with --mount",
    ),
  ).toMatch(
    /an „slab“ \(54,2 m², 2,94 m über dem Boden\), in anderen Geschossen „roof“ \(50 m², 2,5 m über dem Boden\)$/,
  );
  expect(
    told(
      "159 m2 face the void or rest on something, no light comes there, and they are left out: 'a (back)' 31.1 m2, 'b' 30 m2 and 3 more",
    ),
  ).toMatch(/: „a \(back\)“ 31,1 m², „b“ 30 m² und 3 weitere$/);
  expect(
    told(
      "image 0 of material 'oak' is KTX2, which is not read (use PNG or JPEG): it counts as the material's plain colour",
    ),
  ).toMatch(/^Bild 0 des Materials „oak“ ist KTX2, das hier nicht gelesen wird/);
  expect(told("material 'VR_Gallery' reflects 0.99 of the light: taken as 0.95")).toBe(
    'Material „VR_Gallery“ reflektiert 0,99 des Lichts; gerechnet wird mit 0,95',
  );
});

test('what is wrong with a plan is told in the language of the page', async () => {
  const plan = planOf(outlines.rectangle(6, 4), 2.8);
  const told = (change: object) => inOurWords(readPlan({ ...plan, ...change }).fault ?? '');
  await speak('de');
  expect(told({ height: 60 })).toBe('height: muss zwischen 0,5 und 50 liegen');
  const red = { reflectance: 0.5, colour: 'red' };
  expect(told({ finishes: { ...plan.finishes, walls: red } })).toBe(
    'finishes.walls.colour: ist keine Farbe wie #f4f1ea',
  );
  expect(told({ items: Array(501).fill(usualItem('desk', [1, 1], 2.8)) })).toBe('items: mehr als 500');
  expect(told({ items: [null] })).toBe('items.0: fehlt oder ist etwas anderes');
  expect(inOurWords(unpackedPlan([99, 'x', 1, [], [], [], [], [], [], []]).fault ?? '')).toMatch(
    /^er stammt aus einer anderen Fassung \(Grundriss 99; /,
  );
});

test('each is what the sources say, word for word', () => {
  const text = sources();
  for (const [name, telling] of Object.entries(en.faults)) {
    const whole =
      typeof telling === 'string'
        ? telling
        : (telling as (...told: string[]) => string)(...Array<string>(6).fill('\u0001'));
    const missing = whole.split('\u0001').filter((piece) => piece.length > 3 && !text.includes(piece));
    // A sentence that is put together of several strings is there in its parts.
    const parts = missing.flatMap((piece) =>
      piece.split(
        /(?<=[:;,]) | (?=compression$|it$|--scale says how|says how|centimetres|millimetres: pass --scale 0.001$)|(?<= no material)(?=:| but)|(?=; so are )| (?=on the free sites)/,
      ),
    );
    expect([name, parts.filter((part) => !text.includes(part.trim()))]).toEqual([name, []]);
  }
});

test('a page has no command line: what names options is told with what can be done on the page', async () => {
  const remarks = [
    "no mount is marked: luminaires are proposed to hang on 'slab' (20 m2, 2.5 m above the floor); choose with --mount",
    'the ceiling is 9.2 m above the floor: is that so? --scale says how many metres a unit of the file has',
    'the ceiling is 9 m above the floor: is that so? in feet it would be 2.74 m: --scale 0.3048',
    "hall.glb: 3 of 8 sites of mount 'slab' are left out: something is less than 1 m below them; pass a smaller --drop",
    "--mount 'celing': no node or surface is called that; the closest are 'ceiling'",
  ];
  expect(remarks.map(inOurWords)).toEqual([
    "no mount is marked: luminaires are proposed to hang on 'slab' (20 m², 2.5 m above the floor)",
    'the ceiling is 9.2 m above the floor: is that so?',
    'the ceiling is 9 m above the floor: is that so? In feet, which can be chosen under How it was understood, it would be 2.74 m',
    "hall.glb: 3 of 8 places on 'slab' are left out: something is less than 1 m below them; hang luminaires less low",
    "'celing': no node or surface is called that; the closest are 'ceiling'",
  ]);
  await speak('de');
  expect(inOurWords(remarks[0]!)).toBe(
    'Nichts ist als Montageort markiert: Leuchten sind vorgeschlagen an „slab“ (20 m², 2,5 m über dem Boden)',
  );
  expect(inOurWords(remarks[1]!)).toBe('Die Decke liegt 9,2 m über dem Boden: Ist das so?');
});

test('no words of the page name an option, and each sentence on a model that does has words of the page', async () => {
  const said = (name: string, telling: unknown): string =>
    typeof telling === 'function'
      ? (telling as (...told: string[]) => string)(...Array<string>(6).fill('x'))
      : `${name} ${String(telling)}`;
  const withOption = ([name, telling]: [string, unknown]) => said(name, telling).includes('--');
  await speak('de');
  expect(Object.entries(words.value.faults).filter(withOption)).toEqual([]);
  expect(Object.entries(pageFaults).filter(withOption)).toEqual([]);
  for (const [name, telling] of Object.entries(en.faults))
    if (said(name, telling).includes('--')) expect([name, name in pageFaults]).toEqual([name, true]);

  // What is said while a model is read, surveyed and lit; not what an option itself must be.
  const below = ['gltf', 'geometry', 'rays', 'light'].map((folder) => `precompute/${folder}`);
  const literals = sources(below).match(/"[^"\n]*"/g) ?? [];
  const texts = literals.map((text) => text.slice(1, -1).trim());
  const options = texts.filter((text) => /[ (]--[a-z]/.test(text));
  const known = Object.entries(en.faults).map(([name, telling]) => said(name, telling));
  expect(options.length).toBeGreaterThan(12);
  expect(options.filter((text) => !known.some((each) => each.includes(text.slice(-22))))).toEqual([]);
});

/** Faults told in English by the core, the builder and the page's workers, in German; and that these still say them so. */
import { afterEach, expect, test } from '@jest/globals';
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { en } from '../../../web/language/en.ts';
import { inOurWords } from '../../../web/language/faults.ts';
import { speak } from '../../../web/language/language.ts';

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
      'the room is open: 21.3 % of the light of its luminaires meets nothing and is lost; it leaves upward (97 %), towards +x (20 %)',
    ),
  ).toMatch(/21,3 % des Lichts .* es entweicht nach oben \(97 %\), nach \+x \(20 %\)$/);
  expect(inOurWords('[r1] Height=high is not a number')).toBe('[r1] Height=high ist keine Zahl');
  expect(inOurWords('something that nobody foresaw')).toBe('something that nobody foresaw');
});

/** The text of what says them, its broken strings joined. */
function sources(): string {
  const files = ['core', 'precompute', 'web/solver', 'web/builder', 'web/document'].flatMap((folder) =>
    readdirSync(path.join(root, folder), { recursive: true, encoding: 'utf8' })
      .filter((name) => /\.(cpp|h|ts)$/.test(name))
      .map((name) => readFileSync(path.join(root, folder, name), 'utf8')),
  );
  return files.join('\n').replace(/"\s*\n?\s*"/g, '');
}

test('each is what the sources say, word for word', () => {
  const text = sources();
  for (const [name, telling] of Object.entries(en.faults)) {
    const whole =
      typeof telling === 'string'
        ? telling
        : (telling as (...told: string[]) => string)(...Array<string>(4).fill('\u0001'));
    const missing = whole.split('\u0001').filter((piece) => piece.length > 3 && !text.includes(piece));
    // A sentence that is put together of several strings is there in its parts.
    const parts = missing.flatMap((piece) =>
      piece.split(
        /(?<=[:;,]) | (?=compression$|it$|--scale says how|says how|centimetres|millimetres: pass --scale 0.001$)/,
      ),
    );
    expect([name, parts.filter((part) => !text.includes(part.trim()))]).toEqual([name, []]);
  }
});

/**
 * Do the sample rooms, and a building made for tests, keep the promised accuracy? Two questions a room: what another ray
 * seed changes, and whether a scene file says what `fiatlux light` says of the same luminaires. Writes docs/fidelity.md; prints a JSON row for every figure.
 *   node tests/bench/promises.mjs [--work FOLDER] [id ...]
 * after `npm run build`; about twenty minutes on 2 cores. --work keeps the scene files there and takes those that lie there. With
 * ids only these rooms are measured, and their sections written anew.
 */
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { catalog } from '../../rooms/catalog.mjs';
import { makeBuilding } from '../rooms/made-building.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const { values: options, positionals: ids } = parseArgs({
  options: { work: { type: 'string' } },
  allowPositionals: true,
});
const work = options.work ?? mkdtempSync(path.join(tmpdir(), 'fiatlux-promises-'));
mkdirSync(work, { recursive: true });

const seedLayouts = 24; // half with one luminaire, half with six
const truthLayouts = 2; // of six luminaires and of one
const dimShare = 0.05; // of the room's mean: surfaces below it are dim
const promises = {
  'seed mean, bright': 0.005,
  'seed sigma, bright': 0.01,
  'seed mean, dim': 0.02,
  'seed sigma, dim': 0.05,
  'light mean': 0.005,
  'light sigma': 0.015,
  'light patches RMS': 0.02,
};

function fiatlux(...args) {
  const command = path.join(root, 'build/fiatlux');
  const result = spawnSync(command, args, { encoding: 'utf8', maxBuffer: 1 << 28 });
  if (result.status !== 0) throw new Error(`fiatlux ${args.join(' ')}: ${result.stderr}`);
  return result.stdout;
}

/** Two storeys of three rooms each, with doors, a stair, furniture and glass. */
const building = {
  id: 'building',
  said: { en: { title: 'Building of six rooms' } },
  precompute: ['--patch', '0.25', '--cluster', '4', '--site-size', '0.5'],
};
const buildingGlb = path.join(work, 'building.glb');
const rooms = [...catalog, building];

const glbOf = (room) => (room === building ? buildingGlb : path.join(root, `public/scenes/${room.id}.glb`));

function sceneFile(room, seed) {
  const file = path.join(work, `${room.id}-${seed}.flux`);
  if (!existsSync(file))
    fiatlux('precompute', glbOf(room), '-o', file, ...room.precompute, '--seed', `${seed}`);
  return file;
}

/** A generator of its own, so that the layouts stay the same (mulberry32). */
function randomOf(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let bits = Math.imul(state ^ (state >>> 15), 1 | state);
    bits = (bits + Math.imul(bits ^ (bits >>> 7), 61 | bits)) ^ bits;
    return ((bits ^ (bits >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Random layouts of different sites: odd ones of one luminaire, even ones of six. */
function layoutsOf(room, sites) {
  const random = randomOf(2014);
  return Array.from({ length: seedLayouts }, (_, i) => {
    const chosen = new Set();
    while (chosen.size < (i % 2 === 1 ? 1 : 6)) chosen.add(Math.floor(random() * sites));
    const file = path.join(work, `${room.id}-layout-${i}.json`);
    writeFileSync(file, JSON.stringify({ luminaires: [...chosen].map((site) => ({ site, flux: 3000 })) }));
    return file;
  });
}

const change = (value, reference) => Math.abs(value / reference - 1);

/** Adds what differs between two lists of the same surfaces. */
function compareSurfaces(kind, reference, found, add) {
  reference.surfaces.forEach((a, i) => {
    const b = found.surfaces[i];
    const dim = a.mean < dimShare * reference.all.mean;
    const where = { surface: a.name, patches: a.patches, area: a.area, dim };
    const suffix = kind === 'seed' ? (dim ? ', dim' : ', bright') : '';
    add(`${kind} mean${suffix}`, change(b.mean, a.mean), where);
    if (a.patches > 1) add(`${kind} sigma${suffix}`, change(b.sigma, a.sigma), where);
  });
}

/** surface, area and illuminance of every patch that is not on a measuring plane. */
function readPatches(file, measuring) {
  return readFileSync(file, 'utf8')
    .trim()
    .split('\n')
    .slice(1)
    .map((line) => {
      const cells = line.match(/^("(?:[^"]|"")*"|[^,]*),(.*)$/);
      const numbers = cells[2].split(',').map(Number);
      return { surface: cells[1], area: numbers[6], light: numbers[8] };
    })
    .filter(({ surface }) => !measuring.has(surface));
}

/** Root mean square of the differences over the area, as a share of the mean. */
function patchDifference(reference, found) {
  let squares = 0;
  let area = 0;
  let light = 0;
  reference.forEach((a, i) => {
    if (found[i].surface !== a.surface || Math.abs(found[i].area - a.area) > 1e-6)
      throw new Error(`patch ${i} of the two files is not the same`);
    squares += a.area * (found[i].light - a.light) ** 2;
    area += a.area;
    light += a.area * a.light;
  });
  return Math.sqrt(squares / area) / (light / area);
}

/** Options of the command but for these, each of which has a value. */
function without(left, options) {
  return options.filter((word, i) => !left.includes(word) && !left.includes(options[i - 1]));
}

function compareWithLight(room, layout, add) {
  const [fast, truth] = ['fast.csv', 'truth.csv'].map((name) => path.join(work, name));
  const lightOptions = without(['--cluster', '--refine', '--opening'], room.precompute);
  const evaluated = JSON.parse(
    fiatlux('evaluate', sceneFile(room, 1), '--layout', layout, '--json', '--patches', fast),
  );
  const lit = JSON.parse(
    fiatlux('light', glbOf(room), '--layout', layout, ...lightOptions, '--json', '--patches', truth),
  );
  compareSurfaces('light', lit, evaluated, add);
  const measuring = new Set(lit.surfaces.filter((s) => s.measuring).map((s) => s.name));
  const difference = patchDifference(readPatches(truth, measuring), readPatches(fast, measuring));
  add('light patches RMS', difference, { surface: 'all', patches: lit.all.patches, area: lit.all.area });
}

function measure(room) {
  const figures = Object.fromEntries(Object.keys(promises).map((name) => [name, []]));
  const add = (name, value, where) => figures[name].push({ value, ...where });
  const info = JSON.parse(fiatlux('info', sceneFile(room, 1), '--json'));
  const layouts = layoutsOf(room, info.sites);
  const evaluate = (seed, layout) =>
    JSON.parse(fiatlux('evaluate', sceneFile(room, seed), '--layout', layout, '--json'));
  for (const layout of layouts) compareSurfaces('seed', evaluate(1, layout), evaluate(2, layout), add);
  for (const layout of layouts.slice(0, truthLayouts)) compareWithLight(room, layout, add);
  return { room, info, figures };
}

const percent = (value) => `${(100 * value).toFixed(2)} %`;

function summarize({ room, figures }) {
  return Object.entries(figures).flatMap(([name, list]) => {
    if (list.length === 0) return [];
    const sorted = [...list].sort((a, b) => a.value - b.value);
    const worst = sorted.at(-1);
    const over = list.filter(({ value }) => !(value <= promises[name]));
    const row = {
      room: room.id,
      figure: name,
      promise: promises[name],
      values: list.length,
      median: sorted[Math.floor(sorted.length / 2)].value,
      worst: worst.value,
      surface: worst.surface,
      over: over.length,
    };
    process.stdout.write(`${JSON.stringify(row)}\n`);
    return [{ ...row, missed: over }];
  });
}

/** The surfaces that miss, the most frequent first. */
function missing(rows) {
  const surfaces = new Map();
  for (const { figure, missed } of rows)
    for (const miss of missed) {
      const key = `${figure}|${miss.surface}`;
      const entry = surfaces.get(key) ?? { figure, ...miss, times: 0 };
      surfaces.set(key, { ...entry, times: entry.times + 1, value: Math.max(entry.value, miss.value) });
    }
  return [...surfaces.values()].sort((a, b) => b.times - a.times);
}

const cell = (name) => name.replaceAll('|', '\\|');

function section(result) {
  const rows = summarize(result);
  const misses = missing(rows);
  const table = rows.map(
    (row) =>
      `| ${row.figure} | ${percent(row.promise)} | ${percent(row.median)} | ${percent(row.worst)} | ` +
      `${cell(row.surface)} | ${row.over} of ${row.values} |`,
  );
  const list = misses
    .slice(0, 12)
    .map(
      (miss) =>
        `- ${cell(miss.surface)} (${miss.patches} patches, ${miss.area.toFixed(2)} m2${miss.dim ? ', dim' : ''}): ` +
        `${miss.figure} up to ${percent(miss.value)}, ${miss.times} times`,
    );
  const rest = misses.length > 12 ? [`- and ${misses.length - 12} more, each missing less often`] : [];
  return [
    `## ${result.room.said.en.title}`,
    '',
    `${result.info.patches} patches, ${result.info.sites} sites, ${result.info.surfaces.length} surfaces, ` +
      `residual ${percent(result.info.residuals.at(-1))}; \`${without(['--opening'], result.room.precompute).join(' ')}\`.`,
    '',
    '| figure | promise | median | worst | worst at | missed |',
    '| --- | --- | --- | --- | --- | --- |',
    ...table,
    '',
    ...(misses.length > 0 ? ['Missed by:', '', ...list, ...rest, ''] : ['Nothing missed.', '']),
  ].join('\n');
}

const introduction = `# What the sample rooms keep of the promised accuracy

The last of them, a building of six rooms, is made for tests (\`tests/rooms/made-building.mjs\`): two storeys, inner doors, a
stair through the slab, furniture, and windows of glass, through which light is lost.

Made by \`node tests/bench/promises.mjs\`: nothing below is edited by hand.

- **seed**: the precompute again with other rays; the change of mean and sigma of every surface over ${seedLayouts} random layouts of
  one and six luminaires. *Dim* surfaces have less than ${100 * dimShare} % of the room's mean; they may change more.
- **light**: \`fiatlux evaluate\` on the scene file against \`fiatlux light\` on the model, the same luminaires as free rectangles,
  ${truthLayouts} random layouts. Patches: root mean square of the differences over the room's area, as a share of the room's mean.

A value is one surface under one layout. Surfaces of a single patch have no sigma.

Surfaces that miss a promise are listed under their room: mostly small ones, and ones in the shadow of others.
Rely on \`light\` for sigma and extremes of small furniture: \`fiatlux info\` names the surfaces of fewer than 100 patches, and so
does the app under "About this room".

`;

const document = path.join(root, 'docs/fidelity.md');
const heading = (room) => `## ${room.said.en.title}\n`;
/** Made by photometry-fidelity.mjs. */
const photometry = { said: { en: { title: 'Luminaires of photometric files' } } };

/** A room's section as the document has it. */
function written(text, room) {
  const start = text.indexOf(heading(room));
  const next = text.indexOf('\n## ', start);
  return next < 0 ? text.slice(start) : text.slice(start, next + 1);
}

try {
  const measured = (room) => ids.length === 0 || ids.includes(room.id);
  const before = existsSync(document) ? readFileSync(document, 'utf8') : '';
  if (measured(building)) writeFileSync(buildingGlb, await makeBuilding().bytes());
  const told = rooms.filter((room) => measured(room) || before.includes(heading(room)));
  const sections = told.map((room) => (measured(room) ? section(measure(room)) : written(before, room)));
  if (before.includes(heading(photometry))) sections.push(written(before, photometry));
  writeFileSync(document, `${introduction}${sections.map((text) => text.trimEnd()).join('\n\n')}\n`);
} finally {
  if (options.work === undefined) rmSync(work, { recursive: true });
}

/**
 * Where the defaults of the precompute come from: error against time for rays and refinement steps on the E corridor, and
 * cost against the number of patches. Writes the last two sections of docs/transport.md with their charts and the raw rows
 * beside it.
 *   node tests/bench/transport-sweep.mjs       after `npm run build`; takes about fifteen minutes on 2 cores; needs /usr/bin/time
 */
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { cpus, tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { logChart } from './svg-chart.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const docs = path.join(root, 'docs', 'transport');
const ownSections = '## Rays and refinement'; // and what follows it; above stands what no run knows
const work = mkdtempSync(path.join(tmpdir(), 'fiatlux-sweep-'));
const room = path.join(work, 'room.glb');
const rayCounts = [64, 256, 1024, 4096, 16384];
const refinements = [0, 1, 2, 3];
const cut = ['--patch', '0.375', '--cluster', '2']; // clusters of 0.75 m as in the sample room
const patchEdges = [0.42, 0.27, 0.1875, 0.11, 0.066]; // m: about 5 000 to 200 000 patches

/** The E corridor with a quarter of its sites: the direct light of them all would hide what the rays cost. */
function writeSparseRoom() {
  const model = readFileSync(path.join(root, 'public/scenes/e-corridor.glb'));
  const at = model.indexOf('"siteSpacing":0.75');
  if (at < 0) throw new Error('the E corridor no longer has sites 0.75 m apart');
  model.write('"siteSpacing":1.50', at);
  writeFileSync(room, model);
}

function fiatlux(...args) {
  const result = spawnSync(
    '/usr/bin/env',
    ['time', '-f', 'peakKiB=%M', path.join(root, 'build/fiatlux'), ...args],
    {
      encoding: 'utf8',
      maxBuffer: 1 << 28,
    },
  );
  if (result.status !== 0) throw new Error(`fiatlux ${args.join(' ')}: ${result.stderr}`);
  return {
    json: () => JSON.parse(result.stdout),
    peakMiB: Number(/peakKiB=(\d+)/.exec(result.stderr)?.[1]) / 1024,
  };
}

/** Twenty fixed layouts of six luminaires. */
const makeLayouts = (siteCount) =>
  Array.from({ length: 20 }, (_, i) => {
    const file = path.join(work, `layout-${i}.json`);
    const luminaires = Array.from({ length: 6 }, (_, j) => ({
      site: (37 * i + 43 * j + 11 * i * j) % siteCount,
      flux: 3000,
    }));
    const sites = new Set();
    for (const luminaire of luminaires) {
      while (sites.has(luminaire.site)) luminaire.site = (luminaire.site + 1) % siteCount;
      sites.add(luminaire.site);
    }
    writeFileSync(file, JSON.stringify({ luminaires }));
    return file;
  });

function precompute(name, ...options) {
  const file = path.join(work, `${name}.flux`);
  const { peakMiB } = fiatlux(
    'precompute',
    room,
    '-o',
    file,
    '--site-size',
    '0.75',
    '--memory',
    '16',
    ...options,
  );
  const { json } = fiatlux('info', file, '--json');
  return { file, peakMiB, info: json() };
}

/** Surfaces' means and sigmas of all layouts. */
function statistics(file, layouts) {
  return layouts.flatMap((layout) =>
    fiatlux('evaluate', file, '--layout', layout, '--json')
      .json()
      .surfaces.map(({ name, mean, sigma }) => ({ name, mean, sigma })),
  );
}

/** Root mean square of relative differences. */
function difference(rows, reference, key) {
  const squares = rows.map((row, i) => (row[key] / reference[i][key] - 1) ** 2);
  return Math.sqrt(squares.reduce((sum, value) => sum + value, 0) / rows.length);
}

const secondsOf = (info) =>
  ['form factors', 'direct light', 'low-rank radiosity', 'interreflection', 'statistics'].reduce(
    (sum, stage) => sum + (info.seconds[stage] ?? 0),
    0,
  );

const csv = (rows) =>
  `${Object.keys(rows[0]).join(',')}\n${rows.map((row) => Object.values(row).join(',')).join('\n')}\n`;
const table = (rows) =>
  [
    `| ${Object.keys(rows[0]).join(' | ')} |`,
    `|${' --- |'.repeat(Object.keys(rows[0]).length)}`,
    ...rows.map((row) => `| ${Object.values(row).join(' | ')} |`),
  ].join('\n');
const show = (value) => Number(value.toPrecision(3));

/** Least-squares slope in log-log. */
function exponent(points) {
  const logs = points.map(([a, b]) => [Math.log(a), Math.log(b)]);
  const mean = (at) => logs.reduce((sum, point) => sum + point[at], 0) / logs.length;
  const [mx, my] = [mean(0), mean(1)];
  const up = logs.reduce((sum, [a, b]) => sum + (a - mx) * (b - my), 0);
  return up / logs.reduce((sum, [a]) => sum + (a - mx) ** 2, 0);
}

function accuracy() {
  const truth = precompute('truth', ...cut, '--rays', '16384', '--refine', '24', '--seed', '99');
  const layouts = makeLayouts(truth.info.sites);
  const reference = statistics(truth.file, layouts);
  rmSync(truth.file);
  const rows = [];
  for (const rays of rayCounts)
    for (const refine of refinements) {
      const { file, info } = precompute('try', ...cut, '--rays', `${rays}`, '--refine', `${refine}`);
      const found = statistics(file, layouts);
      rows.push({
        patches: info.patches,
        rays,
        refine,
        seconds: show(secondsOf(info)),
        'mean error %': show(100 * difference(found, reference, 'mean')),
        'sigma error %': show(100 * difference(found, reference, 'sigma')),
        residual: show(info.residuals.at(-1)),
      });
      process.stdout.write(`${JSON.stringify(rows.at(-1))}\n`);
    }
  return rows;
}

function growth() {
  return patchEdges.map((patch) => {
    const { file, info, peakMiB } = precompute('grow', '--patch', `${patch}`);
    const row = {
      patch,
      patches: info.patches,
      clusters: info.clusters,
      seconds: show(secondsOf(info)),
      peakMiB: Math.round(peakMiB),
    };
    rmSync(file);
    process.stdout.write(`${JSON.stringify(row)}\n`);
    return row;
  });
}

/** What more rays bring and cost, refined twice. */
function gain(rows, from, to) {
  const [a, b] = [from, to].map((rays) => rows.find((row) => row.rays === rays && row.refine === 2));
  const [mean, sigma] = ['mean', 'sigma'].map((key) =>
    (a[`${key} error %`] / b[`${key} error %`]).toFixed(1),
  );
  return `From ${from} to ${to} rays the mean's error falls by a factor of ${mean}, sigma's by ${sigma}, in ${(b.seconds / a.seconds).toFixed(1)} times the time.`;
}

mkdirSync(docs, { recursive: true });
writeSparseRoom();
try {
  const errors = accuracy();
  const costs = growth();
  writeFileSync(path.join(docs, 'accuracy.csv'), csv(errors));
  writeFileSync(path.join(docs, 'growth.csv'), csv(costs));
  const lines = (key) =>
    refinements.map((refine) => ({
      name: `refine ${refine}`,
      points: errors.filter((row) => row.refine === refine).map((row) => [row.seconds, row[key]]),
    }));
  for (const key of ['mean', 'sigma'])
    writeFileSync(
      path.join(docs, `${key}-error.svg`),
      logChart({
        title: `Error of ${key} against time, E corridor, rays ${rayCounts[0]} to ${rayCounts.at(-1)}`,
        x: 'seconds',
        y: 'RMS error, %',
        series: lines(`${key} error %`),
      }),
    );
  const times = costs.map((row) => [row.patches, row.seconds]);
  const memory = costs.map((row) => [row.patches, row.peakMiB]);
  writeFileSync(
    path.join(docs, 'growth.svg'),
    logChart({
      title: 'Cost against the number of patches, E corridor',
      x: 'patches',
      y: 'seconds, MiB',
      series: [
        { name: 'seconds', points: times },
        { name: 'MiB', points: memory },
      ],
    }),
  );
  const page = path.join(root, 'docs', 'transport.md');
  const [written] = readFileSync(page, 'utf8').split(`${ownSections}\n`);
  writeFileSync(
    page,
    `${written}${ownSections}

Made by \`node tests/bench/transport-sweep.mjs\` on ${cpus().length} cores (${cpus()[0].model.trim()}).

E corridor, ${errors[0].patches} patches in clusters of 2 x 2, every fourth of its sites. Errors are root mean squares of relative differences over 20 layouts of six luminaires
and 4 surfaces, against 16384 rays of another seed refined until it had settled. Seconds are those of the transport, rays to statistics.

![Error of the mean](transport/mean-error.svg)
![Error of sigma](transport/sigma-error.svg)

${table(errors)}

A response that comes straight from the low-rank inverse (refine 0) is off by its clusters' blur, however many rays there are.
One step brings the error down to what the rays leave; here the second changes it little, but it lowers the residual tenfold
once more. Furnished rooms start higher (the open office: 0.09, 0.015, 0.004, 0.0013, 0.0005): each block of responses is
refined until less than 0.1 % is left, which the rays' own noise hides.

${gain(errors, 64, 1024)} ${gain(errors, 1024, 4096)} ${gain(errors, 4096, 16384)}
Up to 1024 only the rays to the closest patches grow; above, the shadow rays to all others do, too. Hence the defaults: 1024
rays, from where on accuracy is paid for in full, and steps until 0.1 % is left.

## Patches

E corridor at several patch sizes, 1024 rays, refined until 0.1 % is left; clusters are kept below about 3000.

![Cost against patches](transport/growth.svg)

${table(costs)}

Time grows as n^${exponent(times).toFixed(2)}, memory as n^${exponent(memory).toFixed(2)}.
`,
  );
} finally {
  rmSync(work, { recursive: true, force: true });
}

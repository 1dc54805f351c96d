/**
 * The figures of the program: one JSON object a line, and build/bench.jsonl anew. Native and Wasm run the same work in
 * batches that take turns; a figure is the median of the batches, `spread` the distance between their quartiles.
 * The first row says on which machine and of which commit they are.
 *   node tests/bench/bench.mjs [name ...]      after `npm run build` and both builds of the benchmarks
 */
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync, gzipSync, inflateSync } from 'node:zlib';
import { dragToLayout, firstPaintScripts } from './drag-bench.mjs';
import { dropsOnOffice } from './drop-bench.mjs';
import { repaintsOfOffice } from './repaint-bench.mjs';
import { firstVisits } from './first-bench.mjs';
import { describeRun } from './machine.mjs';
import { dropToLight, pageBesideCommand } from './room-bench.mjs';
import { openSession, wishOf } from './open-session.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const inRoot = (...parts) => path.join(root, ...parts);
const corridor = inRoot('public/scenes/e-corridor.flux');
const office = inRoot('public/scenes/office.flux');
const batches = 7;
const ticksPerSecond = 100; // of Linux, in /proc/PID/stat
const wanted = new Set(process.argv.slice(2));
const rows = [];

function print(row) {
  rows.push(JSON.stringify(row));
  process.stdout.write(`${rows.at(-1)}\n`);
}

function need(file) {
  if (existsSync(file)) return file;
  process.stderr.write(`bench: ${path.relative(root, file)} is missing: run npm run bench\n`);
  process.exit(2);
}

const round = (value, digits = 4) => Number(value.toPrecision(digits));

/** Median and distance between the quartiles. */
function summary(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const at = (share) => sorted[Math.round(share * (sorted.length - 1))];
  return { median: at(0.5), spread: at(0.75) - at(0.25) };
}

/** One row from batches of both sides that took turns. */
function compare(name, unit, native, wasm, more = {}) {
  const [a, b] = [summary(native), summary(wasm)];
  const ratios = native.map((value, i) => wasm[i] / value);
  print({
    name,
    native: round(a.median),
    wasm: round(b.median),
    unit,
    spread: round(a.spread, 2),
    wasmSpread: round(b.spread, 2),
    ratio: round(summary(ratios).median, 3),
    batches,
    ...more,
  });
}

function output(command, args) {
  const result = spawnSync(command, args, { cwd: root, encoding: 'utf8' });
  if (result.status === 0) return result.stdout;
  process.stderr.write(`bench: ${command} ${args.join(' ')}: ${result.stderr}\n`);
  process.exit(2);
}

/** Full sums and moves of the search, for several numbers of luminaires. */
function kernels() {
  const native = need(inRoot('build/native/tests/kernel_bench'));
  const wasm = need(inRoot('build/wasm/tests/kernel_bench.js'));
  const results = { native: [], wasm: [] };
  for (let batch = 0; batch < batches; ++batch) {
    results.native.push(JSON.parse(output(native, [])));
    results.wasm.push(JSON.parse(output('node', [wasm])));
  }
  for (const name of Object.keys(results.native[0])) {
    const side = (of) => of.map((batch) => batch[name]);
    compare(name, 'ns', side(results.native), side(results.wasm), { sites: 258 });
  }
}

/** 25 000 evaluations on the E corridor: N = 6, least sigma of all surfaces, 40 seeds a batch. */
async function solve25000() {
  const tool = need(inRoot('build/native/tests/solve_bench'));
  const session = await openSession(need(inRoot('web/solver/core.wasm')), need(corridor), inflateSync);
  const error = session.setIntentions(
    wishOf(session, { goals: [{ statistic: 'sigma', sense: 'min', weight: 1, surfaces: ['all'] }] }),
  );
  if (error) throw new Error(error);
  const inWasm = () => {
    const times = [];
    for (let seed = 1; seed <= 40; ++seed) {
      const begin = performance.now();
      session.start(seed);
      session.advance(25_000);
      times.push(performance.now() - begin);
    }
    return summary(times).median;
  };
  inWasm();
  const native = [];
  const wasm = [];
  for (let batch = 0; batch < batches; ++batch) {
    native.push(Number(output(tool, [corridor])));
    wasm.push(inWasm());
  }
  compare('solve_25000', 'ms', native, wasm, { luminaires: 6, goal: 'min sigma of all' });
  session.delete();
}

/** The strip of counts on the office: 3 to 24 luminaires, each from the layout of the one before, as the page asks. */
async function countStrip() {
  const session = await openSession(need(inRoot('web/solver/core.wasm')), need(office), inflateSync);
  const all = ['all'];
  const wish = {
    goals: [
      { statistic: 'sigma', sense: 'min', weight: 1, surfaces: all },
      { statistic: 'power', sense: 'min', weight: 1, surfaces: [] },
    ],
    constraints: [
      { statistic: 'mean', min: 150, surfaces: all },
      { statistic: 'chebyshev', min: 10, surfaces: all },
    ],
  };
  const strip = () => {
    let start = new Uint32Array();
    const begin = performance.now();
    for (let count = 3; count <= 24; ++count) {
      const asked = wishOf(session, { ...wish, luminaires: { count, flux: 4e3, dimming: [0.1, 1] } });
      const error = session.startAside(asked, 1, start, 3000);
      let found = null;
      while (!error && found === null) found = session.advanceAside(3000);
      if (error || typeof found === 'string') throw new Error(error || found);
      start = found.layout.sites;
    }
    return performance.now() - begin;
  };
  strip();
  const { median, spread } = summary(Array.from({ length: batches }, strip));
  print({
    name: 'count_strip',
    wasm: round(median),
    unit: 'ms',
    spread: round(spread, 2),
    batches,
    counts: '3..24',
  });
  session.delete();
}

/** A hall under many candidates: the form of its statistics that each number of them takes, and what that costs. */
function halls() {
  const native = need(inRoot('build/native/tests/hall_bench'));
  const wasm = need(inRoot('build/wasm/tests/hall_bench.js'));
  for (const candidates of [258, 1032, 5000]) {
    const sides = { native: [], wasm: [] };
    for (let batch = 0; batch < 3; ++batch) {
      sides.native.push(JSON.parse(output(native, [String(candidates)])));
      sides.wasm.push(JSON.parse(output('node', [wasm, String(candidates)])));
    }
    const { luminaires, patches, form } = sides.native[0];
    const more = { batches: 3, candidates, luminaires, patches, form };
    for (const [key, unit] of [
      ['delta_floor_ns', 'ns'],
      ['delta_all_ns', 'ns'],
      ['first_layout_ms', 'ms'],
      ['peak_mb', 'MB'],
    ]) {
      const of = (side) => sides[side].map((batch) => batch[key]);
      compare(`hall_${candidates}_${key.replace(/_(ns|ms|mb)$/, '')}`, unit, of('native'), of('wasm'), more);
    }
  }
}

/** Runs the command to its end; seconds by the clock and of all processors, and the peak of its memory. */
function timed(command, args) {
  return new Promise((resolve, reject) => {
    const begin = performance.now();
    const child = spawn(command, args, { cwd: root, stdio: 'ignore' });
    let [peak, ticks] = [0, 0];
    const timer = setInterval(() => {
      try {
        const status = readFileSync(`/proc/${child.pid}/status`, 'utf8');
        peak = Math.max(peak, Number(/VmHWM:\s+(\d+)/.exec(status)?.[1] ?? 0));
        const [user, system] = readFileSync(`/proc/${child.pid}/stat`, 'utf8')
          .split(') ')[1]
          .split(' ')
          .slice(11);
        ticks = Math.max(ticks, Number(user) + Number(system));
      } catch {
        // It has ended.
      }
    }, 20);
    child.on('error', reject);
    child.on('exit', (code) => {
      clearInterval(timer);
      if (code !== 0) reject(new Error(`${command} ${args.join(' ')} ended with status ${code}`));
      else
        resolve({
          seconds: (performance.now() - begin) / 1000,
          processor: ticks / ticksPerSecond,
          mebibytes: peak / 1024,
        });
    });
  });
}

async function precompute() {
  const { catalog } = await import('../../rooms/catalog.mjs');
  const options = catalog.find(({ id }) => id === 'e-corridor').precompute;
  const folder = mkdtempSync(path.join(tmpdir(), 'fiatlux-bench-'));
  const target = path.join(folder, 'e-corridor.flux');
  const source = need(inRoot('public/scenes/e-corridor.glb'));
  const runs = [];
  for (let run = 0; run < 5; ++run) {
    rmSync(target, { force: true });
    runs.push(await timed(need(inRoot('build/fiatlux')), ['precompute', source, '-o', target, ...options]));
  }
  const { median, spread } = summary(runs.map(({ seconds }) => seconds));
  print({
    name: 'precompute_e_corridor',
    native: round(median),
    unit: 's',
    spread: round(spread, 2),
    peak_mib: Math.round(Math.max(...runs.map(({ mebibytes }) => mebibytes))),
    batches: runs.length,
    stages: JSON.parse(output(inRoot('build/fiatlux'), ['info', target, '--json'])).seconds,
  });
  rmSync(folder, { recursive: true });
}

/** The whole pass of the page's own module beside the command's, of models without options. */
async function precomputeWasm() {
  const fiatlux = need(inRoot('build/fiatlux'));
  const command = async (model, target) =>
    (await timed(fiatlux, ['precompute', model, '-o', target])).processor;
  need(inRoot('public/builder/builder.wasm'));
  for (const room of ['box', 'gallery', 'e-corridor']) {
    const model = need(inRoot(`public/scenes/${room}.glb`));
    const { native, wasm, apart } = await pageBesideCommand(root, model, command);
    print({
      name: `precompute_wasm_${room.replace('-', '_')}`,
      native: round(native),
      wasm: round(wasm),
      unit: 's of processor',
      ratio: round(wasm / native, 3),
      wanted: 2.5,
      mean_within: round(apart.mean, 2),
      sigma_within: round(apart.sigma, 2),
    });
  }
}

/** A model that is dropped on the built page: until its preview, and until its full light; and the page's longest task. */
async function dropped() {
  need(inRoot('dist/index.html'));
  for (const room of ['e-corridor', 'office']) {
    const model = need(inRoot(`public/scenes/${room}.glb`));
    const { preview, full, longest } = await dropToLight(root, model);
    const of = room.replace('-', '_');
    const lit = { wasm: round(preview / 1e3), unit: 's', wanted: 12, full: round(full / 1e3) };
    print({ name: `drop_to_light_${of}`, native: null, ...lit });
    print({ name: `longest_task_${of}`, native: null, wasm: round(longest), unit: 'ms', wanted: 50 });
  }
}

const bytes = (name, size, more = {}) => print({ name, native: size, unit: 'bytes', spread: 0, ...more });
const packed = (file) => gzipSync(readFileSync(file), { level: 9 }).length;
/** As hosts that know Brotli send it. */
const packedBest = (file) => brotliCompressSync(readFileSync(file)).length;

async function firstLoad() {
  const scripts = await firstPaintScripts(need(inRoot('dist/index.html')));
  const size = scripts.reduce((sum, file) => sum + packed(file), 0);
  bytes('js_compressed', size, { files: scripts.map((file) => path.basename(file)) });
}

async function drag() {
  need(inRoot('dist/index.html'));
  print({ name: 'drag_to_layout', ...(await dragToLayout(root, corridor, inflateSync)) });
}

/** A photometric file that is dropped on the office: 260 candidates beside as many that are known. */
async function photometry() {
  need(inRoot('dist/scenes/office.flux'));
  const times = await dropsOnOffice(root);
  for (const [of, most] of [
    ['picture', 50],
    ['layout', 1000],
  ]) {
    const values = times.map((each) => each[of]).sort((a, b) => a - b);
    const { median, spread } = summary(values);
    const p95 = round(values[Math.ceil(0.95 * values.length) - 1]);
    const row = { unit: 'ms', spread: round(spread, 2), p95, first: round(times[0][of]), wanted: most };
    print({ name: `photometry_to_${of}`, native: null, wasm: round(median), ...row, drops: values.length });
  }
}

/** A wall of the office that is painted lighter and darker, under 260 candidates of one type. */
async function repaint() {
  need(inRoot('dist/scenes/office.flux'));
  const values = (await repaintsOfOffice(root)).sort((a, b) => a - b);
  const { median, spread } = summary(values);
  const p95 = round(values[Math.ceil(0.95 * values.length) - 1]);
  const row = { unit: 'ms', spread: round(spread, 2), p95, wanted: 50, steps: values.length };
  print({ name: 'repaint_to_picture', native: null, wasm: round(median), ...row });
}

/** A first visit to the office on a line of 10 Mbit/s with 40 ms. */
async function first10Mbit() {
  need(inRoot('dist/scenes/office.flux'));
  const visits = await firstVisits(root);
  const row = (name, values, wanted, more = {}) => {
    const { median, spread } = summary(values);
    const [native, wide] = [round(median), round(spread, 2)];
    print({ name, native, unit: 'ms', spread: wide, batches: values.length, wanted, ...more });
  };
  const times = (key) => visits.map((visit) => visit[key]);
  row('first_light_10mbit', times('light'), 2500);
  row('first_answer_10mbit', times('answer'), 6000, { asked: round(summary(times('asked')).median) });
}

const figures = {
  kernels,
  halls,
  solve_25000: solve25000,
  count_strip: countStrip,
  scene_file_e_corridor: () => bytes('scene_file_e_corridor', statSync(need(corridor)).size),
  js_compressed: firstLoad,
  wasm_compressed: () => {
    const file = need(inRoot('web/solver/core.wasm'));
    bytes('wasm_compressed', packed(file), { brotli: packedBest(file) });
  },
  builder_compressed: () => {
    const file = need(inRoot('public/builder/builder.wasm'));
    bytes('builder_compressed', packed(file), { brotli: packedBest(file), wanted: 450e3 });
  },
  scene_file_office: () =>
    bytes('scene_file_office', statSync(need(inRoot('public/scenes/office.flux'))).size),
  first_10mbit: first10Mbit,
  photometry,
  repaint,
  drag_to_layout: drag,
  precompute_e_corridor: precompute,
  precompute_wasm: precomputeWasm,
  drop_to_light: dropped,
};

for (const name of wanted) {
  if (Object.hasOwn(figures, name)) continue;
  process.stderr.write(`bench: no figure "${name}"; there are ${Object.keys(figures).join(', ')}\n`);
  process.exit(2);
}
print(describeRun(root));
for (const [name, measure] of Object.entries(figures)) {
  if (wanted.size === 0 || wanted.has(name)) await measure();
}
mkdirSync(inRoot('build'), { recursive: true });
if (wanted.size === 0) writeFileSync(inRoot('build/bench.jsonl'), `${rows.join('\n')}\n`);

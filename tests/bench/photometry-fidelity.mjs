// Light by the exchange of a scene file against the whole solution, four types of luminaires in the sample rooms,
// twelve single sites and 24 seeded sums of six in each. Prints the table of docs/fidelity.md; exits with 1 where
// a promise is missed. Needs the scene files of `npm run build` and the native photometry_bench.
//
//   node tests/bench/photometry-fidelity.mjs [room...] [--singles 12] [--sums 24]
import { execFileSync } from 'node:child_process';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';

const root = fileURLToPath(new URL('../..', import.meta.url));
const bench = path.join(root, 'build/native/tests/photometry_bench');
const everyRoom = ['e-corridor', 'office', 'classroom', 'gallery', 'box'];

/** At most so many per cent, for 95 of 100 values on walls, floors, ceilings and measuring planes. */
const promises = {
  batwing: { mean: 1, sigma: 6 },
  'cos^4, 60 degrees': { mean: 1, sigma: 8 },
  'cos^20, 30 degrees': { mean: 2.5, sigma: 10 },
  'cos^126, 12 degrees, tilted 30': { mean: 2.5, sigma: 15 },
};
const ofTheRoom = (surface) =>
  /floor|ceiling|wall|plane/i.test(surface) && !/free-standing|whiteboard/i.test(surface);

function quantile(values, share) {
  if (values.length === 0) return 0;
  return values.toSorted((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))];
}

/** Median, 95 of 100 and worst, in per cent. */
const cellOf = (values) =>
  [0.5, 0.95, 1].map((share) => (100 * quantile(values, share)).toFixed(2)).join(' / ');

function rowOf(room, { type, errors }) {
  const promise = promises[type];
  const main = errors.filter((error) => ofTheRoom(error.surface));
  const other = errors.filter((error) => !ofTheRoom(error.surface));
  const cells = [main, other].flatMap((group) =>
    ['mean', 'sigma'].map((statistic) => cellOf(group.map((error) => error[statistic]))),
  );
  const missed = ['mean', 'sigma'].filter(
    (statistic) =>
      100 *
        quantile(
          main.map((error) => error[statistic]),
          0.95,
        ) >
      promise[statistic],
  );
  console.log(`| ${[room, type, ...cells, missed.join(', ') || 'none'].join(' | ')} |`);
  return missed.length;
}

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { singles: { type: 'string', default: '12' }, sums: { type: 'string', default: '24' } },
});
console.log('| room | type | mean | sigma | other surfaces: mean | other surfaces: sigma | missed |');
console.log('| --- | --- | --- | --- | --- | --- | --- |');
let missed = 0;
for (const room of positionals.length > 0 ? positionals : everyRoom) {
  const files = ['glb', 'flux'].map((kind) => path.join(root, `public/scenes/${room}.${kind}`));
  const output = execFileSync(bench, [...files, values.singles, values.sums], {
    maxBuffer: 1 << 28,
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  for (const type of JSON.parse(output)) missed += rowOf(room, type);
}
process.exitCode = missed > 0 ? 1 : 0;

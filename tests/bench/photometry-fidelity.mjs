/**
 * Light by the exchange of a scene file against the whole solution, four types of luminaires in five of the sample rooms,
 * single sites and seeded sums of six in each: the section "Luminaires of photometric files" of docs/fidelity.md, where
 * rooms that are not named keep their rows. Exits with 1 where a promise is missed.
 *
 *   node tests/bench/photometry-fidelity.mjs [room ...]      after `npm run build` and `cmake --build build/native
 *                                                            --target photometry_bench`; the rooms' files are those of
 *                                                            public/scenes
 */
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const bench = path.join(root, 'build/native/tests/photometry_bench');
const singles = 12;
const sums = 24;
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

/** Median, 95 of 100 and worst, in per cent; a dash where the room has no such surface. */
const cellOf = (values) =>
  values.length === 0
    ? '–'
    : [0.5, 0.95, 1].map((share) => (100 * quantile(values, share)).toFixed(2)).join(' / ');

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
  return {
    row: `| ${[room, type, ...cells, missed.join(', ') || 'none'].join(' | ')} |`,
    cause: causeOf(room, type, main),
    misses: missed.length,
  };
}

/** Where the errors of means come from, and on which surface they are largest. */
function causeOf(room, type, errors) {
  const names = [...new Set(errors.map(({ surface }) => surface))];
  const ofSurface = (name) => errors.filter(({ surface }) => surface === name).map(({ mean }) => mean);
  const worst = names.toSorted((a, b) => quantile(ofSurface(b), 0.95) - quantile(ofSurface(a), 0.95))[0];
  const parts = ['direct', 'exchange'].map((part) => cellOf(errors.map((error) => error[part])));
  return `| ${[room, type, ...parts, `${worst}, ${(100 * quantile(ofSurface(worst), 0.95)).toFixed(2)}`].join(' | ')} |`;
}

const title = '## Luminaires of photometric files';
const introduction = `${title}

Made by \`node tests/bench/photometry-fidelity.mjs\`: nothing below is edited by hand.

Light by the exchange of a scene file, as \`fiatlux evaluate\` has it, against the whole solution, as \`fiatlux light\` has it:
${singles} single sites and ${sums} seeded sums of six luminaires of each type, on surfaces above 5 % of the room's mean. Median, 95 of 100
and worst, in per cent; first walls, floor, ceiling and measuring planes, then all other surfaces (furniture, pictures).
Promised of the first, for 95 of 100 values: means 1 % (batwing, cos^4) and 2.5 % (narrower ones), sigmas 6, 8, 10 and 15 %.

| room | type | mean | sigma | other surfaces: mean | other surfaces: sigma | missed |
| --- | --- | --- | --- | --- | --- | --- |
`;

const causes = `
Of the same errors of means, what the direct light has that is made of stored visible shares (a share is of the site's
square, its shadows as soft; lumens that leave a smaller luminaire arrive, within 0.3 %: core/transport/shadow_balance.h),
and what is left where direct light is true; and the surface with the largest 95 of 100. The rays that "true" direct light
is made of keep the lumens of a 12 degree beam within 0.2 %.

| room | type | direct light | exchange | surface |
| --- | --- | --- | --- | --- |
`;

const document = path.join(root, 'docs/fidelity.md');
const before = existsSync(document) ? readFileSync(document, 'utf8') : '';
const start = before.indexOf(title);
const kept = start < 0 ? [] : before.slice(start).split('\n');
const asked = process.argv.slice(2);
let missed = 0;
const rows = [];
const reasons = [];
/** Of the table with so many columns. */
const keptOf = (room, cells) =>
  kept.filter((line) => line.startsWith(`| ${room} |`) && line.split('|').length === cells + 2);
for (const room of everyRoom) {
  if (asked.length > 0 && !asked.includes(room)) {
    rows.push(...keptOf(room, 7));
    reasons.push(...keptOf(room, 5));
    continue;
  }
  const files = ['glb', 'flux'].map((kind) => path.join(root, `public/scenes/${room}.${kind}`));
  const output = execFileSync(bench, [...files, `${singles}`, `${sums}`], {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  for (const type of JSON.parse(output)) {
    const { row, cause, misses } = rowOf(room, type);
    console.log(row);
    rows.push(row);
    reasons.push(cause);
    missed += misses;
  }
}
writeFileSync(
  document,
  `${(start < 0 ? before : before.slice(0, start)).trimEnd()}\n\n${introduction}${rows.join('\n')}\n${causes}${reasons.join('\n')}\n`,
);
process.exitCode = missed > 0 ? 1 : 0;

/**
 * How far luminaires walk when little is asked anew, and how many of them when one is moved by hand: the office, fifteen
 * luminaires, with and without a least distance. `node tests/bench/steadiness.mjs` prints a JSON line each; needs the
 * sample rooms and the Wasm solver.
 */
import path from 'node:path';
import { inflateSync } from 'node:zlib';
import { openSession, wishOf } from './open-session.mjs';

const root = path.resolve(import.meta.dirname, '../..');
const enough = 300_000; // evaluations of a search that settles

const session = await openSession(
  path.join(root, 'web/solver/core.wasm'),
  path.join(root, 'public/scenes/office.flux'),
  inflateSync,
);
const { sitePosition } = session.info();

const asked = (least, minDistance, pinned = []) =>
  wishOf(session, {
    luminaires: { count: 15, flux: 4000, pinned, minDistance },
    goals: [{ statistic: 'sigma', sense: 'min', weight: 1, surfaces: ['working plane'] }],
    constraints: [{ statistic: 'mean', min: least, surfaces: ['working plane'] }],
  });

const distance = (a, b) =>
  Math.hypot(...[0, 1, 2].map((axis) => sitePosition[3 * a + axis] - sitePosition[3 * b + axis]));

const fail = (error) => {
  if (error) throw new Error(error);
};

/** From `start`, where some of its luminaires have been `moved`: those beside them follow, no others. */
function solved(wish, start, moved) {
  fail(session.setIntentions(wish));
  const from = start && [start.sites, start.flux, start.dimming];
  if (moved) fail(session.startNear(1, ...from, moved));
  else fail(from ? session.startFrom(1, ...from) : session.start(1));
  session.advance(enough);
  return session.incumbent();
}

/** Mean way of a luminaire by its number, m, and how many have gone at all. */
function walked(from, to) {
  const ways = [...to.sites].map((site, i) => distance(site, from.sites[i]));
  return {
    mean: ways.reduce((sum, way) => sum + way, 0) / ways.length,
    moved: ways.filter((way) => way > 0).length,
  };
}

/** One luminaire on the free site that is nearest to its own; null where none is within half a metre more than a step. */
function nudged({ sites, flux, dimming }, luminaire, minDistance) {
  const from = sites[luminaire];
  const others = [...sites].filter((_, i) => i !== luminaire);
  const isFree = (site) => others.every((other) => other !== site && distance(site, other) >= minDistance);
  const free = [...Array(sitePosition.length / 3).keys()].filter((site) => site !== from && isFree(site));
  free.sort((a, b) => distance(a, from) - distance(b, from));
  const [to] = free;
  if (to === undefined || distance(to, from) > 1.2) return null;
  return { sites: sites.map((site, i) => (i === luminaire ? to : site)), flux, dimming };
}

const tell = (row) => process.stdout.write(`${JSON.stringify(row)}\n`);
const rounded = (value) => Number(value.toFixed(4));

for (const minDistance of [1.8, 0]) {
  // As in the room: a bound of 500 lx that binds.
  const first = solved(asked(500, minDistance));
  let before = first;
  for (const least of [505, 500]) {
    const shown = solved(asked(least, minDistance), before.layout);
    const { mean, moved } = walked(before.layout, shown.layout);
    tell({
      name: 'bound_moved',
      minDistance,
      least,
      walked: rounded(mean),
      moved,
      sigma: rounded(shown.goals[0]),
      reached: rounded(shown.constraints[0]),
    });
    before = shown;
  }

  // Some luminaires one site on, to the nearest free one.
  for (const luminaire of [0, 4, 8, 12]) {
    const start = nudged(first.layout, luminaire, minDistance);
    if (!start) continue;
    const wish = asked(500, minDistance, [start.sites[luminaire]]);
    const near = solved(wish, start, Uint32Array.of(luminaire));
    const free = solved(wish, start);
    const { moved } = walked(start, near.layout);
    tell({
      name: 'nudged',
      minDistance,
      luminaire: `L${luminaire + 1}`,
      followers: moved,
      others: walked(start, free.layout).moved,
      sigma: rounded(near.goals[0]),
      behind: rounded(near.goals[0] / free.goals[0] - 1),
      reached: rounded(near.constraints[0]),
    });
  }
}
session.delete();

// How far luminaires of the office walk when hardly anything else is asked, and how well four make up for one that is moved.
// Covers core/search/identity, steady and near_search as the page runs them; tests/bench/steadiness.mjs measures more of it.
import path from 'node:path';
import { expect, test } from '@jest/globals';
import { coreIntentions } from '../../web/solver/core-intentions.ts';
import type { CoreLayout, CoreShown, Session } from '../../web/solver/core.ts';
import type { Intentions } from '../../web/document/types.ts';
import { bytesOf, loadBuiltCore, openFile, root } from './solver-module.ts';

const core = await loadBuiltCore();
const plane = 'working plane';
const count = 15;
const enough = 300_000; // evaluations of a search that settles

const asked = (min: number, pinned: readonly number[] = []): Intentions => ({
  luminaires: { count, flux: 4000, dimming: [1, 1], pinned, excluded: [], minDistance: 0 },
  goals: [{ statistic: 'sigma', sense: 'min', weight: 1, surfaces: [plane] }],
  constraints: [{ statistic: 'mean', min, surfaces: [plane] }],
  quantity: 'illuminance',
});

const session: Session = new core.Session();
openFile(session, bytesOf(path.join(root, 'public/scenes/office.flux')));
const { sitePosition, siteSize, surfaces } = session.info()!;

function distance(a: number, b: number): number {
  return Math.hypot(...[0, 1, 2].map((axis) => sitePosition[3 * a + axis]! - sitePosition[3 * b + axis]!));
}

const ways = (from: CoreLayout, to: CoreLayout) =>
  Array.from(to.sites, (site, i) => distance(site, from.sites[i]!));

/** From a layout, or from nowhere; where one of its luminaires was `moved`, only those beside it follow. */
function solved(wish: Intentions, from?: CoreLayout, moved?: number, evaluations = enough): CoreShown {
  expect(session.setIntentions(coreIntentions(wish, surfaces))).toBe('');
  const start = from && ([from.sites, from.flux, from.dimming] as const);
  if (start && moved !== undefined) expect(session.startNear(1, ...start, Uint32Array.of(moved))).toBe('');
  else expect(start ? session.startFrom(1, ...start) : session.start(1)).toBe('');
  session.advance(evaluations);
  const shown = session.incumbent();
  if (typeof shown === 'string') throw new Error(shown);
  return shown;
}

const first = solved(asked(500)).layout;

test('from 500 to 505 lx luminaires walk 0.6 m on average at most, by their tags', () => {
  const after = ways(first, solved(asked(505), first).layout);
  expect(after.reduce((sum, way) => sum + way, 0) / count).toBeLessThan(0.6);
});

/** The least sigma that any four of the others reach together, the rest held. */
function bestOfFour(start: CoreLayout, moved: number): number {
  const others = Array.from(start.sites.keys()).filter((i) => i !== moved);
  let best = Infinity;
  const choose = (followers: readonly number[], from: number): void => {
    if (followers.length < 4)
      return others.forEach((i, k) => void (k >= from && choose([...followers, i], k + 1)));
    const held = [...start.sites].filter((_, i) => !followers.includes(i));
    const sites = Uint32Array.from([...held, ...followers.map((i) => start.sites[i]!)]);
    const { constraints, goals } = solved(asked(500, held), { ...start, sites }, undefined, 10_000);
    if (constraints[0]! > 499.9) best = Math.min(best, goals[0]!);
  };
  choose([], 0);
  return best;
}

test('one that is moved by a site is made up for by four at most, as well as any four could', () => {
  const moved = 12;
  const taken = new Set(first.sites);
  const [to] = [...siteSize.keys()]
    .filter((site) => !taken.has(site))
    .sort((a, b) => distance(a, first.sites[moved]!) - distance(b, first.sites[moved]!));
  const start = { ...first, sites: first.sites.map((site, i) => (i === moved ? to! : site)) };
  const near = solved(asked(500, [to!]), start, moved);
  expect(ways(start, near.layout).filter((way) => way > 0).length).toBeLessThanOrEqual(4);
  expect(near.constraints[0]).toBeGreaterThan(499.9);
  // note: of these four; when all fifteen may walk, thirteen do, and reach 3 % less.
  expect(near.goals[0]! / bestOfFour(start, moved)).toBeLessThan(1.01);
});

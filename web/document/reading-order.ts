/** Luminaires as a plan is read: row by row from the north, each from the west. */
import { inPlan, type PlanFrame } from './plan-frame.ts';
import { positionOf } from './sites.ts';
import type { Layout, SceneInfo } from './types.ts';

const aRow = 0.3; // m: so far apart to the south luminaires still hang in one row

/** Which luminaire comes first, second ... */
export function readingOrder(layout: Layout, sites: SceneInfo['sites'], frame: PlanFrame): number[] {
  const places = layout.sites.map((site) => inPlan(frame, positionOf(sites, site)));
  const fromNorth = [...places.keys()].sort((a, b) => places[b]![1] - places[a]![1]);
  const rowOf = new Map<number, number>();
  let [row, north] = [-1, Infinity];
  for (const luminaire of fromNorth) {
    const y = places[luminaire]![1];
    if (north - y > aRow) [row, north] = [row + 1, y];
    rowOf.set(luminaire, row);
  }
  return fromNorth.sort((a, b) => rowOf.get(a)! - rowOf.get(b)! || places[a]![0] - places[b]![0] || a - b);
}

/** Are they numbered so already? */
export const isInOrder = (order: readonly number[]): boolean =>
  order.every((luminaire, i) => luminaire === i);

/** The same luminaires under other numbers. */
export function renumbered(layout: Layout, order: readonly number[]): Layout {
  const { sites, flux, ties, mountings } = layout;
  const ordered = <T>(list: readonly T[]): T[] => order.map((luminaire) => list[luminaire]!);
  return {
    ...layout,
    sites: ordered(sites),
    flux: ordered(flux),
    ...(ties && { ties: ordered(ties) }),
    ...(mountings && { mountings: ordered(mountings) }),
  };
}

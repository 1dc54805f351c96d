/** Sites of a scene as positions in the room: exports speak in positions, the core in sites. */
import type { SceneInfo } from './types.ts';

type Sites = SceneInfo['sites'];

export function siteCount(sites: Sites): number {
  return sites.size.length;
}

export function positionOf(sites: Sites, site: number): [number, number, number] {
  const at = (axis: number) => sites.position[3 * site + axis] ?? Number.NaN;
  return [at(0), at(1), at(2)];
}

export function distance(a: readonly number[], b: readonly number[]): number {
  return Math.hypot(...a.map((value, axis) => value - (b[axis] ?? 0)));
}

/** The site nearest to a point that is not taken, and how far away it is (m); -1 where there is none. */
export function nearestSite(
  sites: Sites,
  point: readonly number[],
  taken: ReadonlySet<number> = new Set(),
): { site: number; distance: number } {
  let best = { site: -1, distance: Infinity };
  for (let site = 0; site < siteCount(sites); site++) {
    if (taken.has(site)) continue;
    const away = distance(positionOf(sites, site), point);
    if (away < best.distance) best = { site, distance: away };
  }
  return best;
}

/**
 * Which site a hand means: the free one nearest to the ray through the pointer, or the next one in a direction.
 * Distances across the ray are divided by those along it, so "nearest" is nearest on the screen.
 */
import { tiedTo } from '../../document/ties.ts';
import type { Layout } from '../../document/types.ts';

type Point = readonly [number, number, number];

const pointOf = (positions: ArrayLike<number>, site: number): [number, number, number] => [
  positions[3 * site]!,
  positions[3 * site + 1]!,
  positions[3 * site + 2]!,
];

/**
 * The free site nearest to a ray (unit direction), or null when there is none in front of the eye.
 * `positions`: three a site, m. `orthographic`: rays are parallel, so depth does not shrink distances.
 */
export function nearestFreeSite(
  positions: ArrayLike<number>,
  taken: ReadonlySet<number>,
  origin: Point,
  direction: Point,
  orthographic = false,
): number | null {
  let best: number | null = null;
  let bestDistance = Infinity;
  for (let site = 0; site < positions.length / 3; site++) {
    if (taken.has(site)) continue;
    const offset = pointOf(positions, site).map((value, i) => value - origin[i]!);
    const along = offset.reduce((sum, value, i) => sum + value * direction[i]!, 0);
    if (!orthographic && along <= 0) continue;
    const across = Math.hypot(...offset.map((value, i) => value - along * direction[i]!));
    const distance = orthographic ? across : across / along;
    if (distance < bestDistance) [best, bestDistance] = [site, distance];
  }
  return best;
}

/**
 * The next free site from `site` in a direction (any length), preferring what lies straight ahead; null when there
 * is none within 60 degrees.
 */
export function nextFreeSite(
  positions: ArrayLike<number>,
  taken: ReadonlySet<number>,
  site: number,
  direction: Point,
): number | null {
  const from = pointOf(positions, site);
  const length = Math.hypot(...direction);
  let best: number | null = null;
  let bestCost = Infinity;
  for (let other = 0; other < positions.length / 3; other++) {
    if (other === site || taken.has(other)) continue;
    const offset = pointOf(positions, other).map((value, i) => value - from[i]!);
    const distance = Math.hypot(...offset);
    const along = offset.reduce((sum, value, i) => sum + value * direction[i]!, 0) / length;
    if (along < 0.5 * distance) continue;
    const across = Math.sqrt(Math.max(0, distance * distance - along * along));
    const cost = along + 2 * across;
    if (cost < bestCost) [best, bestCost] = [other, cost];
  }
  return best;
}

/** Sites where luminaires in the hand may not go: the excluded ones and those of the others that do not move with them. */
export function takenSites(
  layout: Pick<Layout, 'sites' | 'ties'>,
  held: readonly number[],
  excluded: Iterable<number>,
): Set<number> {
  const taken = new Set(excluded);
  const together = new Set(tiedTo(layout, held));
  layout.sites.forEach((site, other) => !together.has(other) && taken.add(site));
  return taken;
}

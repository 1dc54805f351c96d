/**
 * Luminaires that move together: rows and fields as they are, without turning, a mirrored pair in the mirror; and those
 * that are selected together with all that are tied to them.
 */
import { isOfSquares } from './intentions.ts';
import type { Arrangement, Layout, Luminaires, PlanAxis, Rule } from './types.ts';

/** What a row has at least where nothing is said of it, as in intentions.json. */
export const usualInRow = 3;

const samePlace = 0.02; // m

/** The same rule with less asked of its axis, the nearest first: nine places of twenty by thirteen have one middle, not two. */
export function easedAxes(arrangement: Arrangement | undefined): readonly Arrangement[] {
  if (arrangement?.axis === undefined) return [];
  const { axis, ...anyhow } = arrangement;
  const single = axis === 'both' ? (['x', 'z'] as const).map((one) => ({ ...anyhow, axis: one })) : [];
  return [...single, anyhow];
}

/**
 * Whether the numbers that are asked for of luminaire types leave no layout under the rule, wherever luminaires may hang: a
 * row, or a field as a whole, is of one type, so each type has some whole rows within its numbers.
 */
export function typesRuleOut(luminaires: Luminaires): boolean {
  if (isOfSquares(luminaires)) return false;
  const { types = [], ofType = [], count, most = count, arrangement } = luminaires;
  const ranges = types
    .filter(({ isAllowed }) => isAllowed)
    .map(({ id, count: [least, high] }) => [
      Math.max(least, ofType.filter((each) => each === id).length),
      high,
    ]);
  const isPossible = (number: number, tied: number) => {
    if (number % tied !== 0) return false;
    const whole = ranges.map(([low = 0, high = 0]) => [
      tied * Math.ceil(low / tied),
      tied * Math.floor(Math.min(high, number) / tied),
    ]);
    const sum = (end: 0 | 1) => whole.reduce((all, ends) => all + ends[end]!, 0);
    const fits = whole.every(([low = 0, high = 0]) => low <= high);
    return fits && sum(0) <= number && number <= sum(1);
  };
  const least = Math.min(arrangement?.leastInRow ?? usualInRow, most);
  const tiedIn = (number: number): readonly number[] => {
    if (arrangement?.rule === 'field') return [number];
    return arrangement?.rule === 'rows' ? countedFrom(least, number) : [1];
  };
  return !countedFrom(count, most).some((number) => tiedIn(number).some((tied) => isPossible(number, tied)));
}

const countedFrom = (low: number, high: number): number[] =>
  Array.from({ length: Math.max(0, high - low + 1) }, (_, i) => low + i);

type Tied = Pick<Layout, 'sites' | 'ties'>;

/** The luminaires of the tie that one belongs to, itself included. */
export function tieOf({ sites, ties }: Tied, luminaire: number): number[] {
  if (!ties) return [luminaire];
  return [...sites.keys()].filter((other) => ties[other] === ties[luminaire]);
}

/** Some luminaires and all that are tied to them, in their order. */
export function tiedTo(layout: Tied, luminaires: readonly number[]): number[] {
  return [...new Set(luminaires.flatMap((each) => tieOf(layout, each)))].sort((a, b) => a - b);
}

/** What a hand on one luminaire has in it: all that are selected where it is one of them, else it alone. */
export function inHand(luminaire: number, selected: readonly number[]): readonly number[] {
  return selected.includes(luminaire) ? selected : [luminaire];
}

/** Those that a hand on some of them holds, by their places: a mirrored pair is held by either. */
export function heldTogether(layout: Tied, luminaires: readonly number[], rule: Rule): number[] {
  return rule === 'rows' || rule === 'field' ? tiedTo(layout, luminaires) : [...luminaires];
}

/**
 * The sites of a layout after a luminaire has gone to `site`, and with it all that is in the hand (`selected`, where it is
 * one of them), their rows or their field; null where there is no place for all of them. Mirror images go the mirrored way
 * where they can, and else stay, for the search to place. `positions`: three a site, m.
 */
export function movedSites(
  layout: Tied,
  luminaire: number,
  site: number,
  rule: Rule,
  positions: ArrayLike<number>,
  selected: readonly number[] = [],
): number[] | null {
  const { sites } = layout;
  const from = sites[luminaire];
  if (from === undefined) return null;
  const placeOf = (of: number) => [0, 1, 2].map((axis) => positions[3 * of + axis] ?? NaN);
  const [start, end] = [placeOf(from), placeOf(site)];
  const way = end.map((value, axis) => value - start[axis]!);
  const held = inHand(luminaire, selected);
  const next = [...sites];
  for (const other of heldTogether(layout, held, rule)) {
    const place = placeOf(sites[other] ?? from).map((value, axis) => value + way[axis]!);
    const to = other === luminaire ? site : siteAt(positions, place);
    if (to === null) return null;
    next[other] = to;
  }
  if (new Set(next).size < next.length) return null;
  return rule === 'symmetric' ? withImages(layout, held, way, next, positions) : next;
}

/** About which lines a field in the middle of its places is still mirrored where it has gone some way (x, y, z, m). */
export function axisAfter(axis: PlanAxis, way: readonly number[]): PlanAxis {
  const hasGone = (along: 0 | 2) => Math.abs(way[along] ?? 0) > samePlace;
  const isAboutX = (axis === 'x' || axis === 'both') && !hasGone(2); // a line along x
  const isAboutZ = (axis === 'z' || axis === 'both') && !hasGone(0);
  if (isAboutX && isAboutZ) return 'both';
  return isAboutX ? 'x' : isAboutZ ? 'z' : 'found';
}

/** Also with the mirror images of those that have gone, where they find places. */
function withImages(
  layout: Tied,
  gone: readonly number[],
  way: readonly number[],
  sites: readonly number[],
  positions: ArrayLike<number>,
): number[] {
  const next = [...sites];
  for (const luminaire of gone)
    for (const image of tieOf(layout, luminaire)) {
      if (gone.includes(image)) continue;
      const [own, there] = [layout.sites[luminaire]!, layout.sites[image]!];
      const place = way.map((step, axis) => {
        const at = positions[3 * there + axis] ?? NaN;
        return Math.abs(at - (positions[3 * own + axis] ?? NaN)) > samePlace ? at - step : at + step;
      });
      const to = siteAt(positions, place);
      if (to !== null && !next.includes(to)) next[image] = to;
    }
  return next;
}

function siteAt(positions: ArrayLike<number>, place: readonly number[]): number | null {
  for (let site = 0; site < positions.length / 3; site++)
    if (place.every((value, a) => Math.abs((positions[3 * site + a] ?? NaN) - value) < samePlace))
      return site;
  return null;
}

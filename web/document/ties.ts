/** Luminaires that move together: rows and fields as they are, without turning; a mirrored pair is the search's business. */
import type { Layout, Rule } from './types.ts';

const samePlace = 0.02; // m

/** The luminaires of the tie that one belongs to, itself included. */
export function tieOf({ sites, ties }: Pick<Layout, 'sites' | 'ties'>, luminaire: number): number[] {
  if (!ties) return [luminaire];
  return [...sites.keys()].filter((other) => ties[other] === ties[luminaire]);
}

/** Those that a hand on one of them holds, by their places: a mirrored pair is held by either. */
export function heldTogether(
  layout: Pick<Layout, 'sites' | 'ties'>,
  luminaire: number,
  rule: Rule,
): number[] {
  return rule === 'rows' || rule === 'field' ? tieOf(layout, luminaire) : [luminaire];
}

/**
 * The sites of a layout after a luminaire has gone to `site`, and its row or field with it; null where there is no place
 * for all of them. `positions`: three a site, m.
 */
export function movedSites(
  layout: Pick<Layout, 'sites' | 'ties'>,
  luminaire: number,
  site: number,
  rule: Rule,
  positions: ArrayLike<number>,
): number[] | null {
  const { sites } = layout;
  const from = sites[luminaire];
  if (from === undefined) return null;
  const together = heldTogether(layout, luminaire, rule);
  const placeOf = (of: number, axis: number) => positions[3 * of + axis] ?? NaN;
  const shifted = (of: number) => [0, 1, 2].map((a) => placeOf(of, a) + placeOf(site, a) - placeOf(from, a));
  const next = [...sites];
  for (const other of together) {
    const to = other === luminaire ? site : siteAt(positions, shifted(sites[other] ?? from));
    if (to === null) return null;
    next[other] = to;
  }
  return new Set(next).size === next.length ? next : null;
}

function siteAt(positions: ArrayLike<number>, place: readonly number[]): number | null {
  for (let site = 0; site < positions.length / 3; site++)
    if (place.every((value, a) => Math.abs((positions[3 * site + a] ?? NaN) - value) < samePlace))
      return site;
  return null;
}

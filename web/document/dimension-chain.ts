/**
 * What an installer measures by: in each direction of the plan a chain of distances from wall to luminaire, from
 * luminaire to luminaire and to the wall again. Luminaires of one row or column share a stop.
 */
import type { Point2, Point3, PlanFrame } from './plan-frame.ts';

export interface Stop {
  readonly at: number; // m from the corner, to the centimetre: the distances add up as they are written
  readonly from: number | null; // where across the chain its nearest luminaire is, m; null at a wall
}

const centimetre = (metres: number): number => Math.round(metres * 100) / 100;

/** Stops along an axis (0 = x, 1 = y), ascending, walls included. */
export function chainOf(places: readonly (Point2 | Point3)[], { size }: PlanFrame, axis: 0 | 1): Stop[] {
  const stops = new Map<number, number | null>([
    [0, null],
    [centimetre(size[axis]), null],
  ]);
  for (const place of places) {
    const [at, from] = [centimetre(place[axis]), place[1 - axis]!];
    const there = stops.get(at);
    if (there === undefined || (there !== null && from < there)) stops.set(at, from);
  }
  return [...stops].map(([at, from]) => ({ at, from })).sort((a, b) => a.at - b.at);
}

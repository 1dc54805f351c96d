/**
 * Coordinates as designers read them: x to the east and y to the north in plan, from the south-west corner of the
 * floor, z up from the floor. The room's own axes (glTF: x east, y up, z south) become these here and nowhere else.
 */
import { fixed, listed } from '../language/numbers.ts';

export type Point2 = readonly [x: number, y: number]; // m, in plan
export type Point3 = readonly [x: number, y: number, z: number]; // m

/** The sides of a room, as directions in its own axes. */
export const compass = {
  east: [1, 0, 0],
  west: [-1, 0, 0],
  south: [0, 0, 1],
  north: [0, 0, -1],
} as const satisfies Record<string, Point3>;
export type Side = keyof typeof compass;
export const sides = Object.keys(compass) as Side[];

export const isSameWay = (a: Point3, b: Point3): boolean =>
  a.every((value, i) => Math.abs(value - (b[i] ?? 0)) < 1e-6);

/** Towards which side a unit vector points; null where between two. */
export const sideOf = (direction: Point3): Side | null =>
  sides.find((side) => isSameWay(compass[side], direction)) ?? null;

/** Where the corner of the floor lies in the room's own axes, and how far the room reaches from it. */
export interface PlanFrame {
  readonly west: number; // x of the west side, m
  readonly south: number; // z of the south side, m
  readonly floor: number; // y of the floor, m
  readonly size: Point3; // east, north, up, m
}

/** The room in plan; lengths in metres from the corner. */
export interface RoomPlan {
  readonly frame: PlanFrame;
  readonly outlines: readonly (readonly Point2[])[]; // closed loops of the floor, the largest first
  readonly furniture: readonly (readonly [Point2, Point2])[]; // edges of what stands in the room
}

export function inPlan({ west, south, floor }: PlanFrame, [x, y, z]: Point3): [number, number, number] {
  return [x - west, south - z, y - floor];
}

/** The inverse of inPlan. */
export function inRoom({ west, south, floor }: PlanFrame, [x, y, z]: Point3): [number, number, number] {
  return [west + x, floor + z, south - y];
}

/** The rectangle about the floor, in the room's axes: the smaller x and z, then the larger ones. */
export function areaOf({ west, south, size: [east, north] }: PlanFrame): [number, number, number, number] {
  return [west, south - north, west + east, south];
}

/** "3.20, 1.60, 2.80": for tables, to the centimetre, as the page writes numbers. */
export function placeText(place: Point3): string {
  return listed(place.map((value) => fixed(Math.round(value * 100) / 100 + 0, 2)));
}

/** Twice the area that a loop runs around, positive where it runs counter-clockwise. */
export function twiceArea(loop: readonly Point2[]): number {
  return loop.reduce((sum, [x, y], i) => {
    const [nextX, nextY] = loop[(i + 1) % loop.length]!;
    return sum + x * nextY - nextX * y;
  }, 0);
}

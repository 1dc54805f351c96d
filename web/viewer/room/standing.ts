/**
 * What hangs on the walls and the ceiling of a room, and what stands in it. A part that touches something standing
 * stands with it: the back of a sofa, the doors of a cabinet and the monitors on a desk are not cut away with the wall
 * behind them.
 */
import type { Box } from '../eye/framing.ts';

const thickness = 0.3; // m: what is flatter may hang on a wall
const reach = 0.35; // m: so near to the side of the room's box it does
const board = 0.15; // m: what begins at the floor and is flatter belongs to the wall (a door), not to the furniture
const raised = 0.1; // m above the floor: what begins higher is carried by something
const touch = 0.02; // m: boxes as near as this touch
const pile = 0.05; // m above the floor: a rug is no higher
const wide = 0.6; // of the room: what is larger along two axes is the room itself, and carries nothing

/** The side of the room's box that a thing hangs on: axis 0..2 and +1 (high) or -1 (low). */
export interface Side {
  readonly axis: 0 | 1 | 2;
  readonly sign: 1 | -1;
}

const extent = (box: Box, axis: 0 | 1 | 2): number => box.max[axis] - box.min[axis];

/** On which upright side of the room, or on its ceiling, a thing lies; null = away from all, or on the floor. */
export function nearSide(room: Box, thing: Box): Side | null {
  for (const axis of [0, 2, 1] as const) {
    if (extent(thing, axis) > thickness) continue;
    if (room.max[axis] - thing.max[axis] < reach && room.max[axis] - thing.min[axis] < thickness + reach)
      return { axis, sign: 1 };
    if (axis !== 1 && thing.min[axis] - room.min[axis] < reach) return { axis, sign: -1 };
  }
  return null;
}

/** Whether a hung thing vanishes from the plan with the wall that carries it; a shelf that stands at the wall stays. */
export function leavesPlan(room: Box, thing: Box, { axis }: Side): boolean {
  return axis === 1 || thing.min[1] - room.min[1] > raised || extent(thing, axis) < board;
}

/** Whether a thing covers the floor like a rug: light is measured on it, for none reaches the floor below. */
export const isRug = (room: Box, thing: Box): boolean => thing.max[1] - room.min[1] < pile;

function touches(a: Box, b: Box): boolean {
  return ([0, 1, 2] as const).every(
    (axis) => a.min[axis] <= b.max[axis] + touch && b.min[axis] <= a.max[axis] + touch,
  );
}

/** Floor, walls, ceiling: what spans most of the room along two axes. */
export const isRoomItself = (room: Box, part: Box): boolean =>
  ([0, 1, 2] as const).filter((axis) => extent(part, axis) > wide * extent(room, axis)).length > 1;

/** For each part (its box in world space) the side that it hangs on; null = it stands in the room. */
export function hangingSides(room: Box, parts: readonly Box[]): (Side | null)[] {
  const sides = parts.map((part) => nearSide(room, part));
  const isRoom = parts.map((part) => isRoomItself(room, part));
  const onFloor = parts.map((part) => part.min[1] - room.min[1] < raised);
  const isBoard = parts.map((part, i) => onFloor[i]! && sides[i] && extent(part, sides[i]!.axis) < board);
  const stands = parts.map((_, i) => onFloor[i]! && !isRoom[i] && !isBoard[i]);
  carry(parts, stands, (i) => !isRoom[i], (i) => !isBoard[i]); // prettier-ignore
  return sides.map((side, i) => (stands[i] ? null : side));
}

/**
 * Adds to what `stands` what it touches, what that touches, and so on, of all that `mayStand`; what does not carry others
 * ends it.
 */
export function carry(
  parts: readonly Box[],
  stands: boolean[],
  mayStand: (part: number) => boolean,
  carries: (part: number) => boolean,
): void {
  // Sorted by x, so that few pairs are compared.
  const order = [...parts.keys()].filter(mayStand).sort((i, k) => parts[i]!.min[0] - parts[k]!.min[0]);
  const longest = order.reduce((most, i) => Math.max(most, extent(parts[i]!, 0)), 0);
  const front = order.filter((i) => stands[i]);
  while (front.length > 0) {
    const carrier = parts[front.pop()!]!;
    let at = firstFrom(order, parts, carrier.min[0] - longest - touch);
    for (; at < order.length && parts[order[at]!]!.min[0] <= carrier.max[0] + touch; at++) {
      const i = order[at]!;
      if (stands[i] || !touches(carrier, parts[i]!)) continue;
      stands[i] = true;
      if (carries(i)) front.push(i);
    }
  }
}

/** The first place in `order` whose part begins at `x` or beyond. */
function firstFrom(order: readonly number[], parts: readonly Box[], x: number): number {
  let [low, high] = [0, order.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (parts[order[middle]!]!.min[0] < x) low = middle + 1;
    else high = middle;
  }
  return low;
}

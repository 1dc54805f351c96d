/**
 * Cut-away: walls between the eye and the room vanish by themselves, being one-sided and seen from behind. What
 * hangs on such a wall (frames, boards, sills, doors) has sides of its own and is hidden here with its wall.
 */
import { Box3, type Camera, type Object3D, type OrthographicCamera } from 'three';
import type { Box } from '../eye/framing.ts';
import { connectedParts } from './mesh-parts.ts';

const thickness = 0.3; // m: what is flatter may hang on a wall
const reach = 0.35; // m: so near to the side of the room's box it does
const board = 0.15; // m: what stands on the floor and is flatter belongs to the wall (a door), not to the furniture
const raised = 0.1; // m above the floor: what begins higher is carried by the wall

/** The side of the room's box that a thing hangs on: axis 0..2 and +1 (high) or -1 (low). */
export interface Side {
  readonly axis: 0 | 1 | 2;
  readonly sign: 1 | -1;
}

/** On which upright side of the room, or on its ceiling, a thing hangs; null = it stands in the room, or lies on the floor. */
export function hangingSide(room: Box, thing: Box): Side | null {
  for (const axis of [0, 2, 1] as const) {
    if (thing.max[axis] - thing.min[axis] > thickness) continue;
    if (room.max[axis] - thing.max[axis] < reach && room.max[axis] - thing.min[axis] < thickness + reach)
      return { axis, sign: 1 };
    if (axis !== 1 && thing.min[axis] - room.min[axis] < reach) return { axis, sign: -1 };
  }
  return null;
}

/** Whether a hung thing vanishes from the plan with the wall that carries it; a shelf that stands at the wall stays. */
export function leavesPlan(room: Box, thing: Box, { axis }: Side): boolean {
  return axis === 1 || thing.min[1] - room.min[1] > raised || thing.max[axis] - thing.min[axis] < board;
}

/** Whether an eye looks at a side of the room from outside. */
export function isOutside(room: Box, side: Side, eye: readonly number[]): boolean {
  const at = eye[side.axis]!;
  return side.sign > 0 ? at > room.max[side.axis] : at < room.min[side.axis];
}

/** Box of some triangles (first indices) of a mesh whose positions are in world space. */
function boxOf(triangles: readonly number[], index: ArrayLike<number>, positions: ArrayLike<number>): Box {
  const min: [number, number, number] = [Infinity, Infinity, Infinity];
  const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (const first of triangles)
    for (let corner = first; corner < first + 3; corner++)
      for (let i = 0; i < 3; i++) {
        const value = positions[3 * index[corner]! + i]!;
        if (value < min[i]!) min[i] = value;
        if (value > max[i]!) max[i] = value;
      }
  return { min, max };
}

/**
 * Splits a mesh that hangs on several walls (the frames of all pictures, say) into one list of indices a side, and
 * one for the rest; null when there is nothing to split. `positions` in world space.
 */
export function splitBySide(
  room: Box,
  index: ArrayLike<number>,
  positions: ArrayLike<number>,
): number[][] | null {
  const groups = new Map<string, number[]>();
  for (const part of connectedParts(index, positions)) {
    const side = hangingSide(room, boxOf(part, index, positions));
    const key = side ? `${side.axis} ${side.sign}` : '';
    const group = groups.get(key) ?? [];
    groups.set(key, group);
    for (const first of part) group.push(index[first]!, index[first + 1]!, index[first + 2]!);
  }
  return groups.size > 1 ? [...groups.values()] : null;
}

export class CutAway {
  #room: Box | null = null;
  #hung: { readonly object: Object3D; readonly side: Side; readonly leavesPlan: boolean }[] = [];

  /** Finds what hangs on the walls among the objects; `room`: the box of what carries the walls. */
  setRoom(room: Box | null, objects: readonly Object3D[]): void {
    this.#room = room;
    this.#hung = [];
    for (const object of room ? objects : []) {
      const bounds = new Box3().setFromObject(object);
      const thing = { min: bounds.min.toArray(), max: bounds.max.toArray() };
      const side = hangingSide(room!, thing);
      if (side) this.#hung.push({ object, side, leavesPlan: leavesPlan(room!, thing, side) });
    }
  }

  /** Hides and shows what hangs on walls for this eye. */
  update(camera: Camera, on: boolean): void {
    const plan = (camera as OrthographicCamera).isOrthographicCamera === true;
    const eye = camera.position.toArray();
    for (const { object, side, leavesPlan: leaves } of this.#hung)
      object.visible = !(on && (plan ? leaves : isOutside(this.#room!, side, eye)));
  }
}

/**
 * Cut-away: walls between the eye and the room vanish by themselves, being one-sided and seen from behind. What
 * hangs on such a wall (frames, boards, sills, doors) has sides of its own and is hidden here with its wall.
 */
import { Box3, type Camera, type Object3D, type OrthographicCamera } from 'three';
import type { Box } from '../eye/framing.ts';
import { leavesPlan, type Side } from './standing.ts';

/** Whether an eye looks at a side of the room from outside. */
export function isOutside(room: Box, side: Side, eye: readonly number[]): boolean {
  const at = eye[side.axis]!;
  return side.sign > 0 ? at > room.max[side.axis] : at < room.min[side.axis];
}

export class CutAway {
  #room: Box | null = null;
  #hung: { readonly object: Object3D; readonly side: Side; readonly leavesPlan: boolean }[] = [];

  /** `hanging`: what hangs on the walls, each with its side; `room`: the box of what carries the walls. */
  setRoom(room: Box | null, hanging: ReadonlyMap<Object3D, Side>): void {
    this.#room = room;
    this.#hung = [];
    for (const [object, side] of hanging) {
      const bounds = new Box3().setFromObject(object);
      const thing = { min: bounds.min.toArray(), max: bounds.max.toArray() };
      this.#hung.push({ object, side, leavesPlan: leavesPlan(room!, thing, side) });
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

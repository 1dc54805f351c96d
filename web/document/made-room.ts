/**
 * A room that was made here, as files and links carry it: its plan as few whole numbers. What they mean is known by the room
 * maker (room-maker/plan-code); here it is only told apart from what is none, and bounded.
 */
import * as v from 'valibot';
import { readContainer } from './gltf-container.ts';
import type { SceneInfo } from './types.ts';

const mostNumbers = 4000; // of one list; a piece of furniture has seven
const whole = v.pipe(v.number(), v.safeInteger());

/** [version, name, height, lists of numbers ...] */
export const packedPlanSchema = v.pipe(
  v.array(
    v.union([whole, v.pipe(v.string(), v.maxLength(400)), v.pipe(v.array(whole), v.maxLength(mostNumbers))]),
  ),
  v.minLength(3),
  v.maxLength(20),
);

export type PackedPlan = v.InferOutput<typeof packedPlanSchema>;

function planIn(value: unknown): PackedPlan | null {
  const read = v.safeParse(packedPlanSchema, value);
  return read.success ? read.output : null;
}

/** The plan that a binary glTF of the room maker carries; null where it is another file. */
export function planOfGlb(bytes: ArrayBuffer): PackedPlan | null {
  try {
    const { scene = 0, scenes } = JSON.parse(readContainer(new Uint8Array(bytes)).text);
    return planIn(scenes?.[scene]?.extras?.fiatlux?.plan);
  } catch {
    return null; // cut off, or no JSON: not ours
  }
}

/** The plan that a scene was made of; null where its room was not made here. */
export function planOfScene({ provenance }: Pick<SceneInfo, 'provenance'>): PackedPlan | null {
  return typeof provenance === 'object' && provenance !== null && 'plan' in provenance
    ? planIn(provenance.plan)
    : null;
}

/** Glare in words and colours that view and panel share, and an observer made of a view. */
import type { Camera, Observer, Point, SceneInfo } from './types.ts';
import { words } from '../language/language.ts';
import { fixed } from '../language/numbers.ts';

/** What EN 12464-1 asks of rooms, and the colour of what is within each limit. */
export const glareLimits = [
  { max: 16, title: () => words.value.intentions.glare.limits.drawing, color: '#2c7fb8' },
  { max: 19, title: () => words.value.intentions.glare.limits.desks, color: '#41ae9d' },
  { max: 22, title: () => words.value.intentions.glare.limits.reception, color: '#e0b92f' },
  { max: 25, title: () => words.value.intentions.glare.limits.halls, color: '#e67e32' },
] as const;

const beyondAll = '#c8322b';
const nothing = '#8a919b';

/** `null`: nothing glares. */
export function glareColor(ugr: number | null): string {
  if (ugr === null) return nothing;
  return glareLimits.find(({ max }) => ugr <= max)?.color ?? beyondAll;
}

/** Below 10 a unified glare rating says no more than that nothing glares. */
export const leastTold = 10;

export function ugrText(ugr: number | null): string {
  return ugr === null || ugr < leastTold ? words.value.intentions.glare.under : fixed(ugr, 1);
}

const eyeHeight = 1.2; // m above the floor, of somebody who sits

/**
 * Somebody who sees what the view shows: at the camera where that is within the room, else sitting at the point that it
 * turns about, looking the same way.
 */
export function observerOfView(camera: Camera, scene: SceneInfo, name: string): Observer {
  const { low, high } = extentOf(scene);
  const { position, target } = camera;
  const direction: Point = [target[0] - position[0], target[1] - position[1], target[2] - position[2]];
  const isInside = position.every((value, axis) => value > low[axis]! && value < high[axis]!);
  if (isInside && !camera.plan) return { name, position: rounded(position), direction: rounded(direction) };
  const flat: Point =
    Math.hypot(direction[0], direction[2]) > 1e-3 ? [direction[0], 0, direction[2]] : [0, 0, -1];
  const eye: Point = [target[0], low[1] + eyeHeight, target[2]];
  return { name, position: rounded(eye), direction: rounded(flat) };
}

const rounded = (point: Point): Point =>
  point.map((value) => Math.round(value * 1000) / 1000) as unknown as Point;

type Mutable = [number, number, number];

function extentOf({ patchCenter }: SceneInfo): { low: Mutable; high: Mutable } {
  const low: Mutable = [Infinity, Infinity, Infinity];
  const high: Mutable = [-Infinity, -Infinity, -Infinity];
  patchCenter.forEach((value, i) => {
    low[i % 3] = Math.min(low[i % 3]!, value);
    high[i % 3] = Math.max(high[i % 3]!, value);
  });
  return { low, high };
}

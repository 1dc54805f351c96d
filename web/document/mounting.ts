/**
 * How a luminaire of a type hangs on a site: where its gamma 0 points and where its C0 lies, as in the core
 * (core/transport/mounted_luminaire.h). C90 = gamma 0 x C0.
 */
import { positionOf } from './sites.ts';
import type { LuminaireType, Mounting, Point, SceneInfo } from './types.ts';

export interface Frame {
  readonly down: Point; // unit, gamma 0
  readonly along: Point; // unit, C0
}

type Sites = SceneInfo['sites'];

const radians = Math.PI / 180;
const add = (a: Point, b: Point, share = 1): Point => [
  a[0] + share * b[0],
  a[1] + share * b[1],
  a[2] + share * b[2],
];
const scaled = (a: Point, factor: number): Point => [factor * a[0], factor * a[1], factor * a[2]];
const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Point, b: Point): Point => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const unit = (a: Point): Point => scaled(a, 1 / Math.hypot(...a));

const directionAt = (list: Float32Array, site: number): Point => [
  list[3 * site] ?? 0,
  list[3 * site + 1] ?? 0,
  list[3 * site + 2] ?? 0,
];

/** `wish` turned into the plane across `down`; any direction of that plane where the two are parallel. */
function inPlane(wish: Point, down: Point): Point {
  for (const direction of [wish, [1, 0, 0], [0, 0, 1]] as const) {
    const flat = add(direction, down, -dot(direction, down));
    if (Math.hypot(...flat) > 1e-6) return unit(flat);
  }
  return [0, 1, 0];
}

const onItself = 1e-6; // m: nobody aims at the place where a luminaire hangs

export function frameOn(
  sites: Sites,
  site: number,
  { turn, aim }: Pick<Mounting, 'turn' | 'aim'>,
  tilt = 0,
): Frame {
  const normal = directionAt(sites.normal, site);
  const axis = directionAt(sites.axis, site);
  const turned = add(scaled(axis, Math.cos(turn * radians)), cross(normal, axis), Math.sin(turn * radians));
  const leaning = add(scaled(normal, Math.cos(tilt * radians)), turned, Math.sin(tilt * radians));
  const towards = aim && add(aim, positionOf(sites, site), -1);
  const down = towards && Math.hypot(...towards) > onItself ? unit(towards) : unit(leaning);
  return { down, along: inPlane(turned, down) };
}

/** Degrees between a direction (unit) and the normal of a site's mount. */
export function angleFromNormal(sites: Sites, site: number, direction: Point): number {
  const normal = directionAt(sites.normal, site);
  return Math.atan2(Math.hypot(...cross(normal, direction)), dot(normal, direction)) / radians;
}

/** The frame of a luminaire that hangs; one of a type that is not there any more shines along its mount's normal. */
export function frameOf(
  sites: Sites,
  site: number,
  mounting: Mounting,
  types: readonly LuminaireType[],
): Frame {
  return frameOn(sites, site, mounting, types.find(({ id }) => id === mounting.type)?.tilt);
}

/** The middle of what a name means: the mean of its patches by area. null where there is none. */
export function middleOf(scene: SceneInfo, leaves: readonly number[]): Point | null {
  const wanted = new Set(leaves);
  let [sum, area]: [Point, number] = [[0, 0, 0], 0];
  scene.surfaceOfPatch.forEach((surface, patch) => {
    if (!wanted.has(surface)) return;
    const share = scene.patchArea[patch] ?? 0;
    sum = add(sum, directionAt(scene.patchCenter, patch), share);
    area += share;
  });
  return area > 0 ? scaled(sum, 1 / area) : null;
}

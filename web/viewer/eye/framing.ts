/**
 * Where a camera stands so that a room fills the picture: from a direction, the nearest eye that keeps all corners
 * of the room's box in the frame, and from which corner a room is best looked into.
 */

export type Vec = readonly [number, number, number];

export interface Box {
  readonly min: Vec;
  readonly max: Vec;
}

/** Where an eye flies to: a quadrant's corner, a person's place within the room, or where all of it is seen. */
export type Destination = number | 'within' | 'home';

/** Where an eye is: its quadrant, whether it is above the ceiling, and whether it looks up. */
export interface EyePlace {
  readonly quadrant: number;
  readonly isAbove: boolean;
  readonly looksUp: boolean;
}

export interface Pose {
  readonly position: [number, number, number];
  readonly target: [number, number, number];
}

export const boxCenter = ({ min, max }: Box): [number, number, number] => [
  (min[0] + max[0]) / 2,
  (min[1] + max[1]) / 2,
  (min[2] + max[2]) / 2,
];

export const boxCorners = ({ min, max }: Box): [number, number, number][] =>
  Array.from({ length: 8 }, (_, i) => [
    i & 1 ? max[0] : min[0],
    i & 2 ? max[1] : min[1],
    i & 4 ? max[2] : min[2],
  ]);

const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const along = (a: Vec, b: Vec, t: number): [number, number, number] => [
  a[0] + t * b[0],
  a[1] + t * b[1],
  a[2] + t * b[2],
];

/** From the target to the eye: azimuth 0 = from +z (south), 90 = from +x (east); elevation above the horizon; degrees. */
export function directionOf(azimuth: number, elevation: number): [number, number, number] {
  const [a, e] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
  return [Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)];
}

/** Right and up of a camera that looks against `direction` with y up. */
export function cameraAxes(direction: Vec): { right: Vec; up: Vec } {
  const flat = Math.hypot(direction[0], direction[2]);
  const right: Vec = flat > 1e-9 ? [direction[2] / flat, 0, -direction[0] / flat] : [1, 0, 0];
  const up: Vec = [
    direction[1] * right[2] - direction[2] * right[1],
    direction[2] * right[0] - direction[0] * right[2],
    direction[0] * right[1] - direction[1] * right[0],
  ];
  return { right, up };
}

/**
 * The nearest pose on `direction` (unit, target to eye) that holds the whole box in a frustum of vertical angle
 * `fov` (degrees). The four planes of the frustum are pushed against the corners, so the box touches the frame on
 * opposite sides; `margin` is the share of the frame left free (0.04 = 4 %).
 */
export function framePose(box: Box, direction: Vec, fov: number, aspect: number, margin = 0.04): Pose {
  const { right, up } = cameraAxes(direction);
  const center = boxCenter(box);
  const tangent = Math.tan((fov * Math.PI) / 360) * (1 - margin);
  const spread = (axis: Vec, slope: number) => {
    let high = -Infinity;
    let low = -Infinity;
    for (const corner of boxCorners(box)) {
      const offset: Vec = [corner[0] - center[0], corner[1] - center[1], corner[2] - center[2]];
      const depth = dot(offset, direction); // towards the eye
      high = Math.max(high, dot(offset, axis) + depth * slope);
      low = Math.max(low, -dot(offset, axis) + depth * slope);
    }
    return { distance: (high + low) / (2 * slope), shift: (high - low) / 2 };
  };
  const [across, upward] = [spread(right, tangent * aspect), spread(up, tangent)];
  const target = along(along(center, right, across.shift), up, upward.shift);
  const distance = Math.max(across.distance, upward.distance);
  return { target, position: along(target, direction, distance) };
}

/** Vertical extent (m) that a plan view needs to show the box from above, and whether it is turned by a quarter. */
export function planFrame(box: Box, aspect: number, margin = 0.06): { height: number; turned: boolean } {
  const width = Math.max(box.max[0] - box.min[0], 1e-3);
  const depth = Math.max(box.max[2] - box.min[2], 1e-3);
  const needed = (x: number, y: number) => Math.max(y, x / aspect) / (1 - margin);
  const [upright, quarter] = [needed(width, depth), needed(depth, width)];
  return quarter < 0.85 * upright ? { height: quarter, turned: true } : { height: upright, turned: false };
}

/**
 * The azimuth (degrees) of the corner view. `shares[q]` = how much of the room's surfaces faces an eye in quadrant q
 * (azimuths 45, 135, 225, 315); the eye goes where it sees clearly more, or else to the first. Long rooms lie along the picture's long side.
 */
export function cornerAzimuth(box: Box, aspect: number, shares: readonly number[]): number {
  let quadrant = 0;
  for (let q = 1; q < 4; q++) if ((shares[q] ?? 0) > 1.03 * (shares[quadrant] ?? 0)) quadrant = q;
  const width = box.max[0] - box.min[0];
  const depth = box.max[2] - box.min[2];
  // The turn away from the diagonal grows with the room's slimness, up to 14 degrees: walls across it are not seen edge-on.
  const slimness = Math.log2(Math.max(depth, 1e-3) / Math.max(width, 1e-3));
  const towardsEast = Math.max(-14, Math.min(14, 20 * slimness)) * (aspect >= 1 ? 1 : -1);
  const eastern = [45 + towardsEast, 135 - towardsEast, 225 + towardsEast, 315 - towardsEast];
  return eastern[quadrant]!;
}

/** The elevation (degrees) of the corner view: an eye that looks into a flat room must stand higher. */
export function cornerElevation(box: Box, aspect = 1.5): number {
  const across = Math.hypot(box.max[0] - box.min[0], box.max[2] - box.min[2]);
  const flatness = Math.log2(across / Math.max(box.max[1] - box.min[1], 1e-3)); // 0.5 for a cube, 3.5 for a corridor
  const upright = aspect < 0.8 ? 8 : 0; // a tall picture is filled better from above
  return Math.max(24, Math.min(48, 23 + 7 * flatness)) + upright;
}

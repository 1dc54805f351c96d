/** Poses of the eye around a target, and the way from one to another. */
import { Spherical, Vector3 } from 'three';

export interface CameraPose {
  readonly target: Vector3;
  readonly spherical: Spherical; // of the eye, around the target; theta 0 = from +z, phi 0 = from above
  readonly plan: boolean; // orthographic, from above
}

/** Share k (0..1) of the way: the target straight, the eye on an arc by the shorter turn, its distance by ratios. */
export function poseBetween(from: CameraPose, to: CameraPose, k: number): CameraPose {
  const mix = (a: number, b: number) => a + (b - a) * k;
  const turns = (to.spherical.theta - from.spherical.theta) / (2 * Math.PI);
  const sweep = 2 * Math.PI * (turns - Math.round(turns));
  const radius = Math.exp(mix(Math.log(from.spherical.radius), Math.log(to.spherical.radius)));
  const phi = mix(from.spherical.phi, to.spherical.phi);
  return {
    target: from.target.clone().lerp(to.target, k),
    spherical: new Spherical(radius, phi, from.spherical.theta + sweep * k).makeSafe(),
    plan: from.plan && to.plan,
  };
}

/** The poses from which a room is looked at: home (its best corner), plan, any direction framed; and those of links. */
import { Spherical, Vector3 } from 'three';
import type { Camera } from '../../document/types.ts';
import type { CameraPose } from './camera-flight.ts';
import * as framing from './framing.ts';

export const fov = 38; // degrees, vertical
export const tangent = Math.tan((fov * Math.PI) / 360);
const eyeHeight = 1.6; // m, standing
const fromWall = 1.2; // m, of an eye within the room
const arm = 0.4; // m from the eye to the centre of its turns
const floorDepth = 0.15; // m: carpets and steps are floor, too
const likeness = 1.02; // of two pictures' shapes: what differs less is the same view
const planTilt = 1e-4; // the eye of a plan stands this much off the vertical, which says what is up on the page

/** Of a person who looks ahead (unit, level): the centre of turns is just before the eyes. */
export const standingCamera = (eye: framing.Vec, ahead: framing.Vec): Camera => ({
  position: eye,
  target: [eye[0] + arm * ahead[0], eye[1] + arm * ahead[1], eye[2] + arm * ahead[2]],
  plan: false,
});

export class RoomPoses {
  aspect: number;
  planAspect: number;
  #box: framing.Box;
  #facing: readonly number[];

  /** `facing`: how much of the room faces an eye in each quadrant (framing.ts); `aspect`: width / height of the picture, and where it is a plan. */
  constructor(box: framing.Box, facing: readonly number[], aspect = 1, planAspect = aspect) {
    this.#box = box;
    this.#facing = facing;
    this.aspect = aspect;
    this.planAspect = planAspect;
  }

  /** Diagonal of the room, m. */
  get size(): number {
    return Math.hypot(...this.#box.max.map((high, i) => high - this.#box.min[i]!));
  }

  home(): CameraPose {
    const azimuth = framing.cornerAzimuth(this.#box, this.aspect, this.#facing);
    return this.framed(framing.directionOf(azimuth, framing.cornerElevation(this.#box, this.aspect)), 0.07);
  }

  /**
   * A person in the room, on the side from which home looks: the way from there to home turns nothing. They look across,
   * a little down.
   */
  within(): CameraPose {
    const { eye, target, height } = this.#person();
    return this.of(eye, target.setY(this.#box.min[1] + 0.8 * height), false);
  }

  /** The same person, who looks up to the ceiling. */
  lookingUp(): CameraPose {
    const { eye, target } = this.#person();
    return this.of(eye, target.setY(this.#box.max[1]), false);
  }

  /** As home, from one quadrant (0..3: azimuths 45, 135, 225, 315). */
  corner(quadrant: number): CameraPose {
    const only = [0, 1, 2, 3].map((q) => (q === quadrant ? 1 : 0));
    const azimuth = framing.cornerAzimuth(this.#box, this.aspect, only);
    return this.framed(framing.directionOf(azimuth, framing.cornerElevation(this.#box, this.aspect)), 0.07);
  }

  /** The nearest eye on a direction that sees the whole room; `margin`: share of the frame left free. */
  framed(direction: framing.Vec, margin: number): CameraPose {
    const pose = framing.framePose(this.#box, direction, fov, this.aspect, margin);
    return this.of(new Vector3(...pose.position), new Vector3(...pose.target), false);
  }

  plan(): CameraPose {
    const { height } = framing.planFrame(this.#box, this.planAspect);
    const target = new Vector3(...framing.boxCenter(this.#box));
    return this.of(target.clone().setY(target.y + height / (2 * tangent)), target, true);
  }

  /** Whether a point is of the floor. */
  isFloor(point: Vector3): boolean {
    return point.y - this.#box.min[1] < floorDepth;
  }

  /** A person on a point of the floor who looks towards `seen`, level: the centre of turns is just before the eyes. */
  standing(point: Vector3, seen: Vector3): { eye: Vector3; target: Vector3 } {
    const eye = point.clone().setY(point.y + eyeHeight);
    const ahead = seen.clone().sub(eye).setY(0);
    if (ahead.length() < 1)
      ahead
        .set(...framing.boxCenter(this.#box))
        .sub(eye)
        .setY(0);
    if (ahead.lengthSq() < 1e-6) ahead.set(0, 0, -1);
    return { eye, target: ahead.setLength(arm).add(eye) };
  }

  /**
   * A view as it was given. Where it was seen in a wider picture the eye steps back until as much is seen from side to side;
   * an eye that stands in the room stays there.
   */
  given({ position, target, plan, aspect: seen }: Camera): CameraPose {
    const pose = this.of(new Vector3(...position), new Vector3(...target), plan);
    const wider = (seen ?? 0) / (plan ? this.planAspect : this.aspect);
    if (wider > likeness && pose.spherical.radius > 2 * arm) pose.spherical.radius *= wider;
    return pose;
  }

  of(eye: Vector3, target: Vector3, plan: boolean): CameraPose {
    const offset = eye.clone().sub(target);
    if (offset.lengthSq() < 1e-6) offset.set(0, 0, 1);
    const spherical = new Spherical().setFromVector3(offset);
    if (plan) spherical.set(spherical.radius, planTilt, this.#planAzimuth());
    return { target, spherical, plan };
  }

  /** What is up on the page of a plan: north, or a quarter turned where that fills the picture better. */
  #planAzimuth(): number {
    if (!framing.planFrame(this.#box, this.planAspect).turned) return 0;
    return (framing.cornerAzimuth(this.#box, this.aspect, this.#facing) < 180 ? 0.5 : -0.5) * Math.PI;
  }

  /** Someone at the side of the room from which home looks, what is before them, and how high their eyes are, m. */
  #person(): { eye: Vector3; target: Vector3; height: number } {
    const { theta } = this.home().spherical;
    const { min, max } = this.#box;
    const target = new Vector3(...framing.boxCenter(this.#box));
    const height = Math.min(eyeHeight, 0.6 * (max[1] - min[1]));
    const [x, z] = [Math.sin(theta), Math.cos(theta)];
    const reach = Math.min((max[0] - min[0]) / 2 / Math.abs(x), (max[2] - min[2]) / 2 / Math.abs(z));
    const away = Math.max(0.5 * reach, reach - fromWall);
    return { eye: new Vector3(target.x + away * x, min[1] + height, target.z + away * z), target, height };
  }

  /** Whether an eye is above the ceiling. */
  isAbove({ y }: Vector3): boolean {
    return y > this.#box.max[1];
  }
}

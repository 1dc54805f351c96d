/**
 * The eye: orbit, pan, zoom to the cursor (mouse, touch, keys), named views, and a true plan (orthographic from
 * above). A perspective and an orthographic camera share one OrbitControls; a plan of height h stands for an eye at
 * distance h / (2 tan(fov / 2)), so that a Camera of a link means the same in both.
 */
import { MOUSE, OrthographicCamera, PerspectiveCamera, TOUCH, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { Camera } from '../../document/types.ts';
import { poseBetween, type CameraPose } from './camera-flight.ts';
import type { Covered } from '../stage/stage.ts';
import type { ViewName } from '../types.ts';
import { easeOut, reducedMotion, type Animation, type FrameLoop } from '../stage/frame-loop.ts';
import { directionOf, type Box, type Destination, type EyePlace } from './framing.ts';
import { fov, RoomPoses, tangent } from './room-poses.ts';

const flight = 420; // ms
const upwards = 0.14; // of a direction: who looks up by less sees walls and floor

const facingAzimuth = { north: 0, east: 270, south: 180, west: 90 } as const; // the wall that is looked at

export class CameraRig {
  readonly controls: OrbitControls;
  #perspective = new PerspectiveCamera(fov, 1, 0.05, 1000);
  #orthographic = new OrthographicCamera(-1, 1, 1, -1, 0.1, 1000);
  #loop: FrameLoop;
  #report: (camera: Camera) => void;
  #poses = new RoomPoses({ min: [-2, 0, -2], max: [2, 3, 2] }, [0, 0, 0, 0]);
  /** Untouched since then: a new picture size frames the room anew, or what a given view showed. */
  #framed: 'home' | 'plan' | Camera | null = 'home';
  #unreported = false;
  #flying: Animation | null = null;
  #isRising = false; // by rise(), a frame at a time

  constructor(canvas: HTMLCanvasElement, loop: FrameLoop, report: (camera: Camera) => void) {
    this.#loop = loop;
    this.#report = report;
    this.controls = new OrbitControls(this.#perspective, canvas);
    const controls = this.controls;
    controls.zoomToCursor = true;
    controls.dampingFactor = 0.14;
    controls.enableDamping = !reducedMotion();
    controls.minDistance = 0.2;
    controls.maxPolarAngle = 0.97 * Math.PI;
    controls.addEventListener('change', this.#changed);
    controls.addEventListener('start', this.#grabbed);
  }

  /** The camera to draw with. */
  get active(): PerspectiveCamera | OrthographicCamera {
    return this.controls.object as PerspectiveCamera | OrthographicCamera;
  }

  get plan(): boolean {
    return this.active === this.#orthographic;
  }

  /** `keepView`: the same room, a little changed: who has moved away from its first view stays where they are. */
  setRoom(box: Box, facing: readonly number[], keepView = false): void {
    const { aspect, planAspect } = this.#poses;
    this.#poses = new RoomPoses(box, facing, aspect, planAspect);
    this.controls.maxDistance = 6 * this.#poses.home().spherical.radius;
    if (keepView && this.#framed !== 'home') return;
    this.#apply(this.#poses.home());
    this.#framed = 'home';
  }

  /** Where the eye is; null in a plan, which is none. */
  get eye(): EyePlace | null {
    if (this.plan) return null;
    const { position } = this.#perspective;
    const { x, y, z } = position.clone().sub(this.controls.target).normalize();
    const quadrant = x >= 0 ? (z >= 0 ? 0 : 1) : z < 0 ? 2 : 3;
    return { quadrant, isAbove: this.#poses.isAbove(position), looksUp: y < -upwards };
  }

  /** Flies to where something is seen: a quadrant's corner view, within the room looking up, or home. */
  lookFrom(place: Destination): void {
    if (place === 'home') return this.home();
    this.#framed = null;
    this.#fly(place === 'within' ? this.#poses.lookingUp() : this.#poses.corner(place));
  }

  /** What is covered is drawn, too, but the room is framed in what is left between. */
  resize(width: number, height: number, { top, planTop, bottom, planBottom }: Covered): void {
    const frame = (camera: PerspectiveCamera | OrthographicCamera, above: number, below: number) => {
      const free = Math.max(1, height - above - below);
      if (above + below > 0) camera.setViewOffset(width, free, 0, -above, width, height);
      else camera.clearViewOffset();
      return width / free;
    };
    this.#poses.aspect = frame(this.#perspective, top, bottom);
    this.#poses.planAspect = frame(this.#orthographic, planTop, planBottom);
    if (this.#framed === 'home') this.#apply(this.#poses.home());
    else if (this.#framed === 'plan') this.#apply(this.#poses.plan());
    else if (this.#framed) this.#apply(this.#poses.given(this.#framed));
    this.#project();
    this.#unreported = true; // what is drawn over the picture follows it
  }

  /** Keeps what is seen from side to side while the picture has another size; what is returned lets go of it. */
  hold(): () => void {
    const [framed, pose] = [this.#framed, this.#present()];
    this.#framed ??= this.get();
    return () => {
      this.#framed = framed;
      if (framed === null) this.#apply(pose);
    };
  }

  /** Steps damping before a frame; tells the app of a new pose once the eye rests. */
  update(): void {
    const isFlying = this.#flying !== null || this.#isRising;
    const moving = !isFlying && this.controls.update();
    this.#project();
    if (moving || isFlying || !this.#unreported) return;
    this.#unreported = false;
    this.#report(this.get());
  }

  get(): Camera {
    const target = this.controls.target;
    const eye = this.plan
      ? new Vector3(0, this.#planHeight() / (2 * tangent), 0).add(target)
      : this.#perspective.position;
    const aspect = this.plan ? this.#poses.planAspect : this.#poses.aspect;
    return { position: eye.toArray(), target: target.toArray(), plan: this.plan, aspect };
  }

  /** Ends what is left of a turn or a flight: the view that is on the screen stays. */
  rest(): void {
    this.#stop();
    this.#apply(this.#present());
    this.#loop.invalidate();
  }

  set(camera: Camera): void {
    this.#stop();
    this.#apply(this.#poses.given(camera));
    this.#framed = camera;
    this.#loop.invalidate();
  }

  flyTo(camera: Camera): void {
    this.#fly(this.#poses.given(camera));
    this.#framed = camera;
  }

  /** Stands on a point of the floor and looks where the eye has looked; a drag then turns the head. */
  stand(point: Vector3): void {
    this.#framed = null;
    const { eye, target } = this.#poses.standing(point, this.controls.target);
    this.#fly(this.#poses.of(eye, target, false));
  }

  view(name: ViewName): void {
    if (name === 'corner') return this.home();
    this.#framed = name === 'plan' ? 'plan' : null;
    if (name === 'plan') this.#fly(this.#poses.plan());
    else this.#fly(this.#poses.framed(directionOf(facingAzimuth[name], 9), 0.05));
  }

  home(): void {
    this.#fly(this.#poses.home());
    this.#framed = 'home';
  }

  /** Puts the eye into the room. */
  enter(): void {
    this.#framed = null;
    this.rise(0);
    this.#loop.invalidate();
  }

  /** Share k (0..1) of the way from within the room to home. */
  rise(k: number): void {
    this.#stop();
    this.#isRising = true;
    this.#apply(poseBetween(this.#poses.within(), this.#poses.home(), k));
  }

  /** As home, at once. */
  land(): void {
    this.#stop();
    this.#apply(this.#poses.home());
    this.#framed = 'home';
    this.#loop.invalidate();
  }

  /** The whole room from where the eye stands. */
  fit(): void {
    if (this.plan) return this.view('plan');
    const offset = this.#perspective.position.clone().sub(this.controls.target).normalize();
    this.#fly(this.#poses.framed(offset.toArray(), 0.04));
    this.#framed = null;
  }

  isFloor(point: Vector3): boolean {
    return this.#poses.isFloor(point);
  }

  /** Makes a point the centre of orbits, bringing it to the middle of the picture. */
  pivot(point: Vector3): void {
    const eye = this.active.position.clone();
    if (this.plan) eye.add(point).sub(this.controls.target);
    const target = this.plan ? new Vector3(point.x, this.controls.target.y, point.z) : point;
    if (!this.plan) eye.add(target).sub(this.controls.target).lerp(target, 0.25);
    this.#framed = null;
    this.#fly(this.#poses.of(eye, target, this.plan));
  }

  /** Turns (radians) around the target, as the arrow keys do; in plan it pans. */
  turn(right: number, up: number): void {
    if (this.plan) return this.pan(right, up);
    this.#grabbed();
    const goal = this.#present();
    goal.spherical.theta += right;
    goal.spherical.phi = Math.min(0.97 * Math.PI, Math.max(0.02, goal.spherical.phi - up));
    this.#fly(goal);
  }

  /** Moves sideways by shares of the picture's height. */
  pan(right: number, up: number): void {
    this.#grabbed();
    const goal = this.#present();
    const scale = 2 * tangent * goal.spherical.radius;
    const axes = [new Vector3(), new Vector3(), new Vector3()] as const;
    this.active.matrixWorld.extractBasis(...axes);
    goal.target.addScaledVector(axes[0], right * scale).addScaledVector(axes[1], up * scale);
    this.#fly(goal);
  }

  /** Brings the eye nearer (factor < 1) or farther. */
  zoom(factor: number): void {
    this.#grabbed();
    const goal = this.#present();
    goal.spherical.radius = Math.max(
      0.2,
      Math.min(this.controls.maxDistance, goal.spherical.radius * factor),
    );
    this.#fly(goal);
  }

  dispose(): void {
    this.#stop();
    this.controls.dispose();
  }

  #changed = (): void => {
    this.#unreported = true;
    this.#loop.invalidate();
  };

  #grabbed = (): void => {
    this.#framed = null;
    this.#stop();
  };

  #present(): CameraPose {
    const { position, target, plan } = this.get();
    return this.#poses.of(new Vector3(...position), new Vector3(...target), plan);
  }

  #planHeight(): number {
    return (this.#orthographic.top - this.#orthographic.bottom) / this.#orthographic.zoom;
  }

  #apply({ target, spherical, plan }: CameraPose): void {
    const camera = plan ? this.#orthographic : this.#perspective;
    const controls = this.controls;
    const damping = controls.enableDamping;
    controls.enableDamping = false;
    controls.update(); // spends what is left of an old movement, before the pose is set
    controls.object = camera;
    controls.enableRotate = !plan;
    controls.mouseButtons.LEFT = plan ? MOUSE.PAN : MOUSE.ROTATE;
    controls.touches.ONE = plan ? TOUCH.PAN : TOUCH.ROTATE;
    controls.target.copy(target);
    if (plan) {
      this.#orthographic.zoom = 1;
      this.#orthographic.top = spherical.radius * tangent;
      this.#orthographic.bottom = -this.#orthographic.top;
    }
    camera.position.setFromSpherical(spherical).add(target);
    camera.lookAt(target);
    this.#project();
    controls.update();
    controls.enableDamping = damping;
    this.#unreported = true;
  }

  #project(): void {
    const distance = this.active.position.distanceTo(this.controls.target);
    const { aspect, planAspect, size } = this.#poses;
    this.#perspective.aspect = aspect;
    this.#perspective.near = Math.max(0.03, 0.02 * distance);
    this.#perspective.far = distance + 4 * size + 10;
    this.#orthographic.right = this.#orthographic.top * planAspect;
    this.#orthographic.left = -this.#orthographic.right;
    this.#orthographic.near = distance - 2 * size - 10;
    this.#orthographic.far = distance + 2 * size + 10;
    this.active.updateProjectionMatrix();
  }

  #stop(): void {
    if (this.#flying) this.#loop.cancel(this.#flying);
    this.#flying = null;
    this.#isRising = false;
  }

  #fly(goal: CameraPose): void {
    this.#stop();
    if (reducedMotion()) {
      this.#apply(goal);
      return this.#loop.invalidate();
    }
    const start = this.#present();
    let begun = 0;
    this.#flying = (now) => {
      begun ||= now;
      const t = (now - begun) / flight;
      if (t >= 1) this.#flying = null;
      this.#apply(t < 1 ? poseBetween(start, goal, easeOut(t)) : goal);
      return t < 1;
    };
    this.#loop.animate(this.#flying);
  }
}

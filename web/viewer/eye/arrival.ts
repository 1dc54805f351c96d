/**
 * How a visitor comes into the first room: from within, at eye height and at dusk; the light fades on and the eye rises to
 * the whole room. It waits for the first light and then for nobody: any input ends it before it is answered.
 */
import { easeInOut, reducedMotion, type Animation, type FrameLoop } from '../stage/frame-loop.ts';
import type { CameraRig } from './camera-rig.ts';

const standing = 500; // ms before the eye rises
const rising = 3500; // ms
const fading = 1400; // ms from dusk to full light
const dusk = 0.16; // of the picture's brightness
const inputs = ['pointerdown', 'wheel', 'keydown', 'input', 'drop'] as const;
const tremble = 60; // px that a pointer moves in a hand that does nothing yet

type Stage = 'over' | 'expected' | 'within' | 'fading' | 'rising';

export class Arrival {
  readonly #canvas: HTMLCanvasElement;
  readonly #loop: FrameLoop;
  readonly #rig: CameraRig;
  #stage: Stage = 'over';
  #isLit = false;
  #begun = 0; // ms, of the light
  #inputs: AbortController | null = null;
  #pointedFrom: readonly [number, number] | null = null; // px, where the pointer was when the room was there

  constructor(canvas: HTMLCanvasElement, loop: FrameLoop, rig: CameraRig) {
    this.#canvas = canvas;
    this.#loop = loop;
    this.#rig = rig;
  }

  /** The next room is come into, unless there is an input before. */
  expect(): void {
    if (reducedMotion()) return;
    this.#stage = 'expected';
    this.#inputs = new AbortController();
    const options = { capture: true, passive: true, signal: this.#inputs.signal };
    for (const type of inputs) window.addEventListener(type, () => this.end(), options);
    window.addEventListener('pointermove', (event) => this.#pointed(event), options);
  }

  /** The room is there. False where nobody arrives: then the eye is not ours. */
  begin(): boolean {
    if (this.#stage !== 'expected') return false;
    this.#stage = 'within';
    this.#canvas.classList.add('is-arriving');
    this.#shade(dusk);
    this.#rig.enter();
    if (this.#isLit) this.#run();
    return true;
  }

  /** The room has light. */
  light(): void {
    this.#isLit = true;
    if (this.#stage === 'within') this.#run();
    else if (this.#isFull) performance.mark('light set');
  }

  /** The whole room in full light, from the next frame on. */
  end(): void {
    const isWithin = this.#stage !== 'over' && this.#stage !== 'expected';
    if (!this.#isFull && this.#isLit) performance.mark('light set');
    this.#stage = 'over';
    this.#inputs?.abort();
    this.#loop.cancel(this.#step);
    this.#canvas.classList.remove('is-arriving');
    this.#shade(1);
    if (isWithin) this.#rig.land();
  }

  get #isFull(): boolean {
    return this.#stage === 'over' || this.#stage === 'rising';
  }

  /** A pointer that crosses the page is an input, too; what it did before the room was there is not. */
  #pointed({ clientX, clientY }: PointerEvent): void {
    if (this.#stage === 'expected') return;
    const [x, y] = (this.#pointedFrom ??= [clientX, clientY]);
    if (Math.hypot(clientX - x, clientY - y) > tremble) this.end();
  }

  #run(): void {
    this.#stage = 'fading';
    this.#loop.animate(this.#step);
  }

  #step: Animation = (now) => {
    this.#begun ||= now;
    const passed = now - this.#begun;
    if (this.#stage === 'fading') this.#fade(passed);
    this.#rig.rise(easeInOut((passed - standing) / rising));
    const isOver = passed >= standing + rising;
    if (isOver) this.end();
    return !isOver;
  };

  #fade(passed: number): void {
    this.#shade(Math.pow(dusk, 1 - easeInOut(passed / fading)));
    if (passed < fading) return;
    this.#stage = 'rising';
    performance.mark('light set');
  }

  #shade(brightness: number): void {
    this.#canvas.style.filter = brightness < 1 ? `brightness(${brightness.toFixed(3)})` : '';
  }
}

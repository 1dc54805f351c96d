/**
 * The colour that shown light has taken from the room: for the picture alone, told a little after the light itself, and
 * while light follows light not for all of it.
 */
import type { ColoredLight, CoreModule, Session } from './core.ts';
import type { Clock } from './pacing.ts';
import type { FromWorker } from './protocol.ts';

const apart = 40; // ms at least between two answers while something else runs
const share = 0.1; // of the time that they may take then
type Answer = Extract<FromWorker, { readonly type: 'colored' }>;

/** Light, and the paint of the room that it is in. */
interface Lit {
  readonly revision: number;
  readonly illuminance: Float32Array;
  readonly paint: Float64Array;
}

export class LightColor {
  readonly #core: Pick<CoreModule, 'ColoredLight'>;
  readonly #room: Session;
  readonly #clock: Clock;
  #colors: Float32Array | null = null; // of the patches
  #hasOperator = false;
  #isGrey = false; // what was made is: no light takes a colour
  #made: ColoredLight | null = null; // for these colours and `#paint`
  #paint: Float64Array = new Float64Array(); // of the room, as the core takes it
  #latest: Lit | null = null; // shown, not coloured
  #nextAt = -Infinity; // while something else runs

  constructor(core: Pick<CoreModule, 'ColoredLight'>, room: Session, clock: Clock) {
    this.#core = core;
    this.#room = room;
    this.#clock = clock;
  }

  /** Another room is being opened. */
  clear(): void {
    this.#made?.delete();
    this.#made = this.#colors = this.#latest = null;
    this.#isGrey = false;
    this.#hasOperator = false;
  }

  /** The room's exchange of light is there. */
  ready(): void {
    this.#hasOperator = true;
  }

  /** Linear RGB of the patches. */
  paint(colors: Float32Array): void {
    this.#made?.delete();
    this.#made = null;
    this.#isGrey = false;
    this.#colors = colors;
  }

  /** Light that is about to be shown in a room of that paint, of which a copy is kept. */
  take(revision: number, illuminance: Float32Array, paint: Float64Array): void {
    this.#latest = { revision, illuminance: illuminance.slice(), paint };
  }

  get waits(): boolean {
    return this.#hasOperator && this.#colors !== null && this.#latest !== null && !this.#isGrey;
  }

  /** Whether what else runs has had its time. */
  get isDue(): boolean {
    return this.waits && this.#clock() >= this.#nextAt;
  }

  /** Of light beside what is shown; null where it has none, or none is known yet. */
  of(illuminance: Float32Array, paint: Float64Array): Float32Array | null {
    if (!this.#hasOperator || !this.#colors) return null;
    this.#prepare(this.#colors, paint);
    return this.#made && !this.#isGrey ? this.#made.of(illuminance) : null;
  }

  /** What does not fit the room is not coloured, and nor is what is grey. */
  #prepare(colors: Float32Array, paint: Float64Array): void {
    if (this.#isFor(paint)) return;
    this.#made?.delete();
    this.#made = new this.#core.ColoredLight();
    this.#paint = paint;
    this.#isGrey = this.#made.begin(this.#room, colors, paint) !== '' || this.#made.isGrey();
  }

  #isFor(paint: Float64Array): boolean {
    const same = paint.length === this.#paint.length && paint.every((value, i) => value === this.#paint[i]);
    return this.#made !== null && same;
  }

  /** Prepares, or colours what was shown last; null where there is nothing to tell. */
  step(): Answer | null {
    if (!this.waits || !this.#colors || !this.#latest) return null;
    const { revision, illuminance, paint } = this.#latest;
    if (!this.#isFor(paint)) {
      this.#prepare(this.#colors, paint);
      return null;
    }
    this.#latest = null;
    if (!this.#made) return null;
    const begun = this.#clock();
    const colors = this.#made.of(illuminance);
    const now = this.#clock();
    this.#nextAt = now + Math.max(apart, (now - begun) / share);
    return { type: 'colored', revision, colors };
  }
}

/**
 * Draws when something changed and not otherwise: any number of `invalidate` calls make one frame. Animations are
 * stepped before the frame and keep it coming until they are over.
 */

/** Called once a frame with the time (ms); true while there is more to come: 'unseen' where nothing shows yet. */
export type Animation = (now: number) => boolean | 'unseen';

export class FrameLoop {
  #request = 0;
  #animations = new Set<Animation>();
  #running = true;
  #isSeen = false; // something changed since the last frame was drawn
  #standsBack = false; // the next frame is another's
  #draw: (now: number) => void;

  constructor(draw: (now: number) => void) {
    this.#draw = draw;
  }

  invalidate(): void {
    this.#isSeen = true;
    this.#ask();
  }

  #ask(): void {
    if (this.#request === 0 && this.#running) this.#request = requestAnimationFrame(this.#step);
  }

  /** Draws at once what the next frame would: a canvas that was just resized is empty and must not be shown so. */
  flush(): void {
    if (!this.#running) return;
    cancelAnimationFrame(this.#request);
    this.#isSeen = true;
    this.#standsBack = false;
    this.#step(performance.now());
  }

  /** Leaves one frame to the rest of the page, which has much to lay out: with the picture it would take twice as long. */
  standBack(): void {
    this.#standsBack = true;
  }

  animate(animation: Animation): void {
    this.#animations.add(animation);
    this.invalidate();
  }

  /** Stops an animation where it is. */
  cancel(animation: Animation): void {
    this.#animations.delete(animation);
  }

  /** Nothing is drawn while suspended (the context is lost); what changed is drawn on resumption. */
  suspend(): void {
    this.#running = false;
    cancelAnimationFrame(this.#request);
    this.#request = 0;
  }

  resume(): void {
    this.#running = true;
    this.invalidate();
  }

  #step = (now: number): void => {
    this.#request = 0;
    if (this.#standsBack) {
      this.#standsBack = false;
      return this.#ask();
    }
    for (const animation of this.#animations) {
      const more = animation(now);
      if (more !== 'unseen') this.#isSeen = true;
      if (!more) this.#animations.delete(animation);
    }
    if (this.#isSeen) {
      this.#isSeen = false;
      this.#draw(now);
    }
    if (this.#animations.size > 0) this.#ask();
  };
}

/** 0..1 -> 0..1, fast first, at rest at the end. */
export const easeOut = (t: number): number => 1 - Math.pow(1 - Math.min(1, Math.max(0, t)), 3);

/** 0..1 -> 0..1, at rest at both ends. */
export function easeInOut(t: number): number {
  const k = Math.min(1, Math.max(0, t));
  return k * k * k * (10 - 15 * k + 6 * k * k);
}

const query = '(prefers-reduced-motion: reduce)';

/** Whether the person asked for less motion: then everything jumps to its end. */
export const reducedMotion = (): boolean => typeof matchMedia === 'function' && matchMedia(query).matches;

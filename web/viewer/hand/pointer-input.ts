/**
 * What a pointer and the keyboard do on the canvas, told apart: hover (once a frame), click, double click, a press on
 * a luminaire (which takes precedence over orbiting), and keys.
 */
import type { ViewName } from '../types.ts';

const slack = 5; // px: a longer way is a drag
const clickTime = 500; // ms

const viewKeys: readonly ViewName[] = ['plan', 'north', 'east', 'south', 'west', 'corner'];

export interface InputHandlers {
  /** The pointer is at this point of the page, or has left (null). Mouse and pen only. */
  hover(at: { x: number; y: number } | null): void;
  click(x: number, y: number): void;
  doubleClick(x: number, y: number): void;
  /** True when the press was on a luminaire and is dealt with. */
  press(event: PointerEvent): boolean;
  view(name: ViewName): void;
  fit(): void;
  home(): void;
  /** An arrow key: right and up are -1, 0 or 1. */
  arrow(right: number, up: number, event: KeyboardEvent): void;
  zoom(factor: number): void;
  escape(): void;
}

const arrows: Record<string, readonly [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export class PointerInput {
  #handlers: InputHandlers;
  #down: { x: number; y: number; time: number; id: number } | null = null;
  #at: { x: number; y: number } | null = null;
  #frame = 0;
  #abort = new AbortController();

  constructor(canvas: HTMLCanvasElement, handlers: InputHandlers) {
    this.#handlers = handlers;
    const options = { signal: this.#abort.signal };
    canvas.addEventListener('pointerdown', this.#pressed, { ...options, capture: true });
    canvas.addEventListener('pointermove', this.#moved, options);
    canvas.addEventListener('pointerup', this.#released, options);
    canvas.addEventListener('pointerleave', this.#left, options);
    canvas.addEventListener('pointercancel', this.#left, options);
    canvas.addEventListener('dblclick', (e) => handlers.doubleClick(e.clientX, e.clientY), options);
    canvas.addEventListener('keydown', this.#key, options);
  }

  /** What lies under a pointer that rests may be something else now. */
  again(): void {
    if (this.#at) this.#ask();
  }

  dispose(): void {
    this.#abort.abort();
    cancelAnimationFrame(this.#frame);
  }

  #pressed = (event: PointerEvent): void => {
    if (event.button === 0 && this.#handlers.press(event)) {
      this.#down = null;
      event.stopImmediatePropagation();
      return;
    }
    // A second finger makes it a gesture, not a click.
    this.#down = this.#down || event.button !== 0 ? null : pressOf(event);
  };

  #moved = (event: PointerEvent): void => {
    if (event.pointerType === 'touch') return;
    this.#at = event.buttons === 0 ? { x: event.clientX, y: event.clientY } : null;
    this.#ask();
  };

  #left = (): void => {
    this.#down = null;
    this.#at = null;
    this.#ask();
  };

  #ask(): void {
    if (this.#frame !== 0) return;
    this.#frame = requestAnimationFrame(() => {
      this.#frame = 0;
      this.#handlers.hover(this.#at);
    });
  }

  #released = (event: PointerEvent): void => {
    const down = this.#down;
    this.#down = null;
    if (!down || down.id !== event.pointerId || event.timeStamp - down.time > clickTime) return;
    if (Math.hypot(event.clientX - down.x, event.clientY - down.y) > slack) return;
    this.#handlers.click(event.clientX, event.clientY);
  };

  #key = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey) return;
    if (this.#command(event)) event.preventDefault();
  };

  #command(event: KeyboardEvent): boolean {
    const arrow = arrows[event.key];
    const view = viewKeys[Number.parseInt(event.key, 10) - 1];
    const key = event.key.toLowerCase();
    if (arrow) this.#handlers.arrow(arrow[0], arrow[1], event);
    else if (event.altKey) return false;
    else if (view && event.key.length === 1) this.#handlers.view(view);
    else if (key === 'f') this.#handlers.fit();
    else if (key === 'h') this.#handlers.home();
    else if (key === '+' || key === '=') this.#handlers.zoom(0.8);
    else if (key === '-') this.#handlers.zoom(1.25);
    else if (key === 'escape') this.#handlers.escape();
    else return false;
    return true;
  }
}

const pressOf = (event: PointerEvent) => ({
  x: event.clientX,
  y: event.clientY,
  time: event.timeStamp,
  id: event.pointerId,
});

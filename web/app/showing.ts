/** What is on the screen: the newest answer of the solver, lit in the view at once, its numbers in the store once a frame. */
import type { Layout } from '../document/types.ts';
import type { OpeningLight, Shown } from '../solver/protocol.ts';
import type { Viewer } from '../viewer/types.ts';
import { createFrameBatch } from './state/frame-batch.ts';
import { fitLegend } from './state/legend-range.ts';
import type { Progress, Store } from './state/store.ts';

export class Showing {
  readonly #store: Store;
  readonly #viewer: Viewer;
  readonly #later = createFrameBatch();
  #live: Shown | null = null; // the newest answer
  #colors: Float32Array | null = null; // of the light, as far as they are known
  #held: Layout | null = null; // of that answer, or newer: where a hand has just put the luminaires

  constructor(store: Store, viewer: Viewer) {
    this.#store = store;
    this.#viewer = viewer;
  }

  /** The layout shown now (or just put there by hand). */
  get layout(): Layout | null {
    return this.#held ?? this.#live?.layout ?? null;
  }

  /** The layout that a search goes on from; null = it starts from nowhere. */
  get held(): Layout | null {
    return this.#held;
  }

  /** Another room: nothing is shown of it yet. */
  clear(): void {
    this.#live = this.#held = this.#colors = null;
  }

  /** Takes a layout as the present one before its light is there; null: the light to come is that of a search from nowhere. */
  hold(layout: Layout | null): void {
    this.#held = layout;
  }

  /** The picture at once, the numbers with the next frame, and then `told`. */
  present(shown: Shown, progress: Progress, told: (shown: Shown) => void): void {
    this.#live = shown;
    this.#held = shown.layout;
    this.#light(shown);
    this.#later(() => {
      this.#store.shown.value = shown;
      this.#store.progress.value = progress;
      if (this.#store.display.peek().mode === 'falseColor') fitLegend(this.#store, shown);
      told(shown);
    });
  }

  /** The colour of the light that is shown, a moment after the light itself. */
  color(colors: Float32Array): void {
    this.#colors = colors;
    if (this.#store.preview.peek() === null) this.#viewer.setLightColor(colors);
  }

  /** Shows light of which no more is known yet than how it looks. */
  foresee({ layout, illuminance }: OpeningLight): void {
    if (this.#store.preview.peek() !== null) return;
    this.#viewer.setLight(illuminance);
    this.#viewer.setLayout(layout, this.#store.document.peek().luminaires.pinned);
  }

  /** Hands the light that is there to the view again. */
  relight(): void {
    if (!this.#live || this.#store.preview.peek() !== null) return;
    this.#light(this.#live);
    if (this.#colors) this.#viewer.setLightColor(this.#colors);
  }

  #light({ illuminance, layout }: Shown): void {
    if (this.#store.preview.peek() !== null) return;
    this.#viewer.setLight(illuminance);
    this.#viewer.setLayout(layout, this.#store.document.peek().luminaires.pinned);
  }
}

/**
 * What is on the screen: the newest answer of the solver, lit in the view at once, its numbers in the store once a frame.
 * The page keeps its own order of luminaires (L1 stays L1); everything that goes to the core passes here.
 */
import type { Layout } from '../document/types.ts';
import type { Shown } from '../solver/protocol.ts';
import type { Viewer } from '../viewer/types.ts';
import { createFrameBatch } from './state/frame-batch.ts';
import { fitLegend } from './state/legend-range.ts';
import { coreOrder, fromCore, toCore, type Order } from './state/luminaire-order.ts';
import type { Progress, Store } from './state/store.ts';

export class Showing {
  readonly #store: Store;
  readonly #viewer: Viewer;
  readonly #later = createFrameBatch();
  #live: Shown | null = null; // the newest answer, in the page's order
  #held: Layout | null = null; // of that answer, or newer: where a hand has just put the luminaires
  #order: Order = [];

  constructor(store: Store, viewer: Viewer) {
    this.#store = store;
    this.#viewer = viewer;
  }

  /** The layout shown now (or just put there by hand), in the page's order. */
  get layout(): Layout | null {
    return this.#held ?? this.#live?.layout ?? null;
  }

  /** The layout that a search goes on from; null = it starts from nowhere. */
  get held(): Layout | null {
    return this.#held;
  }

  /** Another room: nothing is shown of it yet. */
  clear(): void {
    this.#live = this.#held = null;
    this.#order = [];
  }

  /** Takes a layout as the present one before its light is there, and gives it in the core's order. */
  hold(layout: Layout): Layout {
    this.#held = layout;
    this.#order = this.#orderOf(layout);
    return toCore(layout, this.#order);
  }

  /** The light to come is that of a search from nowhere. */
  release(): void {
    this.#held = null;
    this.#order = [];
  }

  /** A layout of the page in the core's order, only to ask about it. */
  inCoreOrder(layout: Layout): Layout {
    return toCore(layout, this.#orderOf(layout));
  }

  /** The picture at once, the numbers with the next frame, and then `told`. */
  present(answer: Shown, progress: Progress, told: (shown: Shown) => void): void {
    const shown = { ...answer, layout: fromCore(answer.layout, this.#order) };
    this.#live = shown;
    this.#held = shown.layout;
    this.relight();
    this.#later(() => {
      const { display, legendLocked } = this.#store;
      this.#store.shown.value = shown;
      this.#store.progress.value = progress;
      if (display.peek().mode === 'falseColor' && !legendLocked.peek()) fitLegend(this.#store, shown);
      told(shown);
    });
  }

  /** Hands the light that is there to the view (again). */
  relight(): void {
    if (!this.#live || this.#store.preview.peek() !== null) return;
    this.#viewer.setLight(this.#live.illuminance);
    performance.mark('light set');
    this.#viewer.setLayout(this.#live.layout, this.#store.document.peek().luminaires.pinned);
  }

  #orderOf(layout: Layout): Order {
    return coreOrder(layout, this.#store.document.peek().luminaires.pinned);
  }
}

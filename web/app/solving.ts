/**
 * Between the store, the worker and the view: each edit asks the solver at once, each answer lights the room at once.
 * The numbers of the panel follow once a frame; the picture never waits for them.
 */
import type { Intentions, Layout, SceneInfo } from '../document/types.ts';
import type { FromWorker, Shown } from '../solver/protocol.ts';
import { createSolverClient, type SolverClient, type WorkerLike } from '../solver/solver-client.ts';
import type { Viewer } from '../viewer/types.ts';
import { coreOrder, fromCore, toCore, type Order } from './state/luminaire-order.ts';
import { sentence } from './words/format.ts';
import { createFrameBatch } from './state/frame-batch.ts';
import { fitLegend } from './state/legend-range.ts';
import type { Message, Progress, Store } from './state/store.ts';

export interface Solving {
  /** Resolves when the scene is open; rejects with one readable line. */
  open(bytes: ArrayBuffer): Promise<{ scene: SceneInfo; room: ArrayBuffer }>;
  /** Searches for what the document asks, from the layout shown. `event`: the input that asked. */
  solve(event?: Event): void;
  /** The same from this layout (a luminaire under the hand). */
  solveFrom(layout: Layout): void;
  /** Searches anew, from nowhere. */
  solveAfresh(): void;
  /** Shows exactly this layout. */
  show(layout: Layout): void;
  /** After an undo or redo: shows the step's layout, or searches where it has none. */
  travel(step: { readonly layout: Layout | null } | undefined): void;
  findAlpha(card: string, intentions: Intentions): void;
  /** Recomputes the layout shown from the patches; the answer is store.check. */
  check(): void;
  /** Runs other intentions to their end and returns the light they reach; the document's stay. */
  probe(intentions: Intentions): Promise<Shown>;
  /** The layout shown now (or just put there by hand), in the page's order. */
  layout(): Layout | null;
  /** Hands the light that is there to the view again. */
  relight(): void;
  resume(): void;
  stop(): void;
}

/** Something newer was asked for: nothing that a person has to be told. */
export class Superseded extends Error {}

interface Waiting<T> {
  readonly resolve: (value: T) => void;
  readonly reject: (error: Error) => void;
}

export function createSolving(store: Store, viewer: Viewer, createWorker: () => WorkerLike): Solving {
  let client: SolverClient = createSolverClient(createWorker, receive);
  let opening: Waiting<{ scene: SceneInfo; room: ArrayBuffer }> | null = null;
  let arrived: ArrayBuffer | null = null; // the display mesh of the scene that is being opened
  let probing: Waiting<Shown> | null = null;
  let file: ArrayBuffer | null = null;
  let live: Shown | null = null; // the newest answer, in the page's order
  let current: Layout | null = null; // of that answer, or newer: where a hand has just put the luminaires
  let order: Order = [];
  let checking: Layout | null = null; // was asked to be checked
  let refusal: number | null = null; // the message about a wish that the solver refused
  const later = createFrameBatch();

  function receive(message: FromWorker): void {
    switch (message.type) {
      case 'ready':
        return;
      case 'room':
        arrived = message.room;
        viewer.prepare(arrived);
        return;
      case 'opened':
        if (arrived) opening?.resolve({ scene: message.scene, room: arrived });
        opening = arrived = null;
        return;
      case 'improved':
      case 'settled':
        return answered(message);
      case 'alphaStep': {
        const run = store.alphaRun.peek();
        if (run) store.alphaRun.value = { ...run, steps: [...run.steps, message.step] };
        return;
      }
      case 'alphaDone': {
        const run = store.alphaRun.peek();
        const { alpha, verdict, feasibleBound, shown } = message;
        if (!run) return;
        store.alphaRun.value = { ...run, done: { alpha, verdict, feasibleBound } };
        store.announcement.value = verdict;
        if (alpha !== null && shown) alphaFound(run.card, alpha, shown);
        else solve();
        return;
      }
      case 'bounded':
        store.bound.value = { gap: message.gap, done: message.done };
        return;
      case 'checked': {
        const { largestDifference, surface, margins } = message;
        if (checking) store.check.value = { layout: checking, largestDifference, surface, margins };
        return;
      }
      case 'failed':
        return failed(message.message);
      default:
        message satisfies never;
    }
  }

  function answered(message: Extract<FromWorker, { type: 'improved' | 'settled' }>): void {
    if (probing) {
      if (message.type === 'improved') return;
      probing.resolve(message.shown);
      probing = null;
      return;
    }
    forgetRefusal();
    const isShown = message.evaluations === 0;
    const state = isShown ? 'shown' : message.type === 'settled' ? 'settled' : 'improving';
    const { evaluations, milliseconds } = message;
    present(message.shown, { state, evaluations, milliseconds });
  }

  function relight(): void {
    if (!live || store.preview.peek() !== null) return;
    viewer.setLight(live.illuminance);
    performance.mark('light set');
    viewer.setLayout(live.layout, store.document.peek().luminaires.pinned);
  }

  function present(answer: Shown, progress: Progress): void {
    const shown = { ...answer, layout: fromCore(answer.layout, order) };
    const { state } = progress;
    live = shown;
    current = shown.layout;
    relight();
    later(() => {
      store.shown.value = shown;
      store.progress.value = progress;
      if (store.display.peek().mode === 'falseColor' && !store.legendLocked.peek()) fitLegend(store, shown);
      if (state === 'settled') settled(shown);
    });
  }

  /** The card takes the alpha that was found, and its layout is shown: nothing is searched again. */
  function alphaFound(card: string, alpha: number, shown: Shown): void {
    store.edit('Find alpha', (draft) => {
      const guarantee = draft.cards.find((each) => each.id === card)?.guarantee;
      if (guarantee) Object.assign(guarantee, { alpha, by: 'chebyshev' });
    });
    const { evaluations, milliseconds } = store.progress.peek();
    present(shown, { state: 'settled', evaluations, milliseconds });
  }

  function settled(shown: Shown): void {
    const unmet = shown.constraints.filter((constraint) => !constraint.met).length;
    const met = unmet === 0 ? 'every intention is met' : `${unmet} bounds cannot be met`;
    store.announcement.value = `Settled: ${shown.layout.sites.length} luminaires, ${met}.`;
    const { intentions } = store.traced.peek();
    if (intentions.goals.length > 0 && unmet === 0) client.bound(intentions);
  }

  function failed(message: string): void {
    const wasOpening = opening !== null;
    if (opening) opening.reject(new Error(message));
    else if (probing) probing.reject(new Error(message));
    else {
      const isDead = /solver stopped/.test(message); // the client has given up on its workers
      forgetRefusal();
      refusal = store.say('error', sentence(message), isDead ? { label: 'Resume', run: resume } : wayBack());
    }
    opening = probing = arrived = null;
    // A file that cannot be opened takes nothing from what is shown, except a search that was running.
    const isOver = wasOpening && store.progress.peek().state !== 'improving';
    if (!isOver) store.progress.value = { state: 'idle', evaluations: 0, milliseconds: 0 };
    if (store.alphaRun.peek()?.done === null) store.alphaRun.value = null;
  }

  /** A refused wish is told once: the next refusal replaces the message, an answer takes it away. */
  function forgetRefusal(): void {
    if (refusal !== null) store.dismiss(refusal);
    refusal = null;
  }

  /** One click back to what could be solved, where an edit asked for what cannot. */
  function wayBack(): Message['action'] {
    const wasAsked = store.progress.peek().state === 'improving' && store.history.peek().past.length > 0;
    return wasAsked ? { label: 'Undo', run: () => travel(store.undo()) } : undefined;
  }

  function travel(step: { readonly layout: Layout | null } | undefined): void {
    if (!step) return;
    store.display.value = { ...store.display.peek(), quantity: store.document.peek().quantity };
    if (step.layout) show(step.layout);
    else solve();
  }

  function show(layout: Layout): void {
    const intentions = begin();
    current = layout;
    order = coreOrder(layout, intentions.luminaires.pinned);
    client.show(intentions, toCore(layout, order));
  }

  /** A fresh worker with the same room; the last good layout stays and the search goes on from it. */
  function resume(): void {
    const bytes = file;
    if (!bytes) return;
    client.dispose();
    client = createSolverClient(createWorker, receive);
    open(bytes).then(
      () => solve(),
      (error: Error) => store.say('error', sentence(error.message)),
    );
  }

  function open(bytes: ArrayBuffer): Promise<{ scene: SceneInfo; room: ArrayBuffer }> {
    opening?.reject(new Superseded());
    probing?.reject(new Superseded());
    probing = arrived = null;
    return new Promise<{ scene: SceneInfo; room: ArrayBuffer }>((resolve, reject) => {
      opening = { resolve, reject };
      client.open(bytes);
    }).then((opened) => {
      file = bytes;
      return opened;
    });
  }

  function begin(): Intentions {
    probing?.reject(new Superseded());
    probing = null;
    if (store.bound.peek()) store.bound.value = null;
    return store.traced.peek().intentions;
  }

  function solve(event: Event | undefined = globalThis.event, start: Layout | null = current): void {
    if (!store.scene.peek()) return;
    const intentions = begin();
    const at = event && event.timeStamp > 0 ? event.timeStamp : performance.now();
    current = start;
    order = start ? coreOrder(start, intentions.luminaires.pinned) : [];
    const seed = store.document.peek().seed;
    client.solve(intentions, start && toCore(start, order), seed, performance.timeOrigin + at);
    const { evaluations, milliseconds } = store.progress.peek();
    store.progress.value = { state: 'improving', evaluations, milliseconds };
  }

  return {
    open: (bytes) =>
      open(bytes).then((opened) => {
        live = current = null;
        order = [];
        return opened;
      }),
    solve: (event) => solve(event),
    solveFrom: (layout) => solve(undefined, layout),
    solveAfresh: () => solve(undefined, null),
    show,
    travel,
    findAlpha(card, intentions) {
      begin();
      store.alphaRun.value = { card, steps: [], done: null };
      client.alpha(intentions, store.document.peek().seed);
    },
    check() {
      const layout = store.shown.peek()?.layout;
      if (!layout) return;
      checking = layout;
      const { intentions } = store.traced.peek();
      client.check(intentions, toCore(layout, coreOrder(layout, intentions.luminaires.pinned)));
    },
    probe(intentions) {
      begin();
      return new Promise<Shown>((resolve, reject) => {
        probing = { resolve, reject };
        client.solve(intentions, null, 1, performance.timeOrigin + performance.now());
      });
    },
    layout: () => current ?? live?.layout ?? null,
    relight,
    resume,
    stop: () => client.stop(),
  };
}

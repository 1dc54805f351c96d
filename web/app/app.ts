/** The app put together: store, solver, view and what people do with them. Components get it by context. */
import { effect } from '@preact/signals';
import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import { keepRange } from '../document/intentions.ts';
import type { Card, Display, Layout, Quantity, Verb } from '../document/types.ts';
import type { WorkerLike } from '../solver/solver-client.ts';
import type { CreateViewer, Viewer, ViewerEvents } from '../viewer/types.ts';
import { createActions, type Action } from './actions.ts';
import { rooms } from './rooms/catalog.ts';
import { createHand, type Hand } from './hand.ts';
import { createLeaving, keepSaved, type Leaving } from './keeping.ts';
import { createOpening, type Opening } from './opening/opening.ts';
import { fitLegend } from './state/legend-range.ts';
import { createSolving, type Solving } from './solving.ts';
import { leavesOf } from './state/statistics.ts';
import type { Store } from './state/store.ts';

export interface App {
  readonly store: Store;
  readonly solving: Solving;
  readonly viewer: Viewer;
  readonly hand: Hand;
  readonly opening: Opening;
  readonly leaving: Leaving;
  readonly actions: readonly Action[];
  /** Adds a card for the selected surface (or `names`) and opens it. */
  addCard(verb?: Verb, names?: readonly string[]): void;
  changeCard(id: string, label: string, change: (card: Card) => Card, gesture?: string): void;
  removeCard(id: string): void;
  setQuantity(quantity: Quantity): void;
  setMode(mode: Display['mode']): void;
  setDisplay(change: Partial<Display>): void;
  reseed(): void;
  selectSurface(surface: number | null): void;
  travel(step: { label: string; layout: Layout | null } | undefined, done: string): void;
  pickFile(): void;
}

export const AppContext = createContext<App | null>(null);

export function useApp(): App {
  const app = useContext(AppContext);
  if (!app) throw new Error('useApp: there is no app around this component');
  return app;
}

export interface Parts {
  readonly canvas: HTMLCanvasElement;
  readonly labels: HTMLElement;
  readonly createViewer: CreateViewer;
  readonly createWorker: () => WorkerLike;
}

export function createApp(store: Store, { canvas, labels, createViewer, createWorker }: Parts): App {
  const viewer = createViewer(
    canvas,
    labels,
    eventsOf(store, () => app),
  );
  const solving = createSolving(store, viewer, createWorker);
  const hand = createHand(store, solving);
  const opening = createOpening(store, solving, viewer);
  const leaving = createLeaving(store, solving, viewer);

  const changed = (did: boolean) => {
    if (did) solving.solve();
  };
  const app: App = {
    store,
    solving,
    viewer,
    hand,
    opening,
    leaving,
    get actions() {
      return actions;
    },
    addCard(verb = 'homogenize', names) {
      const scene = store.scene.peek();
      const selected = scene?.surfaces[store.surface.peek() ?? -1]?.name;
      const surfaces = names ?? [selected ?? 'all'];
      const id = crypto.randomUUID().slice(0, 8);
      const row = store.shown.peek()?.surfaces.find((each) => each.name === surfaces[0]);
      const mean = verb === 'keep' && row ? { mean: keepRange(row.mean) } : {};
      const card: Card = { id, surfaces, verb, weight: 1, ...mean };
      const did = store.edit(`Add ${verb}`, (draft) => void draft.cards.push(structuredClone(card) as never));
      store.tab.value = 'intentions';
      store.card.value = id;
      store.announcement.value = `Intention added: ${verb} ${surfaces.join(', ')}.`;
      changed(did);
    },
    changeCard(id, label, change, gesture) {
      const did = store.edit(
        label,
        (draft) => {
          const index = draft.cards.findIndex((card) => card.id === id);
          const card = store.document.peek().cards[index];
          if (card) draft.cards[index] = change(card) as never;
        },
        gesture,
      );
      changed(did);
    },
    removeCard(id) {
      changed(
        store.edit('Remove an intention', (draft) => {
          draft.cards = draft.cards.filter((card) => card.id !== id);
        }),
      );
    },
    setQuantity(quantity) {
      const surfaces = store.scene.peek()?.surfaces ?? [];
      const onPlane = store.document
        .peek()
        .cards.flatMap((card) => card.surfaces)
        .find((name) => leavesOf([name], surfaces).some((leaf) => surfaces[leaf]?.measuring));
      if (quantity === 'exitance' && onPlane !== undefined) {
        store.say(
          'warning',
          `“${onPlane}” is a measuring plane and reflects nothing: aim its intention at a surface first.`,
        );
        return;
      }
      const did = store.edit('Change the quantity', (draft) => void (draft.quantity = quantity));
      app.setDisplay({ quantity });
      changed(did);
    },
    setMode(mode) {
      app.setDisplay({ mode });
      const shown = store.shown.peek();
      if (mode === 'falseColor' && shown && !store.legendLocked.peek()) fitLegend(store, shown);
    },
    setDisplay: (change) => void (store.display.value = { ...store.display.peek(), ...change }),
    reseed() {
      store.edit('Search with another seed', (draft) => void (draft.seed = (draft.seed % 0xffff) + 1));
      solving.solveAfresh();
    },
    selectSurface(surface) {
      store.surface.value = surface;
      const name = store.scene.peek()?.surfaces[surface ?? -1]?.name;
      const card = store.document
        .peek()
        .cards.find((each) => name !== undefined && each.surfaces.includes(name));
      if (card) store.card.value = card.id;
      if (name) store.announcement.value = `Selected ${name}.`;
    },
    travel(step, done) {
      if (!step) return;
      store.announcement.value = `${done}: ${step.label}.`;
      solving.travel(step);
    },
    pickFile() {
      const input = document.createElement('input');
      input.type = 'file';
      input.accept = '.flux,.glb,.json,.fiatlux';
      input.onchange = () => {
        const file = input.files?.[0];
        if (file) void opening.file(file);
      };
      input.click();
    },
  };
  const actions = createActions(app);
  bindViewer(app);
  keepSaved(store, leaving.project, (id) => rooms.some((room) => room.room === id));
  return app;
}

/** What the view tells the app. */
function eventsOf(store: Store, app: () => App): ViewerEvents {
  return {
    hovered: (surface, at) => void (store.hover.value = surface !== null && at ? { surface, ...at } : null),
    surfacePicked: (surface) => app().selectSurface(surface),
    luminairePicked: (luminaire) => void (store.luminaire.value = luminaire),
    luminaireDragged: (luminaire, site) => app().hand.moveTo(luminaire, site, true),
    luminaireDropped: (luminaire, site) => app().hand.moveTo(luminaire, site, false),
    cameraMoved: (camera) => void (store.camera.value = camera),
    contextLost(lost) {
      if (lost) store.say('warning', 'The graphics card was taken away. The picture comes back by itself.');
      else store.announcement.value = 'The picture is back.';
    },
  };
}

/** What the app tells the view, whenever it changes. */
function bindViewer({ store, viewer }: App): void {
  effect(() => viewer.setDisplay(store.display.value));
  effect(() => viewer.setSelection(store.surface.value, store.luminaire.value));
  effect(() => viewer.setExcluded(store.document.value.luminaires.excluded));
}

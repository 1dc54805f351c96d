/** The app put together: store, solver, view and what people do with them. Components get it by context. */
import { effect } from '@preact/signals';
import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import { markedAreas, type MarkedArea } from '../document/areas.ts';
import { eachText } from './words/places.ts';
import { keepRange } from '../document/intentions.ts';
import { leafBehind, markedTasks } from '../document/task-areas.ts';
import { leavesOf } from '../document/surface-names.ts';
import type { Camera, Card, Display, NamedView, Quantity, Verb } from '../document/types.ts';
import type { WorkerLike } from '../solver/solver-client.ts';
import type { CreateViewer, Viewer, ViewerEvents } from '../viewer/types.ts';
import { BestFinding } from './best-figures.ts';
import { Challenge } from './challenge.ts';
import { Comparing } from './comparing.ts';
import { Film } from './film.ts';
import { Hand } from './hand.ts';
import { holdDuringGestures } from './held-exposure.ts';
import { Keeping } from './keeping.ts';
import type { CreatePool } from './lighting/lighting.ts';
import { TaskAreas } from './task-areas.ts';
import { LuminaireTypes } from './luminaires/luminaire-types.ts';
import { Opening } from './opening/opening.ts';
import { Painting } from './painting.ts';
import { takeOwnPictures } from './rooms/own-pictures.ts';
import { OwnRooms } from './rooms/own-rooms.ts';
import { Rooms } from './rooms/rooms.ts';
import { Solving } from './solving.ts';
import { fitLegend } from './state/legend-range.ts';
import type { Store } from './state/store.ts';
import { Variants } from './variants.ts';
import { words } from '../language/language.ts';
import { roomSurfaces, surfaceText, unnamedFloor } from '../language/surface-names.ts';
import { unnamedFloorOf } from './words/provenance.ts';

export interface Parts {
  readonly canvas: HTMLCanvasElement;
  readonly labels: HTMLElement;
  readonly createViewer: CreateViewer;
  readonly createWorker: () => WorkerLike;
  readonly createPool?: CreatePool; // the page's own, unless a test has another
}

export class App {
  readonly store: Store;
  readonly rooms = new Rooms();
  readonly own = new OwnRooms();
  readonly viewer: Viewer;
  readonly solving: Solving;
  readonly hand: Hand;
  readonly tasks: TaskAreas;
  readonly comparing: Comparing;
  readonly opening: Opening;
  readonly keeping: Keeping;
  readonly types: LuminaireTypes;
  readonly painting: Painting;
  readonly variants: Variants;
  readonly film: Film;
  readonly challenge: Challenge;

  constructor(store: Store, { canvas, labels, createViewer, createWorker, createPool }: Parts) {
    this.store = store;
    this.viewer = createViewer(canvas, labels, this.#viewerEvents());
    this.solving = new Solving(store, this.viewer, createWorker);
    this.hand = new Hand(store, this.solving);
    this.tasks = new TaskAreas(store);
    this.comparing = new Comparing(store, this.solving);
    new BestFinding(store, this.solving);
    this.types = new LuminaireTypes(store, this.solving);
    this.painting = new Painting(store, this.solving, this.viewer);
    this.keeping = new Keeping(store, this.solving, this.viewer, this.types);
    this.opening = new Opening(
      store,
      this.rooms,
      this.solving,
      this.viewer,
      this.keeping,
      this.types,
      this.own,
      createPool,
    );
    this.variants = new Variants(store, this.solving, this.viewer);
    this.challenge = new Challenge(store, this.solving, this.variants);
    this.film = new Film(store, this.solving, this.viewer, this.variants);
    store.planSource.value = () => this.viewer.plan();
    this.#tellViewer();
    effect(() => {
      unnamedFloor.value = store.scene.value && unnamedFloorOf(store.scene.value);
      roomSurfaces.value = store.scene.value?.surfaces.map(({ name }) => name) ?? [];
    });
    takeOwnPictures(store, this.viewer, this.own);
    this.keeping.keepSaved((room) => this.rooms.has(room) || this.own.has(room));
  }

  /** Adds a card for the selected surface (or `names`) and opens it. */
  addCard(verb: Verb = 'homogenize', names?: readonly string[]): void {
    const { store } = this;
    const selected = store.sceneWithAreas.peek()?.surfaces[store.surface.peek() ?? -1]?.name;
    const surfaces = names ?? [selected ?? 'all'];
    const row = store.shown.peek()?.surfaces.find((each) => each.name === surfaces[0]);
    const mean = verb === 'keep' && row ? { mean: keepRange(row.mean) } : {};
    const card: Card = { id: crypto.randomUUID().slice(0, 8), surfaces, verb, weight: 1, ...mean };
    store.edit(
      words.value.steps.addCard(words.value.intentions.verbs[verb].title.toLowerCase()),
      (draft) => void draft.cards.push(structuredClone(card) as never),
    );
    store.tab.value = 'intentions';
    store.card.value = card.id;
    store.announcement.value = words.value.steps.cardAdded(
      words.value.intentions.verbs[verb].title.toLowerCase(),
      eachText(surfaces),
    );
  }

  changeCard(id: string, label: string, change: (card: Card) => Card, gesture?: string): void {
    const { store } = this;
    store.edit(
      label,
      (draft) => {
        const index = draft.cards.findIndex((card) => card.id === id);
        const card = store.document.peek().cards[index];
        if (card) draft.cards[index] = change(card) as never;
      },
      gesture,
    );
  }

  removeCard(id: string): void {
    this.store.edit(words.value.steps.removeCard, (draft) => {
      draft.cards = draft.cards.filter((card) => card.id !== id);
    });
  }

  setQuantity(quantity: Quantity): void {
    const { store } = this;
    const plane = quantity === 'exitance' ? this.#planeAskedFor() : undefined;
    if (plane === undefined) {
      store.edit(words.value.steps.quantity, (draft) => void (draft.quantity = quantity));
      return;
    }
    store.say('warning', words.value.steps.planeReflects(plane));
  }

  setMode(mode: Display['mode']): void {
    this.setDisplay({ mode });
    const shown = this.store.shown.peek();
    if (mode === 'falseColor' && shown) fitLegend(this.store, shown);
  }

  setDisplay(change: Partial<Display>): void {
    this.store.display.value = { ...this.store.display.peek(), ...change };
  }

  /** Cuts the picture at a height (m), or shows the whole room. */
  setSection(section: number | null): void {
    const { section: _, ...display } = this.store.display.peek();
    const height = Math.round(100 * (section ?? 0)) / 100;
    this.store.display.value = section === null ? display : { ...display, section: height };
  }

  /** Stands in a room of a building: no cut goes through it. */
  standAt(camera: Camera): void {
    this.setSection(null);
    this.viewer.flyTo(camera);
  }

  /** Another kind of scale: its ends follow, unless they are locked. */
  setScale(change: Pick<Partial<Display>, 'steps' | 'logarithmic'>): void {
    this.setDisplay(change);
    const shown = this.store.shown.peek();
    if (shown) fitLegend(this.store, shown);
  }

  /** Keeps the exposure as it is now, or lets it follow the light again. */
  lockExposure(on: boolean): void {
    const { exposureLevel: _, ...display } = this.store.display.peek();
    this.store.display.value = on
      ? { ...display, exposureLevel: Math.max(0.001, this.viewer.exposureLevel()) }
      : display;
  }

  /** Searches from nowhere, with another seed. */
  reseed(): void {
    this.store.edit(words.value.steps.seed, (draft) => void (draft.seed = (draft.seed % 0xffff) + 1), null, {
      by: 'search',
      from: null,
    });
  }

  /** Keeps the view that is on the screen; one of the same name goes. */
  keepView(name: string): void {
    const view = { name, camera: this.viewer.camera() };
    const others = (this.store.document.peek().views ?? []).filter((each) => each.name !== name);
    this.#setViews(words.value.steps.keepView(name), [...others, view]);
    this.store.announcement.value = words.value.steps.viewKept(name);
  }

  forgetView(name: string): void {
    const views = this.store.document.peek().views ?? [];
    this.#setViews(
      words.value.steps.forgetView(name),
      views.filter((each) => each.name !== name),
    );
  }

  #setViews(label: string, views: readonly NamedView[]): void {
    this.store.edit(label, (draft) => void (draft.views = structuredClone(views) as never), null, {
      by: 'nothing',
    });
  }

  selectSurface(surface: number | null): void {
    const { store } = this;
    store.surface.value = surface;
    const name = store.sceneWithAreas.peek()?.surfaces[surface ?? -1]?.name;
    if (name === undefined) return;
    const card = store.document.peek().cards.find((each) => each.surfaces.includes(name));
    if (card) store.card.value = card.id;
    store.announcement.value = words.value.steps.selected(surfaceText(name));
  }

  /** Shows how a surface is painted. */
  paint(surface: number | null): void {
    if (surface !== null) this.selectSurface(surface);
    this.store.tab.value = 'results';
    this.store.paintAsked.value = true;
  }

  undo(): void {
    if (this.store.undoes.peek() === 'room') globalThis.history.back();
    else this.#announce(words.value.steps.undone, this.store.undo());
  }

  redo(): void {
    if (this.store.redoes.peek() === 'room') globalThis.history.forward();
    else this.#announce(words.value.steps.redone, this.store.redo());
  }

  #announce(done: string, label: string | undefined): void {
    if (label !== undefined) this.store.announcement.value = `${done}: ${label}.`;
  }

  /** A measuring plane that an intention is aimed at, if any. */
  #planeAskedFor(): string | undefined {
    const surfaces = this.store.sceneWithAreas.peek()?.surfaces ?? [];
    const names = this.store.document.peek().cards.flatMap((card) => card.surfaces);
    return names.find((name) => leavesOf([name], surfaces).some((leaf) => surfaces[leaf]?.measuring));
  }

  /** All areas in plan, to be drawn: also measuring planes that are not lit yet. */
  markedAreas(): MarkedArea[] {
    const { document, scene, sceneWithAreas, sheet, surface } = this.store;
    const { luminaires, taskAreas } = document.value;
    const room = scene.value;
    const chosen = sceneWithAreas.value?.surfaces[surface.value ?? -1]?.name ?? null;
    return [
      ...markedAreas(luminaires.areas),
      ...(room && taskAreas ? markedTasks(room, taskAreas, chosen) : []),
      ...(sheet.value?.choices.drawn ?? []).map(({ outline, height }) => ({
        kind: 'plane' as const,
        outline,
        height,
      })),
    ];
  }

  /** What the view tells the app. */
  #viewerEvents(): ViewerEvents {
    const { store } = this;
    return {
      hovered: (surface, at) => void (store.hover.value = surface !== null && at ? { surface, ...at } : null),
      surfacePicked: (surface, place) => {
        if (!store.sheet.peek()?.isPicking) this.selectSurface(surface);
        else if (place) this.opening.lighting.sheet?.standAt(place);
      },
      luminairePicked: (luminaire, how) => this.hand.pick(luminaire, how),
      luminaireDragged: (luminaire, site) => this.hand.moveTo(luminaire, site, true),
      luminaireDropped: (luminaire, site) => this.hand.moveTo(luminaire, site, false),
      cameraMoved: (camera) => void (store.camera.value = camera),
      contextLost(lost) {
        if (lost) store.say('warning', words.value.steps.graphicsLost);
        else store.announcement.value = words.value.steps.graphicsBack;
      },
    };
  }

  /** What the app tells the view, whenever it changes. */
  #tellViewer(): void {
    const { store, viewer } = this;
    effect(() => {
      const { value: display } = store.display;
      // Nothing hangs between a click and the room that it is to choose.
      viewer.setDisplay(store.sheet.value?.isPicking ? { ...display, luminaires: false } : display);
    });
    holdDuringGestures(store, viewer);
    effect(() => viewer.setBodies(this.types.bodies.value, this.types.bodiesOf(this.variants.types)));
    effect(() => {
      // A realistic picture stays one: who looks where is seen beside the numbers.
      const isMeasured = store.tab.value === 'results' || store.display.value.mode === 'falseColor';
      viewer.setObservers(isMeasured ? (store.shown.value?.observers ?? []) : []);
    });
    effect(() => {
      const { value: surface } = store.surface;
      const scene = store.sceneWithAreas.value;
      const leaf = surface === null || !scene ? surface : leafBehind(scene, surface);
      viewer.setSelection(leaf, store.luminaires.value);
    });
    effect(() => viewer.setGhosts(store.ghosts.value));
    effect(() => viewer.setAreas(this.markedAreas()));
    effect(() => viewer.setBarred(store.barred.value, store.crossed.value));
  }
}

export const AppContext = createContext<App | null>(null);

export function useApp(): App {
  const app = useContext(AppContext);
  if (!app) throw new Error('useApp: there is no app around this component');
  return app;
}

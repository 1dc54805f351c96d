/** Puts a room on the screen, solver and picture together: all of it or nothing, and the latest wish wins. */
import { batch } from '@preact/signals';
import { planOfScene } from '../../document/made-room.ts';
import type { Link } from '../../document/share-link.ts';
import type { FiatLuxDocument, Layout, SceneInfo } from '../../document/types.ts';
import type { FileBytes } from '../../solver/solver-client.ts';
import type { Viewer } from '../../viewer/types.ts';
import type { History } from '../../document/history.ts';
import type { PhotometricFiles } from '../../document/photometric-files.ts';
import type { Keeping } from '../keeping.ts';
import type { LuminaireTypes } from '../luminaires/luminaire-types.ts';
import type { OpeningView } from '../rooms/catalog-file.ts';
import type { Rooms } from '../rooms/rooms.ts';
import { Superseded, type Solving } from '../solving.ts';
import { leavesOf } from '../../document/surface-names.ts';
import { firstDisplay, type Store } from '../state/store.ts';
import { sentence } from '../words/format.ts';
import { tellRoom } from './address.ts';
import { rememberRoom } from './first-scene.ts';
import { words } from '../../language/language.ts';
import { reasonOf } from '../../document/reason.ts';

/** What is on the screen: its file, and what the solver made of it. */
interface Placed {
  readonly bytes: FileBytes;
  readonly room: ArrayBuffer;
  readonly scene: SceneInfo;
}

export interface Placement {
  readonly document: FiatLuxDocument;
  readonly history?: Pick<History, 'past' | 'future'>;
  readonly view?: Pick<Link, 'camera' | 'display'>;
  readonly first?: OpeningView | null; // where there is no view
  readonly files?: PhotometricFiles | undefined; // of its luminaire types
}

/** Leaves that the intentions name, but for those about the whole room. */
const aimsOf = ({ cards }: FiatLuxDocument, { surfaces }: SceneInfo): number[] =>
  leavesOf(
    cards.flatMap((card) => card.surfaces.filter((name) => name !== 'all')),
    surfaces,
  );

export class Placing {
  readonly #store: Store;
  readonly #rooms: Rooms;
  readonly #solving: Solving;
  readonly #viewer: Viewer;
  readonly #keeping: Keeping;
  readonly #types: LuminaireTypes;
  #turn = 0; // the latest wish to open something wins
  #placed: Placed | null = null;

  constructor(
    store: Store,
    rooms: Rooms,
    solving: Solving,
    viewer: Viewer,
    keeping: Keeping,
    types: LuminaireTypes,
  ) {
    this.#store = store;
    this.#rooms = rooms;
    this.#solving = solving;
    this.#viewer = viewer;
    this.#keeping = keeping;
    this.#types = types;
  }

  /** The latest wish to open something. */
  get turn(): number {
    return this.#turn;
  }

  /**
   * Runs one opening; errors become one message with a button to try again, and what was on the screen stays. Resolves to
   * its success.
   */
  async attempt(what: string, action: (isCurrent: () => boolean) => Promise<void>): Promise<boolean> {
    const turn = ++this.#turn;
    const isCurrent = () => turn === this.#turn;
    this.#store.loading.value = what;
    try {
      await action(isCurrent);
      return true;
    } catch (error) {
      if (isCurrent() && !(error instanceof Superseded)) {
        const again = { label: words.value.opening.again, run: () => void this.attempt(what, action) };
        this.#store.say('error', sentence(reasonOf(error)), again);
      }
      return false;
    } finally {
      if (isCurrent()) this.#store.loading.value = null;
    }
  }

  /** What is still on its way must not come any more. */
  supersede(): void {
    this.#turn += 1;
    this.#store.loading.value = null;
  }

  /** Puts a scene on the screen. `make` gives its document; nothing changes before everything is there. */
  async place(
    bytes: FileBytes,
    title: string,
    isCurrent: () => boolean,
    make: (scene: SceneInfo) => Placement | Promise<Placement>,
    options: { readonly isReturn?: boolean; readonly isReplacement?: boolean } = {},
  ): Promise<void> {
    if (!isCurrent()) return;
    this.#remember();
    const layout = this.#solving.layout();
    performance.mark('scene fetched');
    const { scene, room } = await this.#solving.open(bytes).catch((error: unknown) => {
      if (isCurrent()) void this.#paint(); // the room on the screen stays, without the colours that the solver had of it
      throw error;
    });
    performance.mark('scene opened');
    if (!isCurrent()) return;
    let placement: Placement;
    try {
      placement = await make(scene);
      if (!isCurrent()) return; // else it would take the place of a preview that is there by now
      this.#viewer.setAims(aimsOf(placement.document, scene));
      await this.#viewer.open(room, scene);
      if (options.isReplacement) placement = await make(scene); // what was edited meanwhile comes along
    } catch (error) {
      // The solver has the new scene by now, the screen still the old one.
      if (isCurrent()) await this.#takeBack(layout);
      throw error;
    }
    if (!isCurrent()) return;
    performance.mark('room displayed');
    this.#placed = { bytes, room, scene };
    void this.#paint();
    this.#show(scene, title, placement, options.isReturn ?? false);
    tellRoom(placement.document.room);
  }

  /** Puts a better scene of the room that is on the screen in its place; false where something else was opened since. */
  async replace(bytes: ArrayBuffer, title: string, make: (scene: SceneInfo) => Placement): Promise<boolean> {
    const turn = this.#turn;
    const isCurrent = () => turn === this.#turn;
    const arrival = this.#store.arrival.peek();
    await this.place(bytes, title, isCurrent, make, { isReplacement: true });
    if (!isCurrent()) return false;
    this.#store.arrival.value = arrival;
    return true;
  }

  /** Finds out the colours of the room that is on the screen; the solver wants them (Painting). */
  async #paint(): Promise<void> {
    const placed = this.#placed;
    const colors = await this.#viewer.colors();
    if (colors && placed && placed === this.#placed)
      this.#store.patchColors.value = { scene: placed.scene, colors };
  }

  /** Shows the room that was open before a preview, as it was; false where there was none. */
  async restore(): Promise<boolean> {
    const back = this.#placed;
    if (!back) return false;
    return this.attempt(words.value.opening.goingBack, async (isCurrent) => {
      await this.#viewer.open(back.room, back.scene);
      if (!isCurrent()) return;
      this.#store.preview.value = null;
      this.#store.plan.value = planOfScene(back.scene);
      this.#solving.relight();
      this.#solving.goOn(); // its proof made way for the preview
    });
  }

  /** The app's whole state in one step; the new document then asks the solver by itself. */
  #show(scene: SceneInfo, title: string, placement: Placement, isReturn: boolean): void {
    const { document, history, view, first, files = {} } = placement;
    const store = this.#store;
    if (this.#rooms.has(document.room)) rememberRoom(document.room);
    batch(() => {
      this.#types.provide(files);
      store.scene.value = scene;
      store.roomTitle.value = title;
      store.preview.value = store.making.value = null;
      store.plan.value = planOfScene(scene);
      store.surface.value = null;
      store.luminaires.value = [];
      store.card.value = document.cards[0]?.id ?? null;
      store.alphaRun.value = store.bound.value = store.check.value = null;
      const isFirst = store.document.peek().scene === '';
      store.reset(document, history);
      const { past } = store.history.peek();
      store.arrival.value = isFirst ? null : { past, by: isReturn ? 'return' : 'opening' };
      const display = view?.display ?? {
        ...firstDisplay,
        mode: store.display.peek().mode,
        exposure: first?.exposure ?? 0,
      };
      store.display.value = { ...display, quantity: document.quantity };
    });
    void this.#types.findMissing();
    if (!view && !first) void this.#cutOpen();
    if (view?.camera) this.#viewer.setCamera(view.camera);
    else if (first) this.#viewer.setCamera({ ...first, plan: false });
    else this.#viewer.home();
  }

  /** A building is opened at the storey that is asked about, whose light those above would hide. */
  async #cutOpen(): Promise<void> {
    const placed = this.#placed;
    const section = await this.#viewer.openingCut();
    const display = this.#store.display.peek();
    if (section !== null && placed === this.#placed && display.section === undefined)
      this.#store.display.value = { ...display, section };
  }

  #remember(): void {
    const { room } = this.#store.document.peek();
    const bytes = this.#placed?.bytes;
    // A file that was still arriving is the site's own, and can be had again.
    this.#keeping.remember(this.#rooms.has(room) || bytes instanceof Promise ? null : (bytes ?? null));
  }

  /** Gives the solver the scene and the layout back that are on the screen. */
  async #takeBack(layout: Layout | null): Promise<void> {
    if (!this.#placed) return;
    await this.#solving.open(this.#placed.bytes);
    void this.#paint();
    if (layout) this.#solving.show(layout);
  }
}

/** Puts a room on the screen, solver and picture together: all of it or nothing, and the latest wish wins. */
import { batch } from '@preact/signals';
import type { Link } from '../../document/share-link.ts';
import type { FiatLuxDocument, Layout, SceneInfo } from '../../document/types.ts';
import type { Viewer } from '../../viewer/types.ts';
import { rooms } from '../rooms/catalog.ts';
import { rememberRoom } from './first-scene.ts';
import { sentence } from '../words/format.ts';
import { Superseded, type Solving } from '../solving.ts';
import { firstDisplay, type Store } from '../state/store.ts';

/** What is on the screen: its file, and what the solver made of it. */
interface Placed {
  readonly bytes: ArrayBuffer;
  readonly room: ArrayBuffer;
  readonly scene: SceneInfo;
}

export interface Placement {
  readonly document: FiatLuxDocument;
  readonly view?: Pick<Link, 'camera' | 'display'>;
}

export interface Placing {
  /** Runs one opening; errors become one message, and what was on the screen stays. Resolves to its success. */
  attempt(what: string, action: (isCurrent: () => boolean) => Promise<void>): Promise<boolean>;
  /** Puts a scene on the screen. `make` gives its document; nothing changes before everything is there. */
  place(
    bytes: ArrayBuffer,
    title: string,
    isCurrent: () => boolean,
    make: (scene: SceneInfo) => Placement,
  ): Promise<void>;
  /** Shows the room that was open before a preview, as it was; false where there was none. */
  restore(): Promise<boolean>;
}

export const isRoom = (id: string): boolean => rooms.some((room) => room.room === id);

export function createPlacing(store: Store, solving: Solving, viewer: Viewer): Placing {
  let turn = 0; // the latest wish to open something wins
  let placed: Placed | null = null;

  async function attempt(
    what: string,
    action: (isCurrent: () => boolean) => Promise<void>,
  ): Promise<boolean> {
    const mine = ++turn;
    store.loading.value = what;
    try {
      await action(() => mine === turn);
      return true;
    } catch (error) {
      if (mine === turn && !(error instanceof Superseded))
        store.say('error', sentence(error instanceof Error ? error.message : String(error)));
      return false;
    } finally {
      if (mine === turn) store.loading.value = null;
    }
  }

  async function place(
    bytes: ArrayBuffer,
    title: string,
    isCurrent: () => boolean,
    make: (scene: SceneInfo) => Placement,
  ): Promise<void> {
    if (!isCurrent()) return;
    const layout = solving.layout();
    performance.mark('scene fetched');
    const { scene, room } = await solving.open(bytes);
    performance.mark('scene opened');
    if (!isCurrent()) return;
    let made: Placement;
    try {
      made = make(scene);
      await viewer.open(room, scene);
    } catch (error) {
      // The solver has the new scene by now, the screen still the old one.
      if (isCurrent()) await takeBack(layout);
      throw error;
    }
    if (!isCurrent()) return;
    performance.mark('room displayed');
    const { document, view } = made;
    placed = { bytes, room, scene };
    if (isRoom(document.room)) rememberRoom(document.room);
    batch(() => {
      store.scene.value = scene;
      store.roomTitle.value = title;
      store.preview.value = null;
      store.surface.value = store.luminaire.value = null;
      store.card.value = document.cards[0]?.id ?? null;
      store.alphaRun.value = store.bound.value = store.check.value = null;
      store.reset(document);
      const display = view?.display ?? { ...firstDisplay, mode: store.display.peek().mode };
      store.legendLocked.value = Boolean(view?.display);
      store.display.value = { ...display, quantity: document.quantity };
    });
    if (view?.camera) viewer.setCamera(view.camera);
    else viewer.home();
    if (document.layout) solving.show(document.layout);
    else solving.solveAfresh();
  }

  /** Gives the solver the scene and the layout back that are on the screen. */
  async function takeBack(layout: Layout | null): Promise<void> {
    if (!placed) return;
    await solving.open(placed.bytes);
    if (layout) solving.show(layout);
  }

  async function restore(): Promise<boolean> {
    const back = placed;
    if (!back) return false;
    return attempt('Going back', async (isCurrent) => {
      await viewer.open(back.room, back.scene);
      if (!isCurrent()) return;
      store.preview.value = null;
      solving.relight();
    });
  }

  return {
    attempt,
    place,
    restore,
  };
}

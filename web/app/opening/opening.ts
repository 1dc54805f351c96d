/** Everything that puts another room on the screen: gallery, links, dropped files, projects, the last work. */
import { decodeLink, type Link } from '../../document/share-link.ts';
import { documentOf } from '../../document/sites.ts';
import { intentionsOf } from '../../document/intentions.ts';
import type { Project } from '../../document/project-file.ts';
import { cleanName } from '../../document/schema.ts';
import type { SceneInfo } from '../../document/types.ts';
import type { Viewer } from '../../viewer/types.ts';
import { forgetLink } from './address.ts';
import { documentFrom, entryOf, rooms, type GalleryEntry } from '../rooms/catalog.ts';
import { firstRoom, requestScene } from './first-scene.ts';
import { createFileOpening } from './opening-files.ts';
import { createPlacing, isRoom } from './placing.ts';
import type { Solving } from '../solving.ts';
import type { Store } from '../state/store.ts';

export interface Opening {
  entry(id: string): Promise<void>;
  file(file: File): Promise<void>;
  /** What the address asks for, or else (no link, or none that can be shown) the last work, or else the first room. */
  start(hash: string, lastWork: () => Promise<Project | null>): Promise<void>;
  link(hash: string): Promise<boolean>;
  /** Leaves the preview of a .glb: the room that was open is shown again as it was. */
  endPreview(): Promise<void>;
}

export function createOpening(store: Store, solving: Solving, viewer: Viewer): Opening {
  const placing = createPlacing(store, solving, viewer);
  const { attempt, place } = placing;

  /** An experiment's bounds are shares of what can be had in this room: find that out first. */
  async function settleBounds(entry: GalleryEntry, scene: SceneInfo): Promise<void> {
    if (!entry.relative) return;
    const cards = await entry.relative(async (verb, surfaces) => {
      const wish = [{ id: 'best', surfaces, verb, weight: 1 }];
      const probe = documentFrom({ ...entry.asked, cards: wish }, scene.identity, entry.room);
      const { goals } = await solving.probe(intentionsOf(probe).intentions);
      return goals[0]?.value ?? 0;
    });
    store.reset(documentFrom({ ...entry.asked, cards }, scene.identity, entry.room));
    store.card.value = cards[0]?.id ?? null;
    solving.solveAfresh();
  }

  const openEntry = (id: string) =>
    attempt('Opening the room', async (isCurrent) => {
      const entry = entryOf(id);
      if (!entry) throw new Error(`there is no room "${cleanName(id)}"`);
      await place(await requestScene(entry.room), entry.title, isCurrent, (scene) => ({
        document: documentFrom(entry.asked, scene.identity, entry.room),
      }));
      const scene = store.scene.peek();
      if (!isCurrent() || !scene) return;
      forgetLink();
      await settleBounds(entry, scene);
    });

  function titleOf(room: string): string {
    return rooms.find((entry) => entry.room === room)?.title ?? room;
  }

  /** Shows a link; where the room is another version of the one it names, only when `exact` is not insisted on. */
  async function openLink(link: Link, exact: boolean, bytes?: ArrayBuffer): Promise<boolean> {
    if (!bytes && !isRoom(link.room)) {
      store.pendingLink.value = link;
      store.say(
        'warning',
        `This link is about “${link.room}”, a file that is not part of this site. Open that .flux file here and the layout appears.`,
      );
      return false;
    }
    return attempt('Opening the link', async (isCurrent) => {
      await place(bytes ?? (await requestScene(link.room)), titleOf(link.room), isCurrent, (scene) => {
        const same = scene.identity === link.scene;
        if (!same && exact) {
          offerOther(link);
          throw new Error(`the link was not shown: “${titleOf(link.room)}” has changed since it was made`);
        }
        const document = documentOf(link, scene, same);
        if (typeof document === 'string') throw new Error(document);
        return { document, view: link };
      });
    });
  }

  function offerOther(link: Link): void {
    store.say(
      'warning',
      `This link was made for another version of “${titleOf(link.room)}”. In the present one the light will differ.`,
      { label: 'Show it anyway', run: () => void openLink(link, false) },
    );
  }

  async function readLink(hash: string): Promise<boolean> {
    const decoded = decodeLink(hash);
    if (decoded.ok) return openLink(decoded.link, true);
    const { readable } = decoded;
    const offer = readable && { label: 'Open what can be read', run: () => void openLink(readable, false) };
    store.say('error', decoded.message, offer);
    return false;
  }

  const openProject = (project: Project) =>
    attempt('Opening the project', async (isCurrent) => {
      const { document } = project;
      if (!isRoom(document.room))
        throw new Error(
          `this project is about “${document.room}”, which is not part of this site; open its .flux file first`,
        );
      await place(await requestScene(document.room), titleOf(document.room), isCurrent, (scene) => {
        if (scene.identity !== document.scene)
          throw new Error('the room has changed since this project was saved; its places no longer fit');
        return { document, view: project };
      });
      if (isCurrent()) forgetLink();
    });

  const openFile = createFileOpening(store, viewer, placing, openProject);

  return {
    entry: async (id) => {
      store.messages.value = [];
      await openEntry(id);
    },
    file: async (file) => {
      store.messages.value = [];
      await openFile(file);
    },
    link: readLink,
    async endPreview() {
      if (!(await placing.restore()) && store.scene.peek() === null) await openEntry(firstRoom);
    },
    async start(hash, lastWork) {
      if (hash.length > 1 && (await readLink(hash))) return;
      const last = await lastWork();
      const { loading, scene, preview } = store;
      if ([loading, scene, preview].some((each) => each.peek() !== null)) return; // a person was faster
      if (last && isRoom(last.document.room) && (await openProject(last))) return;
      await openEntry(firstRoom);
    },
  };
}

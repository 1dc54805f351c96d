/** Everything that puts another room on the screen: gallery, links, dropped files, projects, the last work. */
import { intentionsOf } from '../../document/intentions.ts';
import type { Project } from '../../document/project-file.ts';
import { cleanName } from '../../document/schema.ts';
import { decodeLink, type Link } from '../../document/share-link.ts';
import { documentOf } from '../../document/sites.ts';
import type { SceneInfo } from '../../document/types.ts';
import type { Viewer } from '../../viewer/types.ts';
import { documentFrom, entryOf, isRoom, rooms, type GalleryEntry } from '../rooms/catalog.ts';
import type { Solving } from '../solving.ts';
import type { Store } from '../state/store.ts';
import { forgetLink } from './address.ts';
import { firstRoom, requestScene } from './first-scene.ts';
import { FileOpening } from './opening-files.ts';
import { Placing, type Placement } from './placing.ts';

export class Opening {
  readonly #store: Store;
  readonly #solving: Solving;
  readonly #placing: Placing;
  readonly #files: FileOpening;

  constructor(store: Store, solving: Solving, viewer: Viewer) {
    this.#store = store;
    this.#solving = solving;
    this.#placing = new Placing(store, solving, viewer);
    this.#files = new FileOpening(store, viewer, this.#placing, (project) => this.#openProject(project));
  }

  /** What the address asks for, or else (no link, or none that can be shown) the last work, or else the first room. */
  async start(hash: string, lastWork: () => Promise<Project | null>): Promise<void> {
    if (hash.length > 1 && (await this.link(hash))) return;
    const last = await lastWork();
    const { loading, scene, preview } = this.#store;
    if ([loading, scene, preview].some((each) => each.peek() !== null)) return; // a person was faster
    if (last && isRoom(last.document.room) && (await this.#openProject(last))) return;
    await this.#openEntry(firstRoom);
  }

  /** A room or an experiment of the gallery. */
  async entry(id: string): Promise<void> {
    this.#store.messages.value = [];
    await this.#openEntry(id);
  }

  async file(file: File): Promise<void> {
    this.#store.messages.value = [];
    await this.#files.open(file);
  }

  /** Lets a person choose a file of their own. */
  pick(): void {
    const input = document.createElement('input');
    input.type = 'file';
    input.accept = '.flux,.glb,.json,.fiatlux';
    input.onchange = () => {
      const file = input.files?.[0];
      if (file) void this.file(file);
    };
    input.click();
  }

  async link(hash: string): Promise<boolean> {
    const decoded = decodeLink(hash);
    if (decoded.ok) return this.#openLink(decoded.link, true);
    const { readable, message } = decoded;
    const run = () => readable && void this.#openLink(readable, false);
    this.#store.say('error', message, readable && { label: 'Open what can be read', run });
    return false;
  }

  /** Leaves the preview of a .glb: the room that was open is shown again as it was. */
  async endPreview(): Promise<void> {
    const isBack = await this.#placing.restore();
    if (!isBack && this.#store.scene.peek() === null) await this.#openEntry(firstRoom);
  }

  #openEntry(id: string): Promise<boolean> {
    return this.#placing.attempt('Opening the room', async (isCurrent) => {
      const entry = entryOf(id);
      if (!entry) throw new Error(`there is no room "${cleanName(id)}"`);
      await this.#place(entry.room, entry.title, isCurrent, (scene) => ({
        document: documentFrom(entry.asked, scene.identity, entry.room),
      }));
      const scene = this.#store.scene.peek();
      if (!isCurrent() || !scene) return;
      forgetLink();
      await this.#settleBounds(entry, scene);
    });
  }

  /** An experiment's bounds are shares of what can be had in this room: find that out first. */
  async #settleBounds(entry: GalleryEntry, scene: SceneInfo): Promise<void> {
    if (!entry.relative) return;
    const cards = await entry.relative(async (verb, surfaces) => {
      const wish = [{ id: 'best', surfaces, verb, weight: 1 }];
      const probe = documentFrom({ ...entry.asked, cards: wish }, scene.identity, entry.room);
      const { goals } = await this.#solving.probe(intentionsOf(probe).intentions);
      return goals[0]?.value ?? 0;
    });
    this.#store.reset(documentFrom({ ...entry.asked, cards }, scene.identity, entry.room));
    this.#store.card.value = cards[0]?.id ?? null;
  }

  /** Shows a link; where the room is another version of the one it names, only when `exact` is not insisted on. */
  async #openLink(link: Link, exact: boolean): Promise<boolean> {
    if (!isRoom(link.room)) {
      this.#store.pendingLink.value = link;
      this.#store.say(
        'warning',
        `This link is about “${link.room}”, a file that is not part of this site. Open that .flux file here and the layout appears.`,
      );
      return false;
    }
    const title = titleOf(link.room);
    return this.#placing.attempt('Opening the link', (isCurrent) =>
      this.#place(link.room, title, isCurrent, (scene) => {
        const same = scene.identity === link.scene;
        if (!same && exact) {
          this.#offerOther(link);
          throw new Error(`the link was not shown: “${title}” has changed since it was made`);
        }
        const document = documentOf(link, scene, same);
        if (typeof document === 'string') throw new Error(document);
        return { document, view: link };
      }),
    );
  }

  #offerOther(link: Link): void {
    this.#store.say(
      'warning',
      `This link was made for another version of “${titleOf(link.room)}”. In the present one the light will differ.`,
      { label: 'Show it anyway', run: () => void this.#openLink(link, false) },
    );
  }

  #openProject(project: Project): Promise<boolean> {
    return this.#placing.attempt('Opening the project', async (isCurrent) => {
      const { document } = project;
      if (!isRoom(document.room))
        throw new Error(
          `this project is about “${document.room}”, which is not part of this site; open its .flux file first`,
        );
      await this.#place(document.room, titleOf(document.room), isCurrent, (scene) => {
        if (scene.identity !== document.scene)
          throw new Error('the room has changed since this project was saved; its places no longer fit');
        return { document, view: project };
      });
      if (isCurrent()) forgetLink();
    });
  }

  /** A room of the site. */
  async #place(
    room: string,
    title: string,
    isCurrent: () => boolean,
    make: (scene: SceneInfo) => Placement,
  ): Promise<void> {
    await this.#placing.place(await requestScene(room), title, isCurrent, make);
  }
}

function titleOf(room: string): string {
  return rooms.find((entry) => entry.room === room)?.title ?? room;
}

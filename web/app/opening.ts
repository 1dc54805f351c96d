/** Everything that puts another room on the screen: gallery, links, dropped files, projects, the last work. */
import { batch } from '@preact/signals';
import { decodeLink, type Link } from '../document/share-link.ts';
import { documentOf } from '../document/sites.ts';
import { intentionsOf } from '../document/intentions.ts';
import type { Project } from '../document/project-file.ts';
import { cleanName } from '../document/schema.ts';
import type { FiatLuxDocument, Layout } from '../document/types.ts';
import type { SceneInfo } from '../solver/protocol.ts';
import type { Viewer } from '../viewer/types.ts';
import { askedOfUnknown, documentFrom, entryOf, rooms, type GalleryEntry } from './catalog.ts';
import { firstRoom, rememberRoom, requestScene } from './first-scene.ts';
import { sentence, Superseded, type Solving } from './solving.ts';
import { firstDisplay, type Store } from './store.ts';

/** What is on the screen: its file, and what the solver made of it. */
interface Placed {
  readonly bytes: ArrayBuffer;
  readonly room: ArrayBuffer;
  readonly scene: SceneInfo;
}

const largestFile = 256 << 20; // bytes

export interface Opening {
  entry(id: string): Promise<void>;
  file(file: File): Promise<void>;
  /** What the address asks for, or else the last work, or else the first room. */
  start(hash: string, last: Project | null): Promise<void>;
  link(hash: string): Promise<boolean>;
  /** Leaves the preview of a .glb: the room that was open is shown again as it was. */
  endPreview(): Promise<void>;
}

const isRoom = (id: string) => rooms.some((room) => room.room === id);

export function createOpening(store: Store, solving: Solving, viewer: Viewer): Opening {
  let turn = 0; // the latest wish to open something wins
  let placed: Placed | null = null;

  /** Runs one opening; errors become one message, and what was on the screen stays. */
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

  async function fetchScene(room: string): Promise<ArrayBuffer> {
    const response = await requestScene(room);
    if (!response) throw new Error(`the room "${room}" could not be loaded: no connection; try again`);
    const isPage = response.headers.get('content-type')?.startsWith('text/html') ?? false;
    if (!response.ok || isPage)
      throw new Error(`the room "${room}" is not on this server; build it with: npm run build`);
    return response.arrayBuffer();
  }

  /** Puts a scene on the screen. `make` gives its document; nothing changes before everything is there. */
  async function place(
    bytes: ArrayBuffer,
    title: string,
    isCurrent: () => boolean,
    make: (scene: SceneInfo) => { document: FiatLuxDocument; view?: Pick<Link, 'camera' | 'display'> },
  ): Promise<void> {
    if (!isCurrent()) return;
    const layout = solving.layout();
    performance.mark('scene fetched');
    const { scene, room } = await solving.open(bytes);
    performance.mark('scene opened');
    if (!isCurrent()) return;
    let made: ReturnType<typeof make>;
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
      await place(await fetchScene(entry.room), entry.title, isCurrent, (scene) => ({
        document: documentFrom(entry.asked, scene.identity, entry.room),
      }));
      const scene = store.scene.peek();
      if (isCurrent() && scene) await settleBounds(entry, scene);
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
      await place(bytes ?? (await fetchScene(link.room)), titleOf(link.room), isCurrent, (scene) => {
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
      await place(await fetchScene(document.room), titleOf(document.room), isCurrent, (scene) => {
        if (scene.identity !== document.scene)
          throw new Error('the room has changed since this project was saved; its places no longer fit');
        return { document, view: project };
      });
    });

  async function openFile(file: File): Promise<void> {
    const name = cleanName(file.name);
    if (file.size > largestFile) {
      store.say('error', `“${name}” is larger than 256 MB, which is more than the browser can hold.`);
      return;
    }
    const bytes = await file.arrayBuffer().catch(() => null);
    if (!bytes) return void store.say('error', `“${name}” could not be read from the disk.`);
    if (/\.glb$/i.test(name)) return void (await preview(name, bytes));
    if (/\.flux$/i.test(name)) return openFlux(name, bytes);
    const { readProject } = await import('../document/project-file.ts');
    const project = readProject(new TextDecoder().decode(bytes));
    if (typeof project !== 'string') await openProject(project);
    else
      store.say(
        'error',
        /\.json$|\.fiatlux$/i.test(name)
          ? `“${name}”: ${project}`
          : `“${name}” is not a file of Fiat Lux: it takes .flux, .glb and project files.`,
      );
  }

  async function openFlux(name: string, bytes: ArrayBuffer): Promise<void> {
    const waiting = store.pendingLink.peek();
    const title = name.replace(/\.flux$/i, '');
    const opened = await attempt(`Opening ${name}`, (isCurrent) =>
      place(bytes, title, isCurrent, (scene) => {
        if (waiting?.scene === scene.identity) {
          const document = documentOf(waiting, scene, true);
          if (typeof document !== 'string') {
            store.pendingLink.value = null;
            return { document, view: waiting };
          }
        }
        const asked = askedOfUnknown(scene.surfaces, scene.sites.size.length);
        return { document: documentFrom(asked, scene.identity, name) };
      }),
    );
    if (opened) store.say('info', `“${name}” is open. It stays on this computer: nothing is uploaded.`);
  }

  const preview = (name: string, bytes: ArrayBuffer) =>
    attempt(`Opening ${name}`, async (isCurrent) => {
      await viewer.preview(bytes);
      if (isCurrent()) store.preview.value = name;
    });

  async function endPreview(): Promise<void> {
    const back = placed;
    if (!back) return openEntry(firstRoom).then(() => undefined);
    await attempt('Going back', async (isCurrent) => {
      await viewer.open(back.room, back.scene);
      if (!isCurrent()) return;
      store.preview.value = null;
      solving.relight();
    });
  }

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
    endPreview,
    async start(hash, last) {
      if (turn > 0) return; // a person was faster
      if (hash.length > 1 && (await readLink(hash))) return;
      if (hash.length <= 1 && last && isRoom(last.document.room) && (await openProject(last))) return;
      await openEntry(firstRoom);
    },
  };
}

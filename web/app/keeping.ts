/** The work as it can be kept: as a project, as a link, and in the browser's own storage. */
import { effect } from '@preact/signals';
import { filesOf } from '../document/photometric-files.ts';
import type { Project } from '../document/project-file.ts';
import type { Work } from '../document/work.ts';
import { keepForReload } from '../document/reload.ts';
import { fitLink } from '../document/share-link.ts';
import { linkOf } from '../document/linked-document.ts';
import type { Layout } from '../document/types.ts';
import type { Viewer } from '../viewer/types.ts';
import type { LuminaireTypes } from './luminaires/luminaire-types.ts';
import { hasLink, isEmbedded, pageOf } from './opening/address.ts';
import type { Solving } from './solving.ts';
import type { Store } from './state/store.ts';
import { words } from '../language/language.ts';
import { reasonOf } from '../document/reason.ts';

/** A room that was open: what was done in it, and the bytes of one that the site does not have. */
export interface Visited {
  readonly work: Work;
  readonly title: string;
  readonly bytes: ArrayBuffer | null;
}

/** The address of a layout, and the names of photometric files that it could not take along. */
export interface SharedLink {
  readonly address: string;
  readonly holdsKept: boolean; // the variant that the layout is compared with, too
  readonly score: number | null; // of a layout placed by hand against the solver's
  readonly left: readonly string[];
}

const quiet = 1200; // ms without a change before the work is stored

export class Keeping {
  readonly #store: Store;
  readonly #solving: Solving;
  readonly #viewer: Viewer;
  readonly #types: LuminaireTypes;
  readonly #visited = new Map<string, Visited>(); // by room, since the page was opened
  #isRefusalTold = false;

  constructor(store: Store, solving: Solving, viewer: Viewer, types: LuminaireTypes) {
    this.#store = store;
    this.#solving = solving;
    this.#viewer = viewer;
    this.#types = types;
  }

  /** The layout that answers what is asked, where there is one. */
  layout(): Layout | null {
    return this.#solving.layout() ?? this.#store.document.peek().layout;
  }

  /** What is asked together with the layout that answers it. */
  project(): Project {
    return this.#projectBeside('');
  }

  /** `history`: JSON that may name photometric files that the document no longer names. */
  #projectBeside(history: string): Project {
    const { document, camera, display } = this.#store;
    const files = filesOf(this.#types.files.peek(), document.peek(), history);
    return {
      document: { ...document.peek(), layout: this.layout() },
      camera: camera.peek(),
      display: display.peek(),
      ...(Object.keys(files).length > 0 && { files }),
    };
  }

  /** Takes note of the work in the room that is open, before another one takes its place. */
  remember(bytes: ArrayBuffer | null): void {
    const { room, scene } = this.#store.document.peek();
    if (scene !== '')
      this.#visited.set(room, { work: this.#left(), title: this.#store.roomTitle.peek(), bytes });
  }

  /** A room that was open since the page was. */
  visited(room: string): Visited | null {
    return this.#visited.get(room) ?? null;
  }

  /** The last work in a room, from this visit or an earlier one; null where there is none for this very scene. */
  async kept(room: string, scene: string): Promise<Work | null> {
    const work = this.#visited.get(room)?.work ?? (isEmbedded() ? null : await loadWork(room));
    return work?.project.document.scene === scene ? work : null;
  }

  /** The whole address of the present layout. Throws one readable line where it does not fit a link. */
  link(): SharedLink {
    const { scene, display, document, plan } = this.#store;
    const sites = scene.peek()?.sites;
    if (!sites) throw new Error(words.value.opening.noRoom);
    const view = { camera: this.#viewer.camera(), display: display.peek() };
    const files = this.#types.files.peek();
    const link = linkOf(document.peek(), this.layout(), sites, view, files, plan.peek());
    const reached = this.#store.score.peek();
    const score = reached === null ? null : Math.min(200, reached);
    const { hash, holdsKept, left } = fitLink(score === null ? link : { ...link, score });
    return { address: pageOf(document.peek().room) + hash, holdsKept, score, left };
  }

  /**
   * Keeps the work in the browser some time after each change and when the page is left, and says honestly when that is
   * refused. What a link shows is not kept before something is changed: it stays in the address, and the work that was
   * there before must outlive a look at it. Nothing of an embedded page is kept. `isOurs`: whether a room comes with the
   * site; others are not kept.
   */
  keepSaved(isOurs: (room: string) => boolean): () => void {
    const isKept = () => isOurs(this.#store.document.peek().room) && !hasLink() && !isEmbedded();
    const leave = () => {
      if (this.#store.scene.peek() !== null && isKept()) keepForReload(this.#left());
    };
    let timer: ReturnType<typeof setTimeout> | undefined;
    const stop = effect(() => {
      const { document, shown, progress } = this.#store;
      void document.value;
      const isReady = shown.value !== null && progress.value.state !== 'improving';
      clearTimeout(timer);
      if (isReady) timer = setTimeout(() => isKept() && void this.#save(), quiet);
    });
    globalThis.addEventListener?.('pagehide', leave);
    return () => {
      stop();
      clearTimeout(timer);
      globalThis.removeEventListener?.('pagehide', leave);
    };
  }

  /** The work as a reload finds it; while a search runs its layout does not answer what is asked. */
  #left(): Work {
    const { past, future } = this.#store.history.peek();
    const hasFiles = Object.keys(this.#types.files.peek()).length > 0;
    const project = this.#projectBeside(hasFiles ? JSON.stringify([past, future]) : '');
    const isSearching = this.#store.progress.peek().state === 'improving';
    const layout = isSearching ? null : project.document.layout;
    return { project: { ...project, document: { ...project.document, layout } }, past, future };
  }

  async #save(): Promise<void> {
    const { saving } = this.#store;
    try {
      const { save } = await import('../document/autosave.ts');
      saving.value = { state: 'saved', at: await save(this.#left()) };
    } catch (error) {
      saving.value = { state: 'refused', why: reasonOf(error) };
      this.#tellRefusal();
    }
  }

  #tellRefusal(): void {
    if (this.#isRefusalTold) return;
    this.#isRefusalTold = true;
    this.#store.say('warning', words.value.opening.notStored);
  }
}

async function loadWork(room: string): Promise<Work | null> {
  try {
    const { load } = await import('../document/autosave.ts');
    return await load(room);
  } catch {
    return null; // no storage: the room opens as if nothing had been kept
  }
}

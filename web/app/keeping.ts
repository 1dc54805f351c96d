/** What leaves the app: files that are downloaded, the link, and the work kept in the browser's storage. */
import { effect } from '@preact/signals';
import { encodeLink } from '../document/share-link.ts';
import { linkOf } from '../document/sites.ts';
import { writeProject, type Project } from '../document/project-file.ts';
import { keepForReload } from '../document/reload.ts';
import type { Viewer } from '../viewer/types.ts';
import { hasLink } from './opening/address.ts';
import type { Solving } from './solving.ts';
import type { Store } from './state/store.ts';

export interface Leaving {
  /** The whole address of the present layout. Throws one readable line where it does not fit a link. */
  link(): string;
  project(): Project;
  savePng(): Promise<void>;
  saveCsv(): Promise<void>;
  saveGltf(): Promise<void>;
  saveProject(): Promise<void>;
}

function download(name: string, content: Blob | string, type = 'text/plain'): void {
  const blob = typeof content === 'string' ? new Blob([content], { type }) : content;
  const anchor = document.createElement('a');
  anchor.href = URL.createObjectURL(blob);
  anchor.download = name;
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(anchor.href), 10_000);
}

export function createLeaving(store: Store, solving: Solving, viewer: Viewer): Leaving {
  const name = (suffix: string) =>
    `${
      store.roomTitle
        .peek()
        .toLowerCase()
        .replace(/[^a-z0-9]+/g, '-')
        .replace(/^-|-$/g, '') || 'room'
    }${suffix}`;
  const layout = () => solving.layout() ?? store.document.peek().layout;

  /** What is asked together with the layout that answers it. */
  const project = (): Project => ({
    document: { ...store.document.peek(), layout: layout() },
    camera: store.camera.peek(),
    display: store.display.peek(),
  });

  async function saving(what: string, action: () => Promise<void> | void): Promise<void> {
    try {
      await action();
    } catch (error) {
      store.say('error', `The ${what} could not be made: ${error instanceof Error ? error.message : error}`);
    }
  }

  /** The room and the layout that the luminaires' exporters need. */
  function placed() {
    const scene = store.scene.peek();
    const shown = layout();
    if (!scene || !shown) throw new Error('no layout is shown yet');
    return { sites: scene.sites, shown };
  }

  return {
    project,
    link() {
      const scene = store.scene.peek();
      if (!scene) throw new Error('No room is open yet.');
      const view = { camera: store.camera.peek() ?? viewer.camera(), display: store.display.peek() };
      const hash = encodeLink(linkOf(store.document.peek(), layout(), scene.sites, view));
      return `${location.href.split('#')[0]}${hash}`;
    },
    savePng: () => saving('picture', async () => download(name('.png'), await viewer.png())),
    saveCsv: () =>
      saving('table', async () => {
        const { luminairesCsv } = await import('../document/luminaires-csv.ts');
        const { sites, shown } = placed();
        download(name('-luminaires.csv'), luminairesCsv(shown, sites, store.efficacy.peek()), 'text/csv');
      }),
    saveGltf: () =>
      saving('glTF file', async () => {
        const { gltfLights } = await import('../document/gltf-lights.ts');
        const { sites, shown } = placed();
        download(name('-luminaires.gltf'), gltfLights(shown, sites), 'model/gltf+json');
      }),
    saveProject: () =>
      saving('project file', async () => {
        download(name('.fiatlux.json'), writeProject(project()), 'application/json');
      }),
  };
}

/**
 * Keeps the work in the browser some time after each change and when the page is left, and says honestly when that is
 * refused. What a link shows is not kept before something is changed: it stays in the address, and the work that was
 * there before must outlive a look at it.
 */
export function keepSaved(store: Store, project: () => Project, room: (id: string) => boolean): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let told = false;
  // A file of one's own is not kept either.
  const isOurs = () => room(store.document.peek().room) && !hasLink();
  const write = async () => {
    if (!isOurs()) return;
    try {
      const { save } = await import('../document/autosave.ts');
      store.saving.value = { state: 'saved', at: await save(project()) };
    } catch (error) {
      const why = error instanceof Error ? error.message : String(error);
      store.saving.value = { state: 'refused', why };
      if (!told)
        store.say(
          'warning',
          'This browser refuses to store the work. Save a project file or a link to keep it.',
        );
      told = true;
    }
  };
  const leave = () => {
    if (store.shown.peek() === null || !isOurs()) return;
    const work = project();
    const isSearching = store.progress.peek().state === 'improving'; // its layout does not answer what is asked
    keepForReload(isSearching ? { ...work, document: { ...work.document, layout: null } } : work);
  };
  globalThis.addEventListener?.('pagehide', leave);
  const stop = effect(() => {
    void store.document.value;
    const isReady = store.shown.value !== null && store.progress.value.state !== 'improving';
    clearTimeout(timer);
    if (isReady) timer = setTimeout(write, 1200);
  });
  return () => {
    stop();
    clearTimeout(timer);
    globalThis.removeEventListener?.('pagehide', leave);
  };
}

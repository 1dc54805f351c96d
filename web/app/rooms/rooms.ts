/** The rooms of the site: read when the page opens, and again every few seconds while the server still computes some. */
import { computed, signal } from '@preact/signals';
import { firstRoom } from '../opening/first-scene.ts';
import { readCatalog, toldIn, type Catalog, type GalleryEntry } from './catalog-file.ts';
import { requestCatalog } from './catalog-request.ts';
import { language, words } from '../../language/language.ts';
import { reasonOf } from '../../document/reason.ts';

const pause = 3000; // ms between looks at a list with rooms that are not ready

const none: Catalog = { rooms: [], experiments: [] };

export class Rooms {
  readonly catalog = computed(() => toldIn(language.value, this.#read.value));
  readonly fault = signal<string | null>(null); // one sentence where there is no list to be had
  readonly entries = computed(() => [...this.catalog.value.rooms, ...this.catalog.value.experiments]);
  readonly #read = signal<Catalog>(none);
  #loading: Promise<boolean> | null = null;

  get isThere(): boolean {
    return this.#read.peek() !== none;
  }

  /** Whether the list is there; asks for it where it is not. The fault of a vain try is told. */
  load(): Promise<boolean> {
    if (this.isThere) return Promise.resolve(true);
    this.#loading ??= this.#request().finally(() => (this.#loading = null));
    return this.#loading;
  }

  /** A room or an experiment by id. */
  entryOf(id: string): GalleryEntry | undefined {
    return this.entries.peek().find((entry) => entry.id === id);
  }

  /** A room by what documents call it. */
  roomOf(room: string): GalleryEntry | undefined {
    return this.catalog.peek().rooms.find((entry) => entry.room === room);
  }

  has(room: string): boolean {
    return this.roomOf(room) !== undefined;
  }

  /** What a room is called: its title, or the name of a file of one's own. */
  titleOf(room: string): string {
    return this.roomOf(room)?.title ?? room;
  }

  /** The room of the first screen: the site's first one, or another where that one is not ready. */
  first(): GalleryEntry | undefined {
    const { rooms } = this.catalog.peek();
    const wished = rooms.find((entry) => entry.id === firstRoom) ?? rooms[0];
    return wished?.progress === null ? wished : (rooms.find((entry) => entry.progress === null) ?? wished);
  }

  async #request(): Promise<boolean> {
    try {
      const read = readCatalog(await requestCatalog());
      if (typeof read === 'string') throw new Error(words.value.opening.catalog.unreadable(read));
      this.#read.value = read;
      this.fault.value = null;
    } catch (error) {
      const why = reasonOf(error);
      if (!this.isThere) this.fault.value = words.value.opening.catalog.notLoaded(why);
    }
    // A list that cannot be had again stays as it was; the next look may find it.
    if (this.catalog.peek().rooms.some((entry) => entry.progress !== null && !entry.failed))
      setTimeout(() => void this.#request(), pause);
    return this.isThere;
  }
}

/** "being computed, 40 %", or that it failed; null where it is ready. */
export function progressText({ progress, failed }: GalleryEntry): string | null {
  if (failed) return words.value.opening.catalog.notComputed;
  return progress === null ? null : words.value.opening.catalog.progress(Math.floor(progress * 100));
}

/** "Your rooms": those whose light was computed in this browser, as its storage holds them. */
import { signal } from '@preact/signals';
import type { OwnRoom, Quota, Understood } from '../../document/own-rooms.ts';
import { words } from '../../language/language.ts';

const storage = () => import('../../document/own-rooms.ts');

export class OwnRooms {
  readonly list = signal<readonly OwnRoom[]>([]);
  readonly quota = signal<Quota | null>(null);

  has(room: string): boolean {
    return this.list.value.some((each) => each.room === room);
  }

  titleOf(room: string): string {
    return this.list.value.find((each) => each.room === room)?.title ?? stemOf(room);
  }

  /** Leaves the list empty where the browser stores nothing. */
  async load(): Promise<void> {
    try {
      const { listRooms, quota } = await storage();
      this.list.value = await listRooms();
      this.quota.value = await quota();
    } catch {
      this.list.value = [];
    }
  }

  /** A name that no other room has: that of its file, or numbered. The same model is the same room. */
  async nameFor(file: string, source: string): Promise<string> {
    await this.load();
    return unusedName(stemOf(file), source, this.list.value);
  }

  /** How a model was understood when it was lit here for the last time; null where it never was. */
  async understood(digest: string): Promise<unknown> {
    await this.load();
    const known = this.list.value.filter(({ understood }) => understood?.digest === digest);
    return known.sort((a, b) => b.at - a.at)[0]?.understood?.choices ?? null;
  }

  /** `source`: hash of the model. Rejects with one readable line where the browser refuses. */
  async keep(room: string, source: string, file: ArrayBuffer, understood?: Understood): Promise<void> {
    const title = this.titleOf(room);
    try {
      const { keepRoom } = await storage();
      await keepRoom({ room, title, source, ...(understood && { understood }) }, file);
    } catch (error) {
      const isFull = error instanceof DOMException && error.name === 'QuotaExceededError';
      const why = isFull ? words.value.opening.own.full : words.value.opening.own.refused;
      throw new Error(words.value.opening.own.notKept(title, why));
    }
    await this.load();
  }

  /** Whether there is such a room, and nobody has seen it yet. */
  wantsPicture(room: string): boolean {
    const entry = this.list.value.find((each) => each.room === room);
    return entry !== undefined && !entry.picture;
  }

  async read(room: string): Promise<ArrayBuffer> {
    const { readRoom } = await storage();
    const file = await readRoom(room);
    if (!file) throw new Error(words.value.opening.own.gone(this.titleOf(room)));
    return file;
  }

  async change(room: string, change: Partial<Pick<OwnRoom, 'title' | 'picture'>>): Promise<void> {
    const { changeRoom } = await storage();
    await changeRoom(room, change);
    await this.load();
  }

  /** Returns how to bring it back. */
  async delete(room: string): Promise<() => Promise<void>> {
    const { deleteRoom, putRoom } = await storage();
    const entry = this.list.value.find((each) => each.room === room);
    const file = await this.read(room);
    await deleteRoom(room);
    await this.load();
    return async () => {
      if (entry && !this.has(room)) await putRoom(entry, file);
      await this.load();
    };
  }
}

const stemOf = (name: string) => name.replace(/\.(gl(b|tf)|flux)$/i, '');

/** "x.flux", or "x (2).flux" where another model has that, and so on. */
export function unusedName(stem: string, source: string, taken: readonly OwnRoom[]): string {
  for (let number = 1; ; number++) {
    const room = number === 1 ? `${stem}.flux` : `${stem} (${number}).flux`;
    const there = taken.find((each) => each.room === room);
    if (!there || there.source === source) return room;
  }
}

/** "Your rooms": those whose light was computed in this browser, as its storage holds them. */
import { signal } from '@preact/signals';
import type { OwnRoom, Quota } from '../../document/own-rooms.ts';

const storage = () => import('../../document/own-rooms.ts');

export class OwnRooms {
  readonly list = signal<readonly OwnRoom[]>([]);
  readonly quota = signal<Quota | null>(null);

  has(room: string): boolean {
    return this.list.value.some((each) => each.room === room);
  }

  titleOf(room: string): string {
    return this.list.value.find((each) => each.room === room)?.title ?? room;
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

  /** Rejects with one readable line where the browser refuses. */
  async keep(room: string, title: string, file: ArrayBuffer): Promise<void> {
    try {
      const { keepRoom } = await storage();
      await keepRoom(room, title, file);
    } catch (error) {
      const isFull = error instanceof DOMException && error.name === 'QuotaExceededError';
      const why = isFull ? 'its storage is full' : 'it refuses to store files';
      throw new Error(`“${title}” is not kept in this browser: ${why}. Save the room as .flux to keep it.`);
    }
    await this.load();
  }

  async read(room: string): Promise<ArrayBuffer> {
    const { readRoom } = await storage();
    const file = await readRoom(room);
    if (!file) throw new Error(`“${this.titleOf(room)}” is no longer in this browser's storage`);
    return file;
  }

  async rename(room: string, title: string): Promise<void> {
    const { renameRoom } = await storage();
    await renameRoom(room, title);
    await this.load();
  }

  async delete(room: string): Promise<void> {
    const { deleteRoom } = await storage();
    await deleteRoom(room);
    await this.load();
  }
}

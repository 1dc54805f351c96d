/**
 * Rooms that were computed in this browser, in its own storage: the scene file of each, and a list of them. Storage may
 * be refused (private windows, full disk): then the functions reject.
 */
import { openDB, type IDBPDatabase } from 'idb';

/** How the model of a room was understood when it was made. */
export interface Understood {
  readonly digest: string; // of the model's bytes
  readonly choices: unknown; // as whoever made it says
}

export interface OwnRoom {
  readonly room: string; // what documents call it; one of each
  readonly title: string;
  readonly bytes: number; // of its file
  readonly at: number; // when it was made, ms since 1970
  readonly source?: string; // hash of the model that it was made of
  readonly understood?: Understood;
  readonly picture?: ArrayBuffer; // JPEG, once there was light to see
}

/** What the browser grants the page, and what of it is taken, in bytes; null where it does not say. */
export interface Quota {
  readonly taken: number;
  readonly granted: number;
  readonly isSafe: boolean; // else the browser may clear it where the disk is full
}

let database: Promise<IDBPDatabase> | null = null;

function open(): Promise<IDBPDatabase> {
  database ??= openDB('fiatlux-rooms', 1, {
    upgrade: (db) => {
      db.createObjectStore('list', { keyPath: 'room' });
      db.createObjectStore('files');
    },
    terminated: () => (database = null),
  }).catch((error: unknown) => {
    database = null;
    throw error;
  });
  return database;
}

/** The newest first. */
export async function listRooms(): Promise<readonly OwnRoom[]> {
  const rooms = (await (await open()).getAll('list')) as OwnRoom[];
  return rooms.sort((a, b) => b.at - a.at);
}

/** A room of the same name is replaced. */
export async function keepRoom(entry: Omit<OwnRoom, 'bytes' | 'at'>, file: ArrayBuffer): Promise<void> {
  await putRoom({ ...entry, bytes: file.byteLength, at: Date.now() }, file);
}

export async function putRoom(entry: OwnRoom, file: ArrayBuffer): Promise<void> {
  const transaction = (await open()).transaction(['list', 'files'], 'readwrite');
  await Promise.all([
    transaction.objectStore('files').put(file, entry.room), // first: what refuses it has listed nothing
    transaction.objectStore('list').put(entry),
    transaction.done,
  ]);
}

/** null where there is none of this name. */
export async function readRoom(room: string): Promise<ArrayBuffer | null> {
  const file: unknown = await (await open()).get('files', room);
  return file instanceof ArrayBuffer ? file : null;
}

/** Its name stays: links and work go on to know it by that. Nothing where there is none. */
export async function changeRoom(
  room: string,
  change: Partial<Pick<OwnRoom, 'title' | 'picture'>>,
): Promise<void> {
  const transaction = (await open()).transaction('list', 'readwrite');
  const entry = (await transaction.store.get(room)) as OwnRoom | undefined;
  if (entry) await transaction.store.put({ ...entry, ...change });
  await transaction.done;
}

export async function deleteRoom(room: string): Promise<void> {
  const transaction = (await open()).transaction(['list', 'files'], 'readwrite');
  await Promise.all([
    transaction.objectStore('list').delete(room),
    transaction.objectStore('files').delete(room),
    transaction.done,
  ]);
}

export async function quota(): Promise<Quota | null> {
  const { usage, quota: granted } = (await navigator.storage?.estimate?.()) ?? {};
  const isSafe = (await navigator.storage?.persisted?.()) ?? false;
  return usage === undefined || granted === undefined ? null : { taken: usage, granted, isSafe };
}

/** The last work in each room, in the browser's own storage. It may be refused (private windows, full disk): that is told. */
import { openDB, type IDBPDatabase } from 'idb';
import { readWork, writeWork, type Work } from './work.ts';

const store = 'work';
const latest = 'latest'; // the key under which the room of the last work stands; before rooms had keys, the work itself

const keyOf = (room: string) => `room ${room}`;

let database: Promise<IDBPDatabase> | null = null;

function open(): Promise<IDBPDatabase> {
  database ??= openDB('fiatlux', 1, {
    upgrade: (db) => void db.createObjectStore(store),
    terminated: () => (database = null),
  }).catch((error: unknown) => {
    database = null;
    throw error;
  });
  return database;
}

/** When it was kept, ms since 1970. */
export async function save(work: Work): Promise<number> {
  const at = Date.now();
  const { room } = work.project.document;
  const transaction = (await open()).transaction(store, 'readwrite');
  await Promise.all([
    transaction.store.put({ text: writeWork(work), at }, keyOf(room)),
    transaction.store.put({ room, at }, latest),
    transaction.done,
  ]);
  return at;
}

/** null where nothing (or nothing readable) is stored for this room. */
export async function load(room: string): Promise<Work | null> {
  return workIn(await (await open()).get(store, keyOf(room)));
}

/** The work that was kept last, in whichever room. */
export async function loadLatest(): Promise<Work | null> {
  const entry: unknown = await (await open()).get(store, latest);
  const { room } = (entry ?? {}) as { room?: unknown };
  return typeof room === 'string' ? load(room) : workIn(entry);
}

function workIn(entry: unknown): Work | null {
  const { text } = (entry ?? {}) as { text?: unknown };
  return typeof text === 'string' ? readWork(text) : null;
}

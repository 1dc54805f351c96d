/** The last state of the work in the browser's own storage. It may be refused (private windows, full disk): that is told. */
import { openDB, type IDBPDatabase } from 'idb';
import { readProject, writeProject, type Project } from './project-file.ts';

const store = 'work';
const key = 'latest';

export interface Saved {
  readonly project: Project;
  readonly at: number; // ms since 1970
}

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

export async function save(project: Project): Promise<number> {
  const at = Date.now();
  await (await open()).put(store, { text: writeProject(project), at }, key);
  return at;
}

/** null where nothing (or nothing readable) is stored. */
export async function load(): Promise<Saved | null> {
  const entry: unknown = await (await open()).get(store, key);
  if (typeof entry !== 'object' || entry === null) return null;
  const { text, at } = entry as { text?: unknown; at?: unknown };
  if (typeof text !== 'string' || typeof at !== 'number') return null;
  const project = readProject(text);
  return typeof project === 'string' ? null : { project, at };
}

export async function clear(): Promise<void> {
  await (await open()).delete(store, key);
}

/**
 * Scene files of the site. The one that the first screen will most likely show (the room of the last work, or the
 * first one) is asked for before the app has arrived; it is used once, by whoever fetches that room first.
 */
import { sceneBytes } from '../../solver/scene-bytes.ts';

export const firstRoom = 'office'; // of the sample rooms; on a site without it the first of its list is opened

/** Names that a scene file of a site may have. */
export const sceneFile = /^[A-Za-z0-9][\w.-]{0,79}\.flux$/;

const key = 'fiatlux.room';

interface Early {
  readonly room: string;
  readonly file: EarlyFile;
}

/** A file that is on its way; its bytes reject where it has to be asked for again. */
export interface EarlyFile {
  readonly bytes: Promise<ArrayBuffer>;
  abandon(): void;
}

let early: Early | null = null;

/** The room to expect; null where a link says which one. */
export function likelyRoom(hash: string): string | null {
  if (hash.length > 1) return null;
  try {
    const last = localStorage.getItem(key) ?? firstRoom;
    return sceneFile.test(`${last}.flux`) ? last : firstRoom;
  } catch {
    return firstRoom; // no storage
  }
}

export function rememberRoom(room: string): void {
  try {
    localStorage.setItem(key, room);
  } catch {
    // No storage: the first room is expected again next time.
  }
}

export function sceneAddress(room: string): string {
  return new URL(`./scenes/${room}.flux`, document.baseURI).href;
}

export function expectScene(room: string, file: EarlyFile): void {
  early = { room, file };
}

/** The scene file of a room. Rejects with one readable line. */
export async function requestScene(room: string): Promise<ArrayBuffer> {
  const waiting = early;
  early = null;
  if (waiting?.room === room) return waiting.file.bytes.catch(() => request(room));
  waiting?.file.abandon();
  return request(room);
}

async function request(room: string): Promise<ArrayBuffer> {
  const response = await fetch(sceneAddress(room)).catch(() => null);
  if (!response) throw new Error(`the room "${room}" could not be loaded: no connection; try again`);
  const bytes = await sceneBytes(response);
  if (!bytes) throw new Error(`the room "${room}" is not on this server; build it with: npm run build`);
  return bytes;
}

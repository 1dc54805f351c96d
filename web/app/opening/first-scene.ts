/**
 * Scene files of the site. The one that the first screen will most likely show (the room of the last work, or the
 * first one) is asked for before the app has arrived; it is used once, by whoever fetches that room first.
 */
import { isEmbedded, wishedRoom } from './address.ts';
import { sentences } from './sentences.ts';
import { sceneBytes } from '../../solver/scene-bytes.ts';
import type { FileBytes } from '../../solver/solver-client.ts';

export const firstRoom = 'office'; // of the sample rooms; on a site without it the first of its list is opened

/** Names that a scene file of a site may have. */
export const sceneFile = /^[A-Za-z0-9][\w.-]{0,79}\.flux$/;

const key = 'fiatlux.room';

interface Early {
  readonly room: string;
  readonly file: EarlyFile;
}

/** A file that is on its way; `begun` rejects where it has to be asked for again. */
export interface EarlyFile {
  readonly begun: Promise<void>;
  readonly bytes: Promise<ArrayBuffer>;
  abandon(): void;
}

let early: Early | null = null;

/** The room to expect; null where a link says which one. */
export function likelyRoom(hash: string): string | null {
  if (hash.length > 1) return null;
  const room = wishedRoom() ?? lastRoom() ?? firstRoom;
  return sceneFile.test(`${room}.flux`) ? room : firstRoom;
}

/** Nothing of this site was opened in this browser before, and the address shows nothing in particular. */
export function isFirstVisit(hash: string): boolean {
  return hash.length <= 1 && !isEmbedded() && lastRoom() === null;
}

function lastRoom(): string | null {
  if (isEmbedded()) return null;
  try {
    return localStorage.getItem(key);
  } catch {
    return null; // no storage
  }
}

export function rememberRoom(room: string): void {
  if (isEmbedded()) return;
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

/** The scene file of a room, of which all or the first bytes are there. Rejects with one readable line. */
export async function requestScene(room: string): Promise<{ readonly bytes: FileBytes }> {
  const waiting = early;
  early = null;
  if (waiting?.room !== room) waiting?.file.abandon();
  else if (await hasBegun(waiting.file)) return { bytes: waiting.file.bytes };
  return { bytes: await request(room) };
}

function hasBegun({ begun }: EarlyFile): Promise<boolean> {
  return begun.then(
    () => true,
    () => false,
  );
}

async function request(room: string): Promise<ArrayBuffer> {
  const response = await fetch(sceneAddress(room)).catch(() => null);
  if (!response) throw new Error((await sentences()).roomOffline(room));
  const bytes = await sceneBytes(response);
  if (!bytes) throw new Error((await sentences()).roomMissing(room));
  return bytes;
}

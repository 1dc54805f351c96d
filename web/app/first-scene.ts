/**
 * Scene files of the site. The one that the first screen will most likely show (the room of the last work, or the
 * first one) is asked for before the app has arrived; it is used once, by whoever fetches that room first.
 */
export const firstRoom = 'office';

const key = 'fiatlux.room';

interface Early {
  readonly room: string;
  readonly response: Promise<Response | null>;
  readonly abort: () => void;
}

let early: Early | null = null;

/** The room to expect; null where a link says which one. */
export function likelyRoom(hash: string): string | null {
  if (hash.length > 1) return null;
  try {
    const last = localStorage.getItem(key) ?? firstRoom;
    return /^[a-z0-9-]{1,40}$/.test(last) ? last : firstRoom;
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

export function fetchEarly(hash: string): void {
  const room = likelyRoom(hash);
  if (!room) return;
  const stop = new AbortController();
  early = { room, response: request(room, stop.signal), abort: () => stop.abort() };
}

/** null where there is no connection. */
export async function requestScene(room: string): Promise<Response | null> {
  const waiting = early;
  early = null;
  if (waiting?.room === room) return (await waiting.response) ?? request(room);
  waiting?.abort();
  return request(room);
}

function request(room: string, signal?: AbortSignal): Promise<Response | null> {
  const address = new URL(`./scenes/${room}.flux`, document.baseURI);
  return fetch(address, signal ? { signal } : {}).catch(() => null);
}

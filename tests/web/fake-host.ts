// A host of a site: its list of rooms and its scene files, and what it was asked for.
import { catalogFile, type RoomStates } from '../../rooms/catalog-file.mjs';

export interface FakeHost {
  /** Names below scenes/, in the order in which they were asked for. */
  readonly asked: string[];
  /** What catalog.json says; null = the host does not have it, 'offline' = there is no connection. */
  catalog: unknown;
}

/** Takes the place of fetch and of the page's address. */
export function fakeHost(states: RoomStates = {}): FakeHost {
  const host: FakeHost = { asked: [], catalog: catalogFile(states) };
  const put = (name: string, value: unknown) =>
    Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  put('document', { baseURI: 'https://example.test/sub/' });
  put('fetch', async (address: string) => {
    const name = new URL(address).pathname.replace('/sub/scenes/', '');
    host.asked.push(name);
    if (host.catalog === 'offline') throw new TypeError('Failed to fetch');
    if (name !== 'catalog.json') return new Response(new Uint8Array(4));
    if (host.catalog === null) return new Response('<html>', { headers: { 'content-type': 'text/html' } });
    return new Response(typeof host.catalog === 'string' ? host.catalog : JSON.stringify(host.catalog));
  });
  return host;
}

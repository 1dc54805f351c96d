/** Asks for the list of rooms: once before the app has arrived, and whenever the app wants it anew. */
import { sentences } from '../opening/sentences.ts';

let early: Promise<Response | null> | null = null;

/** Called by the first script: the list is on its way while the app is. */
export function expectCatalog(): void {
  early = request();
}

/** What scenes/catalog.json says, not checked yet. Rejects with one readable clause. */
export async function requestCatalog(): Promise<unknown> {
  const waiting = early;
  early = null;
  const response = (await waiting) ?? (await request());
  if (!response) throw new Error((await sentences()).catalog.offline);
  // note: some hosts answer with a page where a file is missing
  const isThere = response.ok && !response.headers.get('content-type')?.startsWith('text/html');
  if (!isThere) throw new Error((await sentences()).catalog.missing);
  return response.json().catch(async () => {
    throw new Error((await sentences()).catalog.notJson);
  });
}

/** Asked anew each time: its rooms become ready while the page is open. */
function request(): Promise<Response | null> {
  const address = new URL('./scenes/catalog.json', document.baseURI).href;
  return fetch(address, { cache: 'no-cache' }).catch(() => null);
}

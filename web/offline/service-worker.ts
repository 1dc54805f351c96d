/**
 * Keeps the site for visits without a connection; built as service-worker.js beside index.html, so that its scope is the
 * folder of the site, wherever that lies.
 *
 * What the build made (`fiatluxBuild`, from vite.config.js) has names that change with its contents and is kept as a whole,
 * by build. The page and all that an owner may change under its name (the list of rooms, scenes, pictures, luminaires) are
 * asked of the network first: what is kept answers only where there is none. A new build waits until no page of the old
 * one is open, and then takes its files away.
 */
declare const self: ServiceWorkerGlobalScope;
declare const fiatluxBuild: {
  readonly id: string;
  readonly files: readonly string[];
  readonly entry: string;
};

const { id, files, entry } = fiatluxBuild;
const { scope } = self.registration;
const ours = `fiatlux ${scope} `; // sites in other folders of the host have caches of their own
const built = `${ours}build ${id}`;
const seen = `${ours}seen`;

const mostSeen = 128 << 20; // bytes: the rooms opened last, and what is small
const sizeHeader = 'x-kept-bytes';

self.addEventListener('install', (event) => event.waitUntil(install()));
self.addEventListener('activate', (event) => event.waitUntil(takeOver()));
self.addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method !== 'GET' || !request.url.startsWith(scope) || request.headers.has('range')) return;
  event.respondWith(request.mode === 'navigate' ? pageFor(request) : fileFor(event));
});

/** Keeps all of the build, or fails and is tried again with a later visit. */
async function install(): Promise<void> {
  const page = await fetch(scope, { cache: 'no-cache' });
  if (!page.ok || !(await page.clone().text()).includes(entry))
    throw new Error('the page on the host is of another build than its service worker');
  const cache = await caches.open(built);
  await cache.put(scope, page);
  await cache.addAll(files.map((file) => new URL(file, scope).href));
}

async function takeOver(): Promise<void> {
  const names = await caches.keys();
  const old = names.filter((name) => name.startsWith(ours) && name !== built && name !== seen);
  await Promise.all(old.map((name) => caches.delete(name)));
  await self.clients.claim();
}

/** Every page of the site is the same app: without a connection it comes as the build has it. */
async function pageFor(request: Request): Promise<Response> {
  try {
    return await fetch(request);
  } catch (error) {
    const page = await caches.match(scope, { cacheName: built, ignoreVary: true });
    if (page) return page;
    throw error;
  }
}

async function fileFor(event: FetchEvent): Promise<Response> {
  const { request } = event;
  const own = await caches.match(request, { cacheName: built, ignoreVary: true });
  if (own) return own;
  try {
    const response = await fetch(request);
    if (isFile(response)) event.waitUntil(keep(request.url, response.clone()));
    return response;
  } catch (error) {
    const kept = await caches.match(request.url, { cacheName: seen, ignoreVary: true });
    if (kept) return kept;
    throw error;
  }
}

/** note: some hosts answer with a page where a file is missing */
const isFile = ({ status, type, headers }: Response): boolean =>
  status === 200 && type === 'basic' && !headers.get('content-type')?.startsWith('text/html');

let keeping = Promise.resolve(); // one after another, so that sizes add up

function keep(address: string, response: Response): Promise<void> {
  keeping = keeping.then(() => put(address, response)).catch(() => undefined); // no space: then it is not kept
  return keeping;
}

/** The newest file is kept, and the oldest ones go until all fit. */
async function put(address: string, response: Response): Promise<void> {
  const body = await response.blob();
  if (body.size > mostSeen) return;
  const type = response.headers.get('content-type');
  const headers = { [sizeHeader]: String(body.size), ...(type && { 'content-type': type }) };
  const cache = await caches.open(seen);
  await cache.delete(address);
  await cache.put(address, new Response(body, { headers }));
  let left = mostSeen;
  for (const request of [...(await cache.keys())].reverse()) {
    left -= Number((await cache.match(request))?.headers.get(sizeHeader) ?? 0);
    if (left < 0) await cache.delete(request);
  }
}

export {};

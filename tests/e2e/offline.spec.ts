// Visits without a connection, and after an update of the site. Covers service-worker, offline.
// note: a host of its own, in a folder, that can be changed and stopped; not watched, since a browser without a connection
// says so in its console.
import { createServer, type Server } from 'node:http';
import { readFileSync } from 'node:fs';
import type { AddressInfo } from 'node:net';
import path from 'node:path';
import { expect, test, type Page } from '@playwright/test';
import { status } from './app.ts';

const types: Readonly<Record<string, string>> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
};

/** dist/ below /light/; `edit` changes what text says. */
function host(): { server: Server; address: () => string; edits: Map<string, (text: string) => string> } {
  const edits = new Map<string, (text: string) => string>();
  const server = createServer((request, response) => {
    const name = new URL(request.url ?? '', 'http://host').pathname.replace(
      /^\/light\/$/,
      '/light/index.html',
    );
    try {
      const bytes = readFileSync(path.join('dist', name.replace(/^\/light\//, '')));
      const edit = edits.get(path.basename(name));
      response.setHeader('content-type', types[path.extname(name)] ?? 'application/octet-stream');
      response.end(edit ? edit(bytes.toString()) : bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  const address = () => `http://127.0.0.1:${(server.address() as AddressInfo).port}/light/`;
  return { server, address, edits };
}

const keptFiles = (page: Page) =>
  page.evaluate(async () => {
    const names = await caches.keys();
    const files = await Promise.all(
      names.map(async (name) => (await (await caches.open(name)).keys()).map(({ url }) => url)),
    );
    return { names, files: files.flat() };
  });

test.use({ serviceWorkers: 'allow' });

test('what was opened once is there without a connection, and an update is never hidden by it', async ({
  context,
}) => {
  const { server, address, edits } = host();
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  try {
    const page = await context.newPage();
    const site = address();
    await page.goto(`${site}?room=box`);
    await expect(status(page)).toHaveText('Settled', { timeout: 60_000 });
    await expect.poll(async () => (await keptFiles(page)).files).toContain(`${site}scenes/box.flux`);

    // Another build: seen at the next visit, its files take the place of the old ones once no page is open.
    edits.set('index.html', (text) => text.replace('<title>', '<title>New '));
    edits.set('service-worker.js', (text) => text.replace(/"id":"\w+"/, '"id":"new"'));
    await page.reload();
    await expect(page).toHaveTitle('New Fiat Lux');
    await page.evaluate(async () => {
      const registration = (await navigator.serviceWorker.getRegistration())!;
      await registration.update();
    });
    const isNew = (name: string) => name.endsWith('build new');
    await expect.poll(async () => (await keptFiles(page)).names.some(isNew)).toBe(true);
    await expect
      .poll(() =>
        page.evaluate(async () => Boolean((await navigator.serviceWorker.getRegistration())!.waiting)),
      )
      .toBe(true);
    await page.goto('about:blank');
    await page.goto(`${site}?room=box`);
    const builds = async () => (await keptFiles(page)).names.filter((name) => name.includes(' build '));
    await expect.poll(async () => (await builds()).map(isNew)).toEqual([true]);

    server.close();
    server.closeAllConnections();
    await page.goto('about:blank');
    await page.goto(`${site}?room=box`);
    await expect(page).toHaveTitle('New Fiat Lux');
    await expect(page.getByRole('heading', { level: 1 })).toHaveText('Box');
    await expect(status(page)).toHaveText(/^(Settled|As given)$/, { timeout: 60_000 });
  } finally {
    server.closeAllConnections();
    server.close();
  }
});

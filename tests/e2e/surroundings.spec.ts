// What happens around the app: any folder of any host under a strict policy, a lost graphics card, a dead worker.
// Covers shell, the viewer's stage, rooms, solver-client.
import { createReadStream, existsSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import path from 'node:path';
import { test as plain } from '@playwright/test';
import {
  difference,
  expect,
  expectLit,
  openRoom,
  picture,
  pictureAtRest,
  places,
  settled,
  status,
  test,
  watch,
} from './app.ts';

const dist = path.join(import.meta.dirname, '../../dist');
const folder = '/deep/sub/path/';
const policy =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' data: blob:; " +
  "connect-src 'self' blob: data:; worker-src 'self'; base-uri 'none'; form-action 'none'";
const types: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
  '.jpg': 'image/jpeg',
  '.wasm': 'application/wasm',
};

/** A static host that knows nothing but a folder, with the policy as a header. */
function serve(): Promise<Server> {
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://host');
    const name = pathname.startsWith(folder) ? pathname.slice(folder.length) || 'index.html' : '';
    const file = path.join(dist, path.normalize(`/${name}`));
    if (!name || !existsSync(file)) return void response.writeHead(404).end();
    const type = types[path.extname(file)] ?? 'application/octet-stream';
    response.writeHead(200, { 'Content-Type': type, 'Content-Security-Policy': policy });
    createReadStream(file).pipe(response);
  });
  return new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(server)));
}

plain('works in a folder of a static host that sends a strict policy', async ({ page, context }) => {
  const server = await serve();
  try {
    const { origin } = new URL(`http://127.0.0.1:${(server.address() as AddressInfo).port}`);
    const faults = await watch(context, origin);
    await openRoom(page, 'Box', `${origin}${folder}`);
    await expectLit(page);
    await page.keyboard.press('g');
    const thumbnails = await page.getByRole('dialog').locator('img').all();
    expect(thumbnails.length).toBeGreaterThan(15); // of every room and every experiment
    for (const thumbnail of thumbnails) {
      await thumbnail.scrollIntoViewIfNeeded();
      await expect
        .poll(() => thumbnail.evaluate((image: HTMLImageElement) => image.naturalWidth))
        .toBeGreaterThanOrEqual(320);
    }
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Share', exact: true }).click();
    const link = await page.getByRole('textbox', { name: 'Link' }).inputValue();
    expect(link).toContain(`${origin}${folder}#`);
    expect(faults).toEqual([]);
  } finally {
    server.closeAllConnections();
    server.close();
  }
});

test('a lost WebGL context comes back with the same layout and light', async ({ page }) => {
  await openRoom(page, 'Box');
  const [layout, lit] = [await places(page), await pictureAtRest(page)];
  await page.getByRole('application').evaluate((element: HTMLCanvasElement) => {
    const extension = element.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
    element.addEventListener('webglcontextlost', () => setTimeout(() => extension.restoreContext()), {
      once: true,
    });
    extension.loseContext();
  });
  await expect(
    page.getByRole('region', { name: 'Messages' }).getByText(/comes back by itself/),
  ).toBeVisible();
  await page.getByRole('button', { name: 'Dismiss this message' }).click();
  await expect.poll(async () => difference(await picture(page), lit)).toBeLessThan(0.005);
  expect(await places(page)).toEqual(layout);
});

test('a worker that dies for good is told, and one click goes on from the last layout', async ({ page }) => {
  await page.addInitScript(() => {
    const [Real, made] = [Worker, [] as Worker[]];
    window.Worker = class extends Real {
      constructor(...given: ConstructorParameters<typeof Worker>) {
        super(...given);
        made.push(this);
      }
    };
    // As the browser reports a worker that ended with an error.
    (window as any).killWorker = () =>
      made.at(-1)!.dispatchEvent(new ErrorEvent('error', { message: 'out of memory' }));
  });
  await openRoom(page, 'Box');
  const layout = await places(page);
  await page.evaluate(() => {
    for (let deaths = 0; deaths < 3; deaths++) (window as any).killWorker();
  });
  const alert = page.getByRole('alert').filter({ hasText: /out of memory/ });
  await expect(alert).toBeVisible();
  await expect(status(page)).toHaveText('Not solved');
  expect(await places(page)).toEqual(layout);
  await alert.getByRole('button', { name: 'Resume' }).click();
  await settled(page);
  await page.getByRole('textbox', { name: /Flux of each/ }).fill('2500');
  await settled(page);
  await expect(page.getByRole('table', { name: /Luminaires in place/ })).toContainText('2 500');
});

test('without a connection what is shown stays and works; another click opens the room', async ({
  page,
  context,
  watched,
}) => {
  await openRoom(page, 'Box');
  const layout = await places(page);
  const choose = async () => {
    await page.getByRole('banner').getByRole('button').first().click();
    await page
      .getByRole('dialog', { name: 'Rooms' })
      .getByRole('button', { name: 'E corridor' })
      .first()
      .click();
  };
  await context.setOffline(true);
  await choose();
  const alert = page.getByRole('alert').filter({ hasText: /no connection; try again/ });
  await expect(alert).toBeVisible();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Box');
  expect(await places(page)).toEqual(layout);
  await page.getByRole('textbox', { name: /Flux of each/ }).fill('2500');
  await settled(page);
  expect(watched.faults.splice(0).join()).toContain('ERR_INTERNET_DISCONNECTED');

  await context.setOffline(false);
  if (await page.getByRole('dialog', { name: 'Rooms' }).count()) await page.keyboard.press('Escape');
  await choose();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('E corridor');
  await settled(page);
});

test('a room that is being computed says so, and opens when it is ready', async ({ page }) => {
  test.setTimeout(180_000);
  const patience = { timeout: 60_000 }; // for rooms to load
  const room = (id: string, more: object = {}) => ({ id, title: id, file: `${id}.flux`, ...more });
  let list = { rooms: [room('office', { state: 'computing', progress: 0.4 }), room('box')] };
  await page.route('**/scenes/catalog.json', (route) => route.fulfill({ json: list }));
  await page.goto('./');
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('box', patience); // the first one that is ready
  await settled(page);
  const choose = async () => {
    await page.keyboard.press('g');
    return page.getByRole('dialog', { name: 'Rooms' }).getByRole('button', { name: /^office/ });
  };
  await expect(await choose()).toContainText('being computed, 40 %');
  await (await choose()).click();
  await expect(
    page.getByRole('alert').filter({ hasText: /not ready yet: being computed, 40 %/ }),
  ).toBeVisible();

  list = { rooms: [room('office'), room('box')] };
  await expect(await choose()).not.toContainText('being computed');
  await (await choose()).click();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('office', patience);
  await settled(page);
});

test('a full disk is told once, and the work goes on', async ({ page }) => {
  await page.addInitScript(() => {
    const full = () => {
      throw new DOMException('the disk is full', 'QuotaExceededError');
    };
    IDBObjectStore.prototype.put = full;
    Storage.prototype.setItem = full;
  });
  await openRoom(page, 'Box');
  const told = page.getByRole('region', { name: 'Messages' }).getByText(/refuses to store the work/);
  await expect(told).toBeVisible();
  await places(page); // the tab of the luminaires
  await page.getByRole('textbox', { name: /Flux of each/ }).fill('2500');
  await settled(page);
  await expect(page.getByRole('table', { name: /Luminaires in place/ })).toContainText('2 500');
  await page.waitForTimeout(2000); // longer than the pause before the next attempt to store
  await expect(told).toHaveCount(1);
});

test('a browser without 3D graphics is told what to do', async ({ page, watched }) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.goto('./');
  const alert = page.getByRole('alert');
  await expect(alert).toContainText(/no 3D graphics.*hardware acceleration/);
  await expect(alert.getByRole('button', { name: 'Try again' })).toBeVisible();
  watched.faults.length = 0; // three reports it to the console, too
});

const broken: readonly [string, string | RegExp, number | null, RegExp][] = [
  ['the worker is blocked', /\/assets\/worker-[^/]{8}\.js$/, null, /script cannot be loaded/],
  ['the module is missing', '**/*.wasm', 404, /core\.wasm cannot be loaded/],
  ['the room does not arrive', '**/*.flux', null, /no connection/],
  ['there is no list of rooms', '**/catalog.json', 404, /list of rooms could not be loaded/],
];

for (const [what, pattern, status, words] of broken)
  plain(`a start where ${what} ends in one sentence and a button that mends it`, async ({ page }) => {
    await page.route(pattern, (route) =>
      status === null ? route.abort() : route.fulfill({ status, body: '' }),
    );
    await page.goto('./');
    const alert = page.getByRole('alert').filter({ hasText: words });
    await expect(alert).toBeVisible();
    await expect(page.getByRole('alert')).toHaveCount(1);
    await expect(page.locator('.spinner')).toHaveCount(0);
    await page.unroute(pattern);
    await alert.getByRole('button', { name: 'Try again' }).click();
    await settled(page);
    await expectLit(page);
  });

plain('a start without the app says so and offers to try again', async ({ page }) => {
  const app = /\/assets\/app-[^/]{8}\.js$/; // and no other script whose name begins so
  await page.route(app, (route) => route.abort());
  await page.goto('./');
  await expect(page.getByText('Fiat Lux could not be started')).toBeVisible();
  await page.unroute(app);
  await page.getByRole('link', { name: 'Try again' }).click();
  await settled(page);
});

plain('a start where the server never answers is not waited for without end', async ({ page }) => {
  await page.clock.install();
  await page.route('**/*.flux', () => undefined);
  await page.goto('./');
  const waiting = page.getByRole('status').filter({ hasText: 'Opening the room' });
  await expect(waiting).toBeVisible();
  await expect(waiting.getByRole('button')).toHaveCount(0);
  await page.clock.fastForward(21_000);
  await expect(waiting.getByRole('button', { name: 'Try again' })).toBeVisible();
});

plain('without scripts the page says that it needs them', async ({ browser, baseURL }) => {
  const page = await browser.newPage({ javaScriptEnabled: false });
  await page.goto(baseURL ?? '');
  await expect(page.getByText(/by JavaScript: switch it on/)).toBeVisible();
  await expect(page.getByRole('link', { name: 'Open it again' })).toBeVisible();
  await page.close();
});

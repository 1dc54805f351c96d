// The pictures of the documentation and of the gallery, taken from the built site in Debian's Chromium:
// docs/screenshot.jpg (the first screen), public/thumbnails/{light,dark}/<id>.jpg, docs/experiments/<id>.jpg.
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { preview } from 'vite';
import { catalog, experiments } from '../rooms/catalog.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..');

const patience = 120_000; // ms, for rooms to load and searches to settle on a busy machine

// What is left of the page for a picture of the room alone.
const roomOnly = `
  .top-bar, .panel, .messages, .labels, .stage > :not(canvas) { display: none !important; }
  .shell { display: block !important; }
  .stage { position: fixed !important; inset: 0; }
`;

/** Opens an entry of the gallery by the palette and waits until its search has settled. */
async function openEntry(page, title) {
  await page.keyboard.press('Control+K');
  await page.getByRole('combobox', { name: 'Find an action' }).fill(`Open: ${title}`);
  await page.keyboard.press('Enter');
  await page.locator('.room-button', { hasText: title }).waitFor({ state: 'attached', timeout: patience });
  await settled(page);
}

/** What the experiment's last step is: the button, pressed although the panel is not in the picture. */
async function findAlpha(page) {
  await page.evaluate(() =>
    [...document.querySelectorAll('button')].find((each) => each.textContent === 'Find alpha').click(),
  );
  await page.locator('.alpha-plot figcaption').waitFor({ state: 'attached', timeout: patience });
  await settled(page);
}

/** The search is over and stays so, and the last picture is on the screen. */
async function settled(page) {
  await page.waitForFunction(
    () => {
      const isSettled =
        document.querySelector('.loading') === null &&
        document.querySelector('.status-state')?.textContent === 'Settled';
      window.settledSince = isSettled ? (window.settledSince ?? performance.now()) : undefined;
      return isSettled && performance.now() - window.settledSince > 1500;
    },
    undefined,
    { timeout: patience },
  );
}

/** The light has its colour and the shadows near contacts, which come some time after it is there. */
async function complete(page) {
  const isThere = () => performance.getEntriesByName('contacts lit').length > 0;
  await page.waitForFunction(isThere, undefined, { timeout: patience });
  await page.waitForTimeout(1500);
}

/** A JPEG of the page, scaled down to `width` x `height` in the browser; the quality falls until it is small enough. */
async function jpeg(page, file, width, height, largest) {
  const png = (await page.screenshot()).toString('base64');
  const shrink = async ({ png, width, height, quality }) => {
    const blob = await (await fetch(`data:image/png;base64,${png}`)).blob();
    const picture = await createImageBitmap(blob, {
      resizeWidth: width,
      resizeHeight: height,
      resizeQuality: 'high',
    });
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    canvas.getContext('2d').drawImage(picture, 0, 0);
    return canvas.toDataURL('image/jpeg', quality).split(',')[1];
  };
  for (let quality = 0.86; quality > 0.3; quality -= 0.06) {
    const bytes = Buffer.from(await page.evaluate(shrink, { png, width, height, quality }), 'base64');
    if (bytes.length > largest) continue;
    mkdirSync(path.dirname(path.join(root, file)), { recursive: true });
    writeFileSync(path.join(root, file), bytes);
    console.log(`${file}: ${width} x ${height}, ${(bytes.length / 1000).toFixed(0)} kB`);
    return;
  }
  throw new Error(`${file} does not fit into ${largest} bytes`);
}

const server = await preview({
  root: path.join(root, 'web'),
  configFile: path.join(root, 'vite.config.js'),
  preview: { port: 0, host: '127.0.0.1' },
});
const address = `http://127.0.0.1:${server.httpServer.address().port}/`;
const browser = await chromium.launch({
  executablePath: '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
try {
  const only = process.argv.slice(2); // ids, or "screenshot"; nothing means all
  const wanted = (id) => only.length === 0 || only.includes(id);
  const open = async (width, height, style) => {
    const page = await browser.newPage({
      viewport: { width, height },
      colorScheme: 'dark',
      reducedMotion: 'reduce',
      bypassCSP: true,
      serviceWorkers: 'block',
    });
    await page.goto(address);
    if (style) await page.addStyleTag({ content: style });
    await settled(page);
    return page;
  };
  if (wanted('screenshot')) {
    const page = await open(1440, 900);
    await complete(page);
    await jpeg(page, 'docs/screenshot.jpg', 1440, 900, 250_000);
    await page.close();
  }
  const page = await open(960, 600, roomOnly);
  const inBothSchemes = async (id, width, height, largest) => {
    for (const colorScheme of ['light', 'dark']) {
      await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
      await settled(page);
      await complete(page);
      await jpeg(page, `public/thumbnails/${colorScheme}/${id}.jpg`, width, height, largest);
    }
  };
  for (const { id, said } of catalog.filter((entry) => wanted(entry.id))) {
    await openEntry(page, said.en.title);
    await inBothSchemes(id, 480, 300, 30_000);
  }
  for (const { id, said } of experiments.filter((entry) => wanted(entry.id))) {
    await openEntry(page, said.en.title);
    if (id === '5.4-find-alpha') await findAlpha(page);
    await inBothSchemes(id, 320, 200, 12_000);
    await jpeg(page, `docs/experiments/${id}.jpg`, 960, 600, 80_000); // dark, as the last of the two
  }
} finally {
  await browser.close();
  await server.close();
}

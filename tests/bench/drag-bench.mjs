/**
 * The built app in Chromium: how long from the `input` event of a slider that a mouse drags to the worker's post of a
 * layout. E corridor, six luminaires, three constraints on the yellow wall. Both ends are told by the app's own messages
 * (askedAt, postedAt: one clock by performance.timeOrigin), which the page's Worker is made to write down.
 */
import { spawn } from 'node:child_process';
import path from 'node:path';
import { chromium } from 'playwright-core';
import { createServer } from 'vite';
import { openSession, wishOf } from './open-session.mjs';

const inputs = 60; // of the slider
const interval = 50; // ms between them
const settledWithin = 0.02; // of the value that a long search finds
const longSearch = 10_000; // ms, for every tenth input; a tenth of it for the others
const viewport = { width: 1280, height: 800 };

/** Serves dist/ while `use` runs. */
export async function served(root, use) {
  const port = 4191;
  const args = ['vite', 'preview', '--port', String(port), '--strictPort', '--host', '127.0.0.1'];
  const server = spawn('npx', args, { cwd: root, stdio: ['ignore', 'pipe', 'inherit'], detached: true });
  try {
    await new Promise((resolve, reject) => {
      server.stdout.on('data', (text) => String(text).includes(String(port)) && resolve());
      server.on('exit', (code) => reject(new Error(`vite preview ended with status ${code}`)));
    });
    return await use(`http://127.0.0.1:${port}/`);
  } finally {
    process.kill(-server.pid);
  }
}

/** `options`: of the page, such as { reducedMotion: 'reduce' }. */
export async function inBrowser(use, options = {}) {
  const browser = await chromium.launch({
    executablePath: '/usr/bin/chromium',
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
  try {
    return await use(await browser.newPage({ viewport, serviceWorkers: 'block', ...options }));
  } finally {
    await browser.close();
  }
}

/** In the page, before its scripts: every Worker writes down wishes and answers. */
export function recordWorkers() {
  const record = (globalThis.__record = { asked: [], answered: [] });
  globalThis.Worker = class extends Worker {
    constructor(...args) {
      super(...args);
      this.addEventListener('message', ({ data }) => {
        if (data.type !== 'improved' && data.type !== 'settled') return;
        const { revision, askedAt, postedAt, shown } = data;
        record.answered.push({
          revision,
          askedAt,
          postedAt,
          isSettled: data.type === 'settled',
          violation: shown.violation,
          value: shown.goals[0].value,
        });
      });
    }
    postMessage(message, transfer) {
      const sentAt = performance.timeOrigin + performance.now();
      if (message.type === 'solve') record.asked.push({ ...structuredClone(message), sentAt });
      super.postMessage(message, transfer);
    }
  };
}

/** The link of the measured document, encoded by the app's own code. */
async function linkOf(root, identity) {
  const vite = await createServer({
    configFile: path.join(root, 'vite.config.js'),
    root: path.join(root, 'web'),
    server: { middlewareMode: true },
    appType: 'custom',
    optimizeDeps: { noDiscovery: true },
    logLevel: 'error',
  });
  try {
    const { encodeLink } = await vite.ssrLoadModule('/document/share-link.ts');
    return encodeLink({
      scene: identity,
      room: 'e-corridor',
      saving: false,
      quantity: 'illuminance',
      seed: 1,
      cards: [
        {
          id: 'wall',
          surfaces: ['yellow wall'],
          verb: 'homogenize',
          weight: 1,
          mean: { min: 20, max: 60 },
          guarantee: { by: 'chebyshev', alpha: 2, min: 5 },
        },
      ],
      luminaires: {
        count: 6,
        flux: 3e3,
        dimming: [1, 1],
        excluded: [],
        minDistance: 0,
      },
      layout: null,
      camera: null,
      display: null,
    });
  } finally {
    await vite.close();
  }
}

const answers = (page) => page.evaluate(() => globalThis.__record.answered.length);

/** Drags the slider of the least mean over half of its length, one step an interval. */
async function dragSlider(page) {
  const slider = page.locator('input').and(page.getByLabel('yellow wall: mean at least')).first();
  for (const name of [/yellow wall/, /^More/])
    if (!(await slider.isVisible())) await page.getByRole('button', { name }).first().click();
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  const y = box.y + box.height / 2;
  const share = await slider.evaluate((input) => (input.value - input.min) / (input.max - input.min));
  const thumb = 16;
  const x = box.x + thumb / 2 + share * (box.width - thumb);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= inputs; ++i) {
    await page.mouse.move(x + (i / inputs) * 0.3 * box.width, y);
    await page.waitForTimeout(interval);
  }
  await page.mouse.up();
}

async function record(root, address) {
  return inBrowser(async (page) => {
    await page.addInitScript(recordWorkers);
    await page.goto(address);
    await page.waitForFunction(() => globalThis.__record.answered.length > 0, null, { timeout: 60_000 });
    await page.waitForTimeout(3_000); // settled, and the first frames drawn
    const before = await page.evaluate(() => globalThis.__record.asked.length);
    const seen = await answers(page);
    await dragSlider(page);
    await page.waitForTimeout(2_500);
    const canvas = await page
      .locator('canvas')
      .first()
      .evaluate(({ width, height }) => `${width} x ${height}`);
    const { asked, answered } = await page.evaluate(() => globalThis.__record);
    return { asked: asked.slice(before), answered: answered.slice(seen), canvas };
  });
}

const isBetter = (a, b) =>
  a.violation < b.violation - 1e-9 || (a.violation <= b.violation + 1e-9 && a.value < b.value);

/** The best that long searches from two starts find for a wish of the page. */
function bestOf(session, { intentions, start }, milliseconds) {
  const error = session.setIntentions(wishOf(session, intentions));
  if (error) throw new Error(error);
  const ends = [null, start].map((from) => {
    if (from) session.startFrom(7, Uint32Array.from(from.sites), Float64Array.from(from.flux), from.dimming);
    else session.start(7);
    const begin = performance.now();
    do session.advance(100_000);
    while (performance.now() - begin < milliseconds / 2);
    const { constraints, goals } = session.incumbent();
    let violation = 0;
    for (let i = 1; i < constraints.length; i += 3) violation += constraints[i] > 1e-6 ? constraints[i] : 0;
    return { violation, value: goals[0] };
  });
  return isBetter(ends[0], ends[1]) ? ends[0] : ends[1];
}

const quantile = (values, share) =>
  [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))];

export async function dragToLayout(root, flux, inflate) {
  const session = await openSession(path.join(root, 'web/solver/core.wasm'), flux, inflate);
  const { identity } = session.info();
  const link = await linkOf(root, identity);
  const { asked, answered, canvas } = await served(root, (address) => record(root, address + link));
  const first = [];
  const near = []; // Infinity where no answer came near before the next input
  const gaps = [];
  const page = []; // until the page has asked the worker: the browser's queue and the app's own work
  asked.forEach((wish, i) => {
    const mine = answered.filter(({ revision }) => revision === wish.revision);
    first.push(mine.length > 0 ? mine[0].postedAt - wish.askedAt : Infinity);
    page.push(wish.sentAt - wish.askedAt);
    const best = bestOf(session, wish, i % 10 === 0 ? longSearch : longSearch / 10);
    const isNear = ({ violation, value }) =>
      violation <= best.violation + 1e-6 && value <= best.value * (1 + settledWithin);
    near.push((mine.find(isNear)?.postedAt ?? Infinity) - wish.askedAt);
    if (mine.length > 0) gaps.push(mine[0].value / best.value - 1);
  });
  session.delete();
  const figure = (value) => (Number.isFinite(value) ? Number(value.toFixed(2)) : null);
  return {
    native: null,
    wasm: figure(quantile(near, 0.5)),
    unit: 'ms',
    spread: figure(quantile(near, 0.75) - quantile(near, 0.25)),
    p50: figure(quantile(near, 0.5)),
    p95: figure(quantile(near, 0.95)),
    first_p50: figure(quantile(first, 0.5)),
    first_p95: figure(quantile(first, 0.95)),
    page_p50: figure(quantile(page, 0.5)),
    page_p95: figure(quantile(page, 0.95)),
    first_gap_p95: Number(quantile(gaps, 0.95)?.toFixed(4) ?? NaN),
    inputs: asked.length,
    answered: answered.length,
    canvas,
    within: settledWithin,
    luminaires: 6,
    constraints: asked[0]?.intentions.constraints.length ?? 0,
  };
}

/** The scripts that the page has asked for when its first layout is there: files of dist/. */
export async function firstPaintScripts(index) {
  const dist = path.dirname(index);
  const files = new Set();
  await served(path.dirname(dist), (address) =>
    inBrowser(async (page) => {
      await page.addInitScript(recordWorkers);
      page.context().on('request', (request) => {
        const { pathname } = new URL(request.url());
        if (pathname.endsWith('.js')) files.add(path.join(dist, pathname));
      });
      await page.goto(address);
      await page.waitForFunction(() => globalThis.__record.answered.length > 0, null, { timeout: 60_000 });
    }),
  );
  return [...files];
}

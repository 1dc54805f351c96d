/**
 * Rooms that the page computes itself. Under Node: the whole pass in Wasm beside the command, in processor time, and how far
 * their statistics are apart. In Chromium: how long from the drop of a model on the built page until it is lit, and how
 * long the page's own tasks are meanwhile.
 */
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { inflateSync } from 'node:zlib';
import { createServer } from 'vite';
import { inBrowser, recordWorkers, served } from './drag-bench.mjs';
import { openSession, wishOf } from './open-session.mjs';

const layouts = 24; // half of one luminaire, half of six
const least = 1e-3; // of the room's mean: below it a surface is as good as dark
const rest = 5000; // ms: a person looks at the page before; until then it makes ready what draws a model
const patience = 900_000; // ms, for light in full

/** A scene file made by the module that the page uses, by one worker in this process; and the seconds of processor it took. */
async function builtInWasm(root, model) {
  // note: the page's own scripts are TypeScript.
  const vite = await createServer({
    configFile: false,
    root,
    server: { middlewareMode: true },
    appType: 'custom',
    optimizeDeps: { noDiscovery: true },
    logLevel: 'error',
  });
  try {
    const { poolOf } = await vite.ssrLoadModule('/tests/wasm/builder-workers.ts');
    const { usualOptions } = await vite.ssrLoadModule('/web/builder/builder.ts');
    const begin = process.cpuUsage();
    const { file } = await poolOf(1).build({
      model: { name: path.basename(model), bytes: new Uint8Array(readFileSync(model)), siblings: new Map() },
      options: usualOptions,
      signal: new AbortController().signal,
      tell: () => undefined,
    });
    const { user, system } = process.cpuUsage(begin);
    return { file: new Uint8Array(file), seconds: (user + system) / 1e6 };
  } finally {
    await vite.close();
  }
}

/** Mean and sigma of each surface under seeded layouts; `floor`: what a mean is measured against at least. */
async function statisticsOf(wasm, file) {
  const session = await openSession(wasm, file, inflateSync);
  const { surfaces, siteSize } = session.info();
  const sites = siteSize.length;
  const area = surfaces.reduce((sum, surface) => sum + surface.area, 0);
  const rows = [];
  for (let i = 0; i < layouts; ++i) {
    const count = i % 2 === 0 ? 1 : 6;
    const places = Array.from({ length: count }, (_, k) => (17 + 31 * i + 13 * k * (i + 1)) % sites);
    const hung = [...new Set(places)].sort((a, b) => a - b);
    const goals = [{ statistic: 'sigma', sense: 'min', weight: 1, surfaces: ['all'] }];
    const fault = session.setIntentions(wishOf(session, { goals, luminaires: { count: hung.length } }));
    if (fault) throw new Error(fault);
    const shown = session.show(Uint32Array.from(hung), new Float64Array(hung.length).fill(3e3), 1);
    if (typeof shown === 'string') throw new Error(shown);
    const of = surfaces.map((_, s) => [shown.surfaces[4 * s], shown.surfaces[4 * s + 1]]);
    const whole = of.reduce((sum, [mean], s) => sum + mean * surfaces[s].area, 0) / area;
    rows.push({ of, floor: least * whole });
  }
  session.delete();
  return rows;
}

/** The largest differences of the means and of the sigmas, as shares of the command's. */
function apart(ours, theirs) {
  const worst = [0, 0];
  for (const [i, { of, floor }] of theirs.entries())
    for (const [s, values] of of.entries())
      for (const [k, value] of values.entries())
        worst[k] = Math.max(worst[k], Math.abs(ours[i].of[s][k] - value) / Math.max(value, floor));
  return { mean: worst[0], sigma: worst[1] };
}

/**
 * The whole pass on a model without options. `command(model, target)`: runs the command, answers its seconds of processor.
 * The statistics of both files under the same layouts.
 */
export async function pageBesideCommand(root, model, command) {
  const folder = mkdtempSync(path.join(tmpdir(), 'fiatlux-bench-'));
  try {
    const [ours, theirs] = ['page', 'command'].map((name) => path.join(folder, `${name}.flux`));
    const native = await command(model, theirs);
    const wasm = await builtInWasm(root, model);
    writeFileSync(ours, wasm.file);
    const core = path.join(root, 'web/solver/core.wasm');
    const [a, b] = [await statisticsOf(core, ours), await statisticsOf(core, theirs)];
    return { native, wasm: wasm.seconds, apart: apart(a, b) };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** In the page, before its scripts: writes down its tasks of more than 50 ms. */
function recordTasks() {
  const tasks = (globalThis.__tasks = []);
  new PerformanceObserver((list) => {
    for (const { startTime, duration } of list.getEntries())
      tasks.push({ begun: startTime, lasted: duration });
  }).observe({ type: 'longtask' });
}

/** Holds a file over the page for a second, as a hand does at least, and drops it; the page's clock then, ms. */
function drop(page, name, contents) {
  return page.evaluate(
    async ([file, data]) => {
      const bytes = await (await fetch(`data:application/octet-stream;base64,${data}`)).arrayBuffer();
      const transfer = new DataTransfer();
      transfer.items.add(new File([bytes], file));
      performance.clearMarks();
      globalThis.__record.answered.length = 0;
      const tell = (type) =>
        document
          .querySelector('main')
          .dispatchEvent(new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }));
      tell('dragenter');
      tell('dragover');
      await new Promise((resolve) => setTimeout(resolve, 1000));
      const at = performance.now();
      tell('drop');
      return at;
    },
    [name, contents.toString('base64')],
  );
}

/**
 * ms from the drop of a model on the built page, whose search has ended, until its preview is on the screen in the light of a
 * layout, and its full light; and the longest task of the page until a second later, 0 where none is longer than 50 ms.
 */
export function dropToLight(root, model) {
  return served(root, (address) =>
    inBrowser(async (page) => {
      await page.addInitScript(recordWorkers);
      await page.addInitScript(recordTasks);
      await page.goto(`${address}?room=box`);
      const isAtRest = () => globalThis.__record.answered.some(({ isSettled }) => isSettled);
      await page.waitForFunction(isAtRest, null, { timeout: patience });
      await page.waitForTimeout(rest);
      const begun = await drop(page, `dropped ${path.basename(model)}`, readFileSync(model));
      // The layout that is answered after the room was put on the screen is that of this room.
      const lit = (nth) =>
        page
          .waitForFunction(
            (which) => {
              const shown = performance.getEntriesByName('room displayed')[which]?.startTime;
              const first = globalThis.__record.answered.find(
                ({ postedAt }) => postedAt - performance.timeOrigin > shown,
              );
              return first && first.postedAt - performance.timeOrigin;
            },
            nth,
            { timeout: patience },
          )
          .then((handle) => handle.jsonValue());
      const [preview, full] = [(await lit(0)) - begun, (await lit(1)) - begun];
      await page.waitForTimeout(1000);
      const tasks = await page.evaluate(() => globalThis.__tasks);
      const longest = Math.max(0, ...tasks.filter((task) => task.begun > begun).map(({ lasted }) => lasted));
      return { preview, full, longest };
    }),
  );
}

/**
 * The app's picture beside a path-traced one (path_trace.cpp) of the same view, layout, exposure and tone curve: how far
 * what is on the screen is from what an eye would see, near contacts and elsewhere, without and with the light within a
 * patch (web/viewer/contact). Rewrites the section of docs/contact-light.md and docs/contact-light/<view>.jpg;
 * views that are not named keep theirs.
 *
 *   node tests/reference/path-traced-pictures.mjs [view ...]     after `npm run build` and `cmake --build build/native
 *                                                                --target path_trace`; a view takes minutes
 */
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { inflateSync } from 'node:zlib';
import { chromium } from 'playwright-core';
import { PNG } from 'pngjs';
import { preview, runnerImport } from 'vite';
import { openSession } from '../bench/open-session.mjs';
import { at, layoutsOf, root, said } from './reference-room.mjs';

const [width, height] = [480, 320]; // pixels
const paths = 48; // a pixel
const patience = 180_000; // ms
const isNear = 0.04; // share of what lies before a place, by the cosine, that is nearer than 0.15 m
const fields = 13; // a pixel of path_trace

/** Where the eye is and where it looks, m. The method's constants were chosen in the first two rooms. */
const views = {
  box: { room: 'box', position: [0.3, 2.1, 3.8], target: [1.9, 0.4, 2.1] },
  desk: { room: 'office', position: [3.35, 1.4, 4.1], target: [2.62, 0.76, 3.38] },
  gallery: { room: 'gallery', position: [4.4, 1.6, 7.6], target: [2.6, 0.5, 6.4] },
  home: { room: 'home', position: [3.6, 1.4, 4.5], target: [1.6, 0.25, 3.1] },
};

const shell = /^(wall|floor|ceiling|skirting)/; // where two of these meet, patches say what there is to say

const { encodeLink } = (await runnerImport(at('web/document/share-link.ts'), { configFile: false })).module;
const { fov } = (await runnerImport(at('web/viewer/eye/room-poses.ts'), { configFile: false })).module;
const { automaticExposure } = (await runnerImport(at('web/viewer/light/exposure.ts'), { configFile: false }))
  .module;

const ofLuminance = [0.2126, 0.7152, 0.0722];
const luminance = (color) => color.reduce((sum, value, k) => sum + ofLuminance[k] * value, 0);
const linear = Float64Array.from({ length: 256 }, (_, byte) => {
  const s = byte / 255;
  return s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
});
const encoded = (value) => {
  const v = Math.min(1, Math.max(0, value));
  return Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
};

/** As the light material's shader has it. */
function toneCurve(color) {
  const knee = 0.42;
  const shoulder = (value) => {
    const over = Math.max(0, value - knee) / (1 - knee);
    return Math.min(value, knee) + ((1 - knee) * over) / (1 + over);
  };
  const peak = Math.max(...color, 1e-6);
  return color.map((value) => 0.5 * (value * (shoulder(peak) / peak) + shoulder(value)));
}

/** L* of CIE 1976, 0 to 100: steps of it look alike. */
function lightness(data, pixel) {
  const y = luminance([0, 1, 2].map((k) => linear[data[4 * pixel + k]]));
  return y > 0.008856 ? 116 * Math.cbrt(y) - 16 : 903.3 * y;
}

/** What a path tracer sees: `pixels`, and the names of the surfaces. */
function traced(view, layout, folder) {
  const file = (name) => path.join(folder, name);
  writeFileSync(file('layout.json'), JSON.stringify(layout));
  writeFileSync(file('view.json'), JSON.stringify({ ...view, fov, width, height, paths }));
  const program = at('build/native/tests/path_trace');
  const glb = at(`public/scenes/${view.room}.glb`);
  const { surfaces } = JSON.parse(said(program, glb, file('layout.json'), file('view.json'), file('pixels')));
  const bytes = readFileSync(file('pixels'));
  return { surfaces, pixels: new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4) };
}

/** lx in three channels: of both halves of the paths, or of one. */
function lightAt(pixels, i, halves = [0, 1]) {
  const direct = pixels[fields * i];
  const of = (k) => halves.reduce((sum, half) => sum + pixels[fields * i + 1 + 3 * half + k], 0);
  return [0, 1, 2].map((k) => direct + of(k) / halves.length);
}

/** The picture of them under an exposure. */
function pictureOf(pixels, exposure, halves) {
  const picture = new PNG({ width, height });
  for (let i = 0; i < width * height; i++) {
    const albedo = pixels.subarray(fields * i + 7, fields * i + 10);
    const color = lightAt(pixels, i, halves).map((light, k) => light * albedo[k] * exposure);
    toneCurve(color).forEach((value, k) => (picture.data[4 * i + k] = encoded(value)));
    picture.data[4 * i + 3] = 255;
  }
  return picture;
}

/** The link to a view of a layout, under an exposure that follows nothing. */
function linkTo(view, info, { luminaires }, level) {
  return encodeLink({
    scene: info.identity,
    room: view.room,
    cards: [],
    saving: false,
    luminaires: { count: luminaires.length, flux: 4000, dimming: [0, 1], excluded: [], minDistance: 0 },
    quantity: 'illuminance',
    seed: 1,
    layout: {
      positions: luminaires.map(({ position }) => position),
      flux: luminaires.map(({ flux }) => flux),
      dimming: 1,
      pinned: [],
    },
    camera: { position: view.position, target: view.target, plan: false, aspect: width / height },
    display: {
      mode: 'realistic',
      exposure: 0,
      exposureLevel: level,
      colorMap: 'viridis',
      steps: 0,
      logarithmic: false,
      range: [0, 1000],
      isolux: false,
      quantity: 'illuminance',
      cutAway: true,
      measuringPlanes: false,
      luminaires: false,
    },
  });
}

/** What the page draws, once it has come to rest; without contacts no worker is there to work them out. */
async function shown(browser, address, hasContacts) {
  const page = await browser.newPage({
    viewport: { width, height },
    reducedMotion: 'reduce',
    bypassCSP: true,
    serviceWorkers: 'block',
  });
  await page.addInitScript((isWanted) => {
    const { getContext } = HTMLCanvasElement.prototype;
    // A pixel is what its middle sees, as in the other picture.
    HTMLCanvasElement.prototype.getContext = function (kind, options) {
      return getContext.call(this, kind, kind === 'webgl2' ? { ...options, antialias: false } : options);
    };
    const Real = window.Worker;
    window.Worker = function (url, options) {
      if (options?.name !== 'contacts' || isWanted) return new Real(url, options);
      return { postMessage: () => performance.mark('contacts left out'), terminate() {} };
    };
  }, hasContacts);
  await page.goto(address);
  const mark = hasContacts ? 'contacts lit' : 'contacts left out';
  const isThere = (name) => performance.getEntriesByName(name).length > 0;
  await page.waitForFunction(isThere, mark, { timeout: patience });
  await page.addStyleTag({
    content: '.stage > :not(canvas), .labels, .messages, .embed-caption { display: none !important; }',
  });
  const shot = async () => PNG.sync.read(await page.locator('canvas').first().screenshot());
  for (let last = await shot(); ;) {
    await page.waitForTimeout(1500);
    const now = await shot();
    const isSame = now.data.equals(last.data);
    last = now;
    if (!isSame) continue;
    await page.close();
    if (now.width !== width || now.height !== height) throw new Error(`the picture is ${now.width} wide`);
    return now;
  }
}

/** Pixels near contacts, and all others that show something. */
function placesIn(pixels, surfaces) {
  const isShell = surfaces.map((name) => shell.test(name));
  const [near, elsewhere] = [[], []];
  for (let i = 0; i < width * height; i++) {
    const [share, own, other] = pixels.subarray(fields * i + 10, fields * i + 13);
    if (own < 0) continue;
    const isCorner = isShell[own] && (other < 0 || isShell[other]);
    if (share >= isNear && !isCorner) near.push(i);
    else if (share < isNear) elsewhere.push(i);
  }
  return { near, elsewhere };
}

/**
 * Root mean square and mean of the differences in lightness. `truths`: by either half of the paths; what one of them has by
 * chance the other has not, so the mean of the products of both differences is free of it.
 */
function differences(picture, truths, places) {
  let [products, sum] = [0, 0];
  for (const i of places) {
    const shown = lightness(picture.data, i);
    const [one, other] = truths.map((truth) => shown - lightness(truth.data, i));
    products += one * other;
    sum += (one + other) / 2;
  }
  return { rms: Math.sqrt(Math.max(0, products / places.length)), mean: sum / places.length };
}

/** Three pictures in a row as a JPEG. */
async function save(browser, pictures, file) {
  const row = new PNG({ width: 3 * width + 16, height });
  row.data.fill(255);
  pictures.forEach((picture, i) => PNG.bitblt(picture, row, 0, 0, width, height, i * (width + 8), 0));
  const page = await browser.newPage();
  const jpeg = await page.evaluate(async (png) => {
    const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${png}`)).blob());
    const canvas = Object.assign(document.createElement('canvas'), {
      width: bitmap.width,
      height: bitmap.height,
    });
    canvas.getContext('2d').drawImage(bitmap, 0, 0);
    return canvas.toDataURL('image/jpeg', 0.85).split(',')[1];
  }, PNG.sync.write(row).toString('base64'));
  await page.close();
  mkdirSync(path.dirname(file), { recursive: true });
  writeFileSync(file, Buffer.from(jpeg, 'base64'));
}

async function rowOf(name, browser, origin, folder) {
  const view = views[name];
  const session = await openSession(
    at('web/solver/core.wasm'),
    at(`public/scenes/${view.room}.flux`),
    inflateSync,
  );
  const info = session.info();
  const { free } = layoutsOf(info);
  const { surfaces, pixels } = traced(view, free, folder);

  // Exposed for what the eye sees there.
  const lit = Array.from({ length: width * height }, (_, i) => luminance(lightAt(pixels, i)));
  const level = Number(lit.toSorted((a, b) => a - b)[lit.length >> 1].toPrecision(3));
  const exposure = automaticExposure(level);
  const truth = pictureOf(pixels, exposure);
  const halves = [0, 1].map((half) => pictureOf(pixels, exposure, [half]));
  const address = `${origin}?embed${linkTo(view, info, free, level)}`;
  const without = await shown(browser, address, false);
  const withContacts = await shown(browser, address, true);
  await save(browser, [without, withContacts, truth], at(`docs/contact-light/${name}.jpg`));

  const { near, elsewhere } = placesIn(pixels, surfaces);
  const [before, after] = [without, withContacts].map((picture) => differences(picture, halves, near));
  const others = differences(withContacts, halves, elsewhere);
  const share = `${((100 * near.length) / (near.length + elsewhere.length)).toFixed(0)} %`;
  const numbers = [before.rms, after.rms, before.mean, after.mean, others.rms].map((x) => x.toFixed(1));
  return `| [${name}](contact-light/${name}.jpg) | ${[view.room, share, ...numbers].join(' | ')} |`;
}

const title = '## Beside path-traced pictures';
const introduction = `${title}

Made by \`node tests/reference/path-traced-pictures.mjs\`: nothing below is edited by hand.

What is on the screen under six luminaires of 4000 lm, in ${width} x ${height} pixels, beside what ${paths} paths a pixel bring
(\`tests/reference/path_trace.cpp\`: no patches, no means, red, green and blue), under the same exposure and tone curve. Differences of
lightness (L*, 0 to 100, of which an eye sees about one) from the path-traced picture: root mean square and mean over the pixels near
contacts, where ${100 * isNear} % of what lies before a place is nearer than 0.15 m and not the shell of the room itself, without and with
the light within a patch; and over the pixels where nothing is near. They are products of the differences from two pictures of half the
paths each, so the path tracer's noise is not among them. The pictures show, from the left, without, with, and path-traced. The method's constants were chosen
in the box and the office.

| view | room | near | without | with | mean without | mean with | elsewhere |
| --- | --- | --- | --- | --- | --- | --- | --- |
`;

const document = at('docs/contact-light.md');
const before = existsSync(document) ? readFileSync(document, 'utf8') : '';
const start = before.indexOf(title);
const kept = start < 0 ? [] : before.slice(start).split('\n');
const asked = process.argv.slice(2);
const server = await preview({
  root: path.join(root, 'web'),
  configFile: at('vite.config.js'),
  preview: { port: 0, host: '127.0.0.1' },
});
const origin = `http://127.0.0.1:${server.httpServer.address().port}/`;
const browser = await chromium.launch({
  executablePath: '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
const folder = mkdtempSync(path.join(tmpdir(), 'path-traced-'));
try {
  const rows = [];
  for (const name of Object.keys(views)) {
    const isAsked = asked.length === 0 || asked.includes(name);
    if (!isAsked) rows.push(...kept.filter((line) => line.startsWith(`| [${name}]`)));
    else rows.push(await rowOf(name, browser, origin, folder));
    if (isAsked) console.log(rows.at(-1));
  }
  writeFileSync(
    document,
    `${(start < 0 ? before : before.slice(0, start)).trimEnd()}\n\n${introduction}${rows.join('\n')}\n`,
  );
} finally {
  rmSync(folder, { recursive: true });
  await browser.close();
  await server.close();
}

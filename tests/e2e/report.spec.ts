// What leaves the app for paper and for other programs says what the app says. Covers formats, plan-drawings, stf-project,
// result-lines, dimension-chain, report, report-page, places, plan-figure, light-figure, schedule, pointing, verdict.
import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import DxfParser from 'dxf-parser';
import { PNG } from 'pngjs';
import decodeQR from 'qr/decode.js';
import { decodeLink } from '../../web/document/share-link.ts';
import { readStf } from '../../web/document/stf.ts';
import { bare, pdfPages } from './pdf-text.ts';
import { canvas, expect, openApp, places, results, settled, tab, test, violations } from './app.ts';

/** What an entry of the file menu saves. */
async function saved(page: Page, entry: RegExp): Promise<string> {
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'File and export' }).click();
  await page.getByRole('menuitem', { name: entry }).click();
  return readFileSync(await (await download).path(), 'utf8');
}

/** What is written along each side of the plan, in m: from wall to luminaire, from luminaire to luminaire, to the wall. */
async function chains(page: Page): Promise<number[][]> {
  const plan = report(page).getByRole('img', { name: 'The plan with its luminaires' });
  const texts = await plan
    .locator('.chain')
    .evaluateAll((all) =>
      all.map((chain) => [...chain.querySelectorAll('text')].map((each) => each.textContent)),
    );
  return texts.map((chain) => chain.map(Number));
}

/** Half of the last digit of a place in the list. */
const listed = 0.0051; // m

test('CSV, DXF and STF of the office hold what the panel shows, to the millimetre', async ({ page }) => {
  await openApp(page);
  const shown = (await places(page)).map((text) => text.split(', ').map(Number));

  const table = (await saved(page, /luminaires \(CSV\)/)).trim().split('\r\n').slice(1);
  const exact = table.map((line) => line.split(',').slice(1, 4).map(Number));
  expect(exact).toHaveLength(shown.length);
  const apart = (a: readonly number[], b: readonly number[]) =>
    Math.max(...a.map((value, axis) => Math.abs(value - b[axis]!)));
  exact.forEach((place, i) => expect(apart(place, shown[i]!)).toBeLessThan(listed));

  const drawing = new DxfParser().parseSync(await saved(page, /plan \(DXF\)/));
  const entities = (drawing?.entities ?? []) as unknown as readonly {
    type: string;
    layer: string;
    position?: { x: number; y: number; z: number };
    vertices?: readonly { x: number; y: number }[];
  }[];
  const points = entities.filter(({ layer, type }) => layer === 'LUMINAIRES' && type === 'POINT');
  expect(points).toHaveLength(exact.length);
  points.forEach(({ position }, i) =>
    expect(apart([position!.x, position!.y, position!.z], exact[i]!)).toBeLessThan(1e-3),
  );
  const rooms = entities.filter(({ layer }) => layer === 'ROOM');
  expect(rooms[0]?.vertices?.map(({ x, y }) => `${x.toFixed(2)} ${y.toFixed(2)}`).sort()).toEqual(
    ['0.00 0.00', '12.00 0.00', '12.00 7.80', '0.00 7.80'].sort(),
  );
  expect(entities.filter(({ layer }) => layer === 'ISOLUX').length).toBeGreaterThan(2);
  expect(entities.filter(({ layer }) => layer === 'FURNITURE').length).toBeGreaterThan(50);

  const project = readStf(await saved(page, /STF/));
  if (typeof project === 'string') throw new Error(project);
  const [room] = project.rooms;
  expect(room).toMatchObject({ name: 'Open office', height: 2.8, workingPlane: 0.75 });
  expect(room?.outline).toHaveLength(4);
  room?.luminaires.forEach(({ place }, i) => expect(apart(place, exact[i]!)).toBeLessThan(1e-3));
  expect(room?.luminaires).toHaveLength(exact.length);

  const lines = (await saved(page, /results \(CSV\)/)).split('\r\n');
  const plane = (await results(page)).find((row) => row.startsWith('working plane'))!;
  const mean = Number(lines.find((line) => line.startsWith('surface,working plane,mean'))?.split(',')[4]);
  expect(plane).toContain(String(Math.round(mean)));
});

const report = (page: Page) => page.getByRole('dialog', { name: 'Report' });

test('the report of the office prints on three pages and says what the app says', async ({ page }) => {
  test.slow(); // a picture, axe and a PDF
  await openApp(page);
  await page.getByRole('combobox', { name: 'Add at …' }).selectOption({ label: 'meeting table' });
  await expect(page.getByRole('group', { name: 'task 1' })).toBeVisible();
  const rows = await results(page);
  const totals = await page.locator('.totals dd').allInnerTexts();
  const at = await places(page);
  await page.keyboard.press('Control+p');
  await expect(report(page).getByRole('heading', { level: 1 })).toHaveText('Open office');
  const view = report(page).getByRole('img', { name: 'The room as it is lit' });
  await expect(view).toBeVisible({ timeout: 90_000 }); // drawn by software
  await expect(view).toHaveCSS('object-fit', 'contain'); // what hangs at its edge is on the paper, too

  expect(await violations(page)).toEqual([]);
  const pdf = await page.pdf({ preferCSSPageSize: true, printBackground: true });
  const pages = pdfPages(pdf);
  expect(pages.length).toBeLessThanOrEqual(3);
  const text = pages.join('');
  const holds = (what: string) => expect(text).toContain(bare(what));
  holds('Open office');
  holds('12.00 × 7.80 × 2.80 m');
  holds('task 1 surround');
  for (const total of [totals[0], totals[2]]) holds(total!);
  const plane = rows.find((row) => row.startsWith('working plane'))!;
  holds(plane.split('\t').slice(0, 1).join(''));
  for (const figure of plane.split('\t').slice(1, 5)) holds(figure);
  at.forEach((place, i) => holds(`L${i + 1} ${place}`));
  const stops = [0, 1].map((axis) => new Set(at.map((place) => place.split(', ')[axis])).size);
  const measured = await chains(page);
  expect(measured.map((chain) => chain.length)).toEqual(stops.map((count) => count + 1));
  expect(measured.map((chain) => chain.reduce((sum, gap) => sum + gap, 0).toFixed(2))).toEqual([
    '12.00',
    '7.80',
  ]);
  holds('at 1.2 m cylindrical');
  holds('500 lx');
  holds('maintenance factor 0.80');
  holds('Panel 600, batwing');

  const address = await report(page).getByRole('link').getAttribute('href');
  const read = decodeLink(new URL(address!).hash);
  expect(read.ok && read.link.layout?.positions).toHaveLength(at.length);
  const code = report(page).getByRole('link').locator('svg');
  // As near as a phone comes, on the paper's white.
  const near = { position: 'fixed', inset: 0, zIndex: 9, width: '760px', background: '#fff' };
  await code.evaluate((svg, style) => Object.assign((svg as SVGElement).style, style), near);
  const photo = PNG.sync.read(await code.screenshot({ caret: 'initial', scale: 'css' }));
  expect(decodeQR(photo)).toBe(address);
  await page.keyboard.press('Escape');
  await expect(report(page)).toHaveCount(0);
});

/** What stands in the rows of a table of the report, cell by cell. */
const cells = (page: Page, caption: RegExp): Promise<string[][]> =>
  report(page)
    .getByRole('table', { name: caption })
    .locator('tbody tr')
    .evaluateAll((rows) =>
      rows.map((row) => [...row.querySelectorAll('th, td')].map((cell) => cell.textContent)),
    );

const steepest = 15; // degrees from straight down

/** The box, with two spots that are aimed at its tall block among downlights. */
async function openSpots(page: Page): Promise<void> {
  await openApp(page, './?room=box');
  await tab(page, 'Luminaires');
  for (const name of ['Spot 24 degrees', 'Downlight 60 degrees']) {
    await page.getByRole('button', { name: 'Generic luminaires' }).click();
    const dialog = page.getByRole('dialog', { name: 'Generic luminaires' });
    await dialog.getByRole('searchbox').fill(name);
    await dialog.getByRole('button', { name }).click();
  }
  await page.getByRole('button', { name: 'Spot 24 degrees', exact: true }).click();
  for (const least of ['At least', 'At most']) {
    const field = page.getByRole('textbox', { name: `${least} so many Spot 24 degrees` });
    await field.fill('2');
    await field.press('Enter');
  }
  await page.getByRole('combobox', { name: 'Aim at' }).selectOption('tall block');
  await page
    .getByRole('textbox', { name: 'Aiming angle of Spot 24 degrees, at most' })
    .fill(String(steepest));
  const spots = page.getByRole('table', { name: /Luminaires in place/ }).getByText('any: Spot 24 degrees');
  await expect(spots).toHaveCount(2);
  await settled(page);
}

test('the report says of each luminaire which it is and where it is aimed', async ({ page }) => {
  await openSpots(page);
  const [, ...table] = (await saved(page, /luminaires \(CSV\)/)).trim().split('\r\n');
  expect(await saved(page, /STF/)).toMatch(
    /^Description=Rot does not say .*: Lum\d aimed at .*; Lum\d aimed at/m,
  );
  await expect(page.getByText(/STF does not carry where luminaires point; .*: L\d(–|, )L\d\./)).toBeVisible();
  await page.keyboard.press('Control+p');
  await expect(report(page).getByRole('heading', { level: 1 })).toHaveText('Box');
  const types = await cells(page, /^Luminaires/);
  expect(types.map(([name]) => name!.slice(0, 2))).toEqual(['A ', 'B ']);
  expect(types.map((type) => type.at(-1)!).sort()).toEqual([
    expect.stringMatching(/^aimed, mounted at .* m$/),
    expect.stringMatching(/^facing down at .* m$/),
  ]);
  const letters = new Map(types.map(([name]) => [name!.slice(2), name![0]!]));
  const metres = (values: readonly string[]) => values.map((value) => Number(value).toFixed(2)).join(', ');
  const wanted = table.map((line) => {
    const [tag, x, y, z, , , type, turn, ...aim] = line.split(',');
    return [tag, letters.get(type!), metres([x!, y!, z!]), `${turn}°`, aim[0] ? metres(aim) : '–'];
  });
  const hung = await cells(page, /^Places of the luminaires/);
  expect(hung.map((row) => row.slice(0, 5))).toEqual(wanted);
  const tilts = hung.filter((row) => row[4] !== '–').map((row) => Number.parseFloat(row[5]!));
  expect(tilts).toHaveLength(2);
  for (const tilt of tilts) {
    expect(tilt).toBeGreaterThan(1);
    expect(tilt).toBeLessThanOrEqual(steepest);
  }
  const drawn = await report(page)
    .getByRole('img', { name: 'The plan with its luminaires' })
    .locator('.luminaire text')
    .allTextContents();
  expect(drawn).toEqual(wanted.map(([tag, letter]) => `${tag} ${letter}`));
});

test('on a narrow screen the report has its own picture, and every column can be read', async ({ page }) => {
  await openSpots(page);
  await page.setViewportSize({ width: 390, height: 844 });
  const size = () => canvas(page).evaluate((view) => [view.clientWidth, (view as HTMLCanvasElement).width]);
  await expect.poll(size).toEqual([390, 390]);
  await page.keyboard.press('Control+p');
  const view = report(page).getByRole('img', { name: 'The room as it is lit' });
  await expect(view).toBeVisible({ timeout: 90_000 });
  const drawn = await view.evaluate(({ naturalWidth, naturalHeight }: HTMLImageElement) => [
    naturalWidth,
    naturalHeight,
  ]);
  expect(drawn).toEqual([1760, 920]); // whatever the screen is
  expect(await size()).toEqual([390, 390]);
  // From edge to edge of the screen, as it is or scrolled to its end.
  for (const name of [/^Intentions/, /^Luminaires/, /^Places of/, /^Light by surface/]) {
    const last = await report(page)
      .getByRole('group', { name })
      .evaluate((box) => {
        box.scrollLeft = box.scrollWidth;
        return box.querySelector('tbody tr > :last-child')!.getBoundingClientRect().right;
      });
    expect(last).toBeLessThanOrEqual(390);
  }
  const verdict = report(page).getByRole('columnheader', { name: 'Verdict' });
  await verdict.scrollIntoViewIfNeeded();
  await expect(verdict).toBeInViewport({ ratio: 1 });
});

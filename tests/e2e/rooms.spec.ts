// What a person sees first: a lit, solved room; every room and experiment of the gallery.
// Covers viewer, camera-rig, room-mesh, room-light, light-material, luminaire-materials, surface-outline,
// emphasis, picking; stage, view-toolbar, legend, gallery-dialog, surface-table, results-tab, alpha-plot.
import type { Page } from '@playwright/test';
import {
  canvas,
  difference,
  expect,
  expectLit,
  openApp,
  openRoom,
  picture,
  places,
  results,
  settled,
  tagPlaces,
  test,
} from './app.ts';

test('the first screen is a lit, solved room, and so are others of the gallery', async ({ page }) => {
  test.setTimeout(180_000);
  await openApp(page);
  await settled(page);
  await expect(page.getByRole('dialog')).toHaveCount(0);
  await expectLit(page);
  expect(new Set(await places(page)).size).toBeGreaterThan(6);
  let last = await picture(page);
  for (const room of ['E corridor', 'Gallery', 'Box']) {
    await test.step(room, async () => {
      await openRoom(page, room);
      await expectLit(page);
      const now = await picture(page);
      expect(difference(now, last)).toBeGreaterThan(0.2);
      last = now;
      expect((await results(page)).length).toBeGreaterThan(3);
      expect(new Set(await places(page)).size).toBeGreaterThan(3);
    });
  }
});

test('an experiment of the paper states its bounds and meets them', async ({ page }) => {
  await openRoom(page, '5.2 Homogenize');
  const card = page.getByRole('article');
  await expect(card.getByRole('button', { name: 'Homogenize', exact: true })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
  await expect(card.getByRole('img', { name: 'met', exact: true })).toBeVisible();
  await expect(card.getByRole('textbox', { name: /mean at least/ })).not.toHaveValue('');
  await expect(page.getByRole('button', { name: /Exitance/ })).toHaveAttribute('aria-pressed', 'true');
});

test('the smallest alpha is found, step by step, and becomes the one of the card', async ({ page }) => {
  await openRoom(page, '5.4 Find alpha');
  const aim = page.getByRole('textbox', { name: /aim at a mean/ });
  await aim.fill('1');
  await page.getByRole('button', { name: 'Find alpha', exact: true }).click();
  await expect(page.getByText(/Find alpha knows no aims/)).toBeVisible();
  await aim.fill('');
  await aim.press('Enter');
  await settled(page);
  await page.getByRole('button', { name: 'Find alpha', exact: true }).click();
  const plot = page.getByRole('figure').filter({ hasText: 'iteration' });
  await expect(plot.locator('figcaption')).toContainText(/^α = /, { timeout: 60_000 });
  const alpha = /α = ([\d.]+\d)/.exec(await plot.locator('figcaption').innerText())![1];
  expect(await plot.locator('circle').count()).toBeGreaterThan(1);
  await settled(page);
  await expect(page.getByRole('textbox', { name: /alpha/i })).toHaveValue(
    new RegExp(`^${Number(alpha).toFixed(1)}`),
  );
});

test('false colour, views and cut-away change the picture', async ({ page }) => {
  await openRoom(page, 'Box');
  const realistic = await picture(page);
  await page.getByRole('button', { name: 'False colour' }).click();
  await expect.poll(async () => difference(await picture(page), realistic)).toBeGreaterThan(0.2);
  await expect(page.getByRole('region', { name: 'Legend' })).toBeVisible();
  const colored = await picture(page);
  await canvas(page).press('1'); // plan
  await expect.poll(async () => difference(await picture(page), colored)).toBeGreaterThan(0.1);
  const plan = await picture(page);
  await page.getByRole('button', { name: 'Picture settings' }).click();
  await page.getByRole('checkbox', { name: 'Isolux lines' }).check();
  await page.keyboard.press('Escape');
  await expect.poll(async () => difference(await picture(page), plan)).toBeGreaterThan(0.002);
});

test('families of surfaces are one row until they are opened', async ({ page }) => {
  await openRoom(page, 'Open office');
  const rows = await results(page);
  expect(rows.length).toBeLessThan(26);
  const family = page.getByRole('button', { name: 'desk 1–12', exact: true });
  await expect(family).toHaveAttribute('aria-expanded', 'false');
  await expect(page.getByRole('button', { name: 'desk 7', exact: true })).toHaveCount(0);
  await family.click();
  expect((await results(page)).length).toBe(rows.length + 12);
  await page.getByRole('button', { name: 'desk 7', exact: true }).click();
  await family.click();
  // The selected one stays in sight.
  await expect(page.getByRole('button', { name: 'desk 7', exact: true })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
  expect((await results(page)).length).toBe(rows.length + 1);

  const bar = page.getByRole('toolbar', { name: 'Intentions for desk 7' });
  await bar.getByRole('button', { name: 'Illuminate' }).click();
  await page.getByRole('button', { name: 'Surfaces: desk 7' }).click();
  const every = page.getByRole('checkbox', { name: 'desk 1–12' });
  await expect(every).toHaveJSProperty('indeterminate', true);
  await every.check();
  await expect(page.getByRole('button', { name: /^Surfaces: 12 × desk: desk 1, desk 2/ })).toContainText(
    '12 × desk',
  );
  await settled(page);
});

test('a selected measuring plane is a veil over the realistic picture; in false colours furniture lies on it as lines', async ({
  page,
}) => {
  await openRoom(page, 'Open office');
  await page.emulateMedia({ reducedMotion: 'reduce' });
  const before = await picture(page);
  await results(page);
  await page.getByRole('button', { name: 'working plane', exact: true }).click();
  await expect(page.getByRole('toolbar', { name: 'Intentions for working plane' })).toBeVisible();
  await expect.poll(async () => difference(await picture(page), before)).toBeGreaterThan(0.1);
  // By how much the picture has changed: a film over it, not another picture.
  const after = await picture(page);
  let sum = 0;
  for (let i = 0; i < after.data.length; i++) sum += Math.abs(after.data[i]! - before.data[i]!);
  expect(sum / (0.75 * after.data.length)).toBeLessThan(16);

  await page.getByRole('button', { name: 'False colour' }).click();
  const grey = [0x62, 0x67, 0x6f]; // of lines over a plane
  const lines = ({ data }: typeof after) => {
    let count = 0;
    for (let i = 0; i < data.length; i += 4)
      if (grey.every((value, c) => Math.abs(data[i + c]! - value) < 4)) count += 1;
    return count;
  };
  await expect.poll(async () => lines(await picture(page))).toBeGreaterThan(1000);
});

/** Nothing moves on the picture any more. */
async function atRest(page: Page): Promise<void> {
  let last: string[] = [];
  const isStill = async () => {
    const [before, now] = [last, await tagPlaces(page)];
    last = now;
    return before.join() === now.join();
  };
  await expect.poll(isStill, { intervals: [600] }).toBe(true);
}

test('a double click on the floor stands there, and the view is kept under a name', async ({ page }) => {
  await openRoom(page, 'Box');
  await expect.poll(() => tagPlaces(page)).not.toContain(''); // drawn
  const home = await tagPlaces(page);
  const box = (await canvas(page).boundingBox())!;
  await canvas(page).dblclick({ position: { x: 0.5 * box.width, y: 0.86 * box.height } });
  await expect.poll(() => tagPlaces(page)).not.toEqual(home);
  const views = page.getByRole('button', { name: 'Views' });
  await views.click();
  await page.getByRole('textbox', { name: 'Name of this view' }).fill('At the door');
  await page.keyboard.press('Enter');
  const kept = page.getByRole('list', { name: 'Kept views' });
  await expect(kept.getByRole('button')).toHaveCount(2);
  await atRest(page);
  const stood = await tagPlaces(page);
  await page.getByRole('button', { name: 'Home view' }).click();
  await expect.poll(() => tagPlaces(page)).toEqual(home);
  await views.click();
  await kept.getByRole('button', { name: 'At the door', exact: true }).click();
  await expect.poll(() => tagPlaces(page)).toEqual(stood);
});

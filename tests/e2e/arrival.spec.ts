// The first seconds of a first visit: from within, at dusk; and that nobody has to wait for their end.
// Covers arrival, camera-rig, and which files come before the first light (vite.config.js).
import type { Page, Request } from '@playwright/test';
import { canvas, expect, openApp, tagPlaces, test } from './app.ts';

test.use({ storageState: { cookies: [], origins: [] } }); // nobody was here before
test.use({ viewport: { width: 860, height: 500 } });

const shade = (page: Page) => canvas(page).evaluate((view) => view.style.filter);
const isFull = (page: Page) => page.evaluate(() => performance.getEntriesByName('light set').length > 0);

test('a first visit begins in the room at dusk, and the first input ends that at once', async ({ page }) => {
  // Frames a thousandth as far apart until there is an input: the way in would take an hour.
  await page.addInitScript(() => {
    const request = requestAnimationFrame.bind(window);
    let slow = 1000;
    window.addEventListener('keydown', () => (slow = 1));
    window.requestAnimationFrame = (then) => request((now) => then(now / slow));
  });
  await openApp(page);
  expect(await shade(page)).toMatch(/^brightness\(0\.1\d*\)$/);
  expect(await isFull(page)).toBe(false);
  const within = await tagPlaces(page);
  await page.keyboard.press('Shift');
  expect(await shade(page)).toBe('');
  expect(await isFull(page)).toBe(true);
  await expect.poll(() => tagPlaces(page)).not.toEqual(within);
  const whole = await tagPlaces(page);
  expect(whole).not.toContain('behind the eye');
  await page.getByRole('button', { name: 'Home view' }).click();
  await page.waitForTimeout(600); // longer than a flight
  expect(await tagPlaces(page)).toEqual(whole);
});

test('where less motion is wished for, the whole room is there in full light', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto('./');
  await expect.poll(() => isFull(page)).toBe(true);
  expect(await shade(page)).toBe('');
  await expect.poll(async () => (await tagPlaces(page)).length).toBeGreaterThan(0);
  expect(await tagPlaces(page)).not.toContain('behind the eye');
});

test('the first light waits for few files: a browser asks a host for six at a time', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  const asked: Request[] = [];
  page.on('request', (request) => asked.push(request));
  await page.goto('./', { waitUntil: 'commit' });
  await expect.poll(() => isFull(page)).toBe(true);
  // What is fetched in idle moments after the light is no wait for it, however late this test notices the light.
  const lit = await page.evaluate(
    () => performance.timeOrigin + performance.getEntriesByName('light set')[0]!.startTime,
  );
  const before = asked
    .filter((request) => request.timing().startTime <= lit)
    .map((request) => new URL(request.url()).pathname);
  const room = before.findIndex((name) => name.endsWith('.flux'));
  expect(room).toBeGreaterThan(0);
  expect(room).toBeLessThanOrEqual(12);
  expect(before.filter((name) => name.endsWith('.js')).length).toBeLessThanOrEqual(12);
});

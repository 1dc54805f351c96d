// The first seconds of a first visit: from within, at dusk; and that nobody has to wait for their end.
// Covers arrival, camera-rig.
import { canvas, difference, expect, openApp, picture, settled, test } from './app.ts';

test.use({ storageState: { cookies: [], origins: [] } }); // nobody was here before

const shade = (page: Parameters<typeof canvas>[0]) => canvas(page).evaluate((view) => view.style.filter);
const isFull = () => performance.getEntriesByName('light set').length > 0;

test('a first visit begins in the room at dusk, and the first input ends that at once', async ({ page }) => {
  // Frames a thousandth as far apart: the way in would take an hour.
  await page.addInitScript(() => {
    const request = requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (then) => request((now) => then(now / 1000));
  });
  await openApp(page);
  expect(await shade(page)).toMatch(/^brightness\(0\.1\d*\)$/);
  expect(await page.evaluate(isFull)).toBe(false);
  const within = await picture(page);
  await page.keyboard.press('Shift');
  expect(await shade(page)).toBe('');
  expect(await page.evaluate(isFull)).toBe(true);
  const whole = await picture(page);
  expect(difference(within, whole)).toBeGreaterThan(0.5);
  await page.getByRole('button', { name: 'Home view' }).click();
  expect(difference(whole, await picture(page))).toBeLessThan(0.1); // tags come back, buttons are lit
});

test('where less motion is wished for, the whole room is there in full light', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openApp(page);
  await settled(page);
  expect(await shade(page)).toBe('');
  expect(await page.evaluate(isFull)).toBe(true);
});

// The arrangement of the luminaires, chosen by its drawing, and the strip that says what each number would reach.
import { expect, openApp, places, settled, tab, test } from './app.ts';
import type { Page } from '@playwright/test';

/** Whether so many luminaires hang on all crossings of some lines in plan. */
async function isField(page: Page, count: number): Promise<boolean> {
  const all = (await places(page)).map((text) => text.split(',').map(Number));
  const lines = (axis: number) => new Set(all.map((place) => place[axis])).size;
  return all.length === count && lines(0) * lines(1) === count;
}

/** How many different lines in plan the luminaires hang on, whichever way they run. */
async function lines(page: Page): Promise<number> {
  const all = (await places(page)).map((text) => text.split(',').map(Number));
  return Math.min(...[0, 1].map((axis) => new Set(all.map((place) => place[axis])).size));
}

test('rows are as long as is asked for, by a link, too', async ({ page, context }) => {
  await openApp(page, './?room=e-corridor');
  await tab(page, 'Luminaires');
  await page.getByRole('radio', { name: /^Rows/ }).check();
  await expect.poll(() => lines(page)).toBeLessThanOrEqual(2);
  await page.getByLabel('Rows run').selectOption({ label: 'along the room' });
  const least = page.getByRole('textbox', { name: 'In each row at least' });
  await expect(least).toHaveValue('3');
  await least.fill('6');
  await least.press('Enter');
  await expect.poll(() => lines(page)).toBe(1);
  await settled(page);
  const there = await places(page);
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  const link = await page.getByRole('textbox', { name: 'Link' }).inputValue();
  const other = await context.newPage();
  await openApp(other, link);
  expect(await places(other)).toEqual(there);
  await expect(other.getByRole('radio', { name: /^Rows/ })).toBeChecked();
  await expect(other.getByRole('textbox', { name: 'In each row at least' })).toHaveValue('6');
  await expect(other.getByLabel('Rows run').locator('option:checked')).toHaveText('along the room');
});

test('luminaires hang as a field, and the strip tells what other numbers would reach', async ({ page }) => {
  await openApp(page, './?room=e-corridor');
  await tab(page, 'Luminaires');
  await page.getByRole('radio', { name: /^Field/ }).check();
  await expect.poll(() => isField(page, 6)).toBe(true);
  const strip = page.getByRole('group', { name: 'What each number of luminaires would reach' });
  await expect(strip.getByRole('button', { name: /^6 luminaires: / })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
  await strip.getByRole('button', { name: /^4 luminaires: / }).click();
  await expect(page.getByRole('textbox', { name: 'Luminaires', exact: true })).toHaveValue('4');
  await expect.poll(() => isField(page, 4)).toBe(true);
  await page.reload();
  await expect.poll(() => isField(page, 4)).toBe(true);
  await expect(page.getByRole('radio', { name: /^Field/ })).toBeChecked();
});

// The arrangement of the luminaires, chosen by its drawing, and the strip that says what each number would reach.
import { expect, openApp, places, tab, test } from './app.ts';
import type { Page } from '@playwright/test';

/** Whether so many luminaires hang on all crossings of some lines in plan. */
async function isField(page: Page, count: number): Promise<boolean> {
  const all = (await places(page)).map((text) => text.split(',').map(Number));
  const lines = (axis: number) => new Set(all.map((place) => place[axis])).size;
  return all.length === count && lines(0) * lines(1) === count;
}

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

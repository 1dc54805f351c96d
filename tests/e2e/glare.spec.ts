// Glare: shown for each observer, kept under a bound, another one where a luminaire has been moved. Covers glare-choice, glare-table.
import type { Page } from '@playwright/test';
import { expect, openRoom, places, settled, tab, test } from './app.ts';

const table = (page: Page) => page.getByRole('table', { name: /^Glare by observer/ });

/** What the worst observer sees, and every number of the table. */
async function glare(page: Page): Promise<{ worst: number; rows: string[] }> {
  await tab(page, 'Results');
  const rows = await table(page).locator('tbody tr').allInnerTexts();
  const first = await table(page).locator('tbody td').first().innerText();
  return { worst: Number.parseFloat(first.replace(/^\D+/, '')), rows };
}

test('glare is told, bounded, and changes with a luminaire that is moved', async ({ page }) => {
  await openRoom(page, 'Box');
  await tab(page, 'Results');
  await expect(table(page)).toHaveCount(0);

  await tab(page, 'Intentions');
  await page.getByRole('checkbox', { name: 'No glare' }).check();
  await page.getByRole('combobox', { name: 'UGR at most' }).selectOption('25');
  await expect(page.getByText(/^The worst is .+: UGR/)).toBeVisible();
  await settled(page);
  const loose = await glare(page);
  expect(loose.rows.length).toBeGreaterThan(1);
  expect(loose.worst).toBeLessThanOrEqual(25);

  await tab(page, 'Intentions');
  await page.getByRole('combobox', { name: 'UGR at most' }).selectOption('22');
  await expect.poll(async () => (await glare(page)).worst).toBeLessThanOrEqual(22);
  await settled(page);

  const before = await glare(page);
  const [first] = await places(page);
  await page.getByRole('button', { name: 'L1', exact: true }).focus();
  await page.keyboard.press('Enter');
  for (const key of ['ArrowRight', 'ArrowLeft', 'ArrowUp', 'ArrowDown']) {
    await page.keyboard.press(key);
    if ((await places(page))[0] !== first) break;
  }
  await expect.poll(async () => (await glare(page)).rows).not.toEqual(before.rows);
});

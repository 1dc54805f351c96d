// What the browser keeps: the work outlives a reload at any moment, other tabs, and a look at somebody's link.
// Covers keeping, about-room.
import type { Page } from '@playwright/test';
import { expect, openApp, openRoom, places, settled, status, tab, test } from './app.ts';

const flux = (page: Page) => page.getByRole('textbox', { name: /Flux of each/ });

async function setFlux(page: Page, value: string): Promise<void> {
  await tab(page, 'Luminaires');
  await flux(page).fill(value);
}

/** A room that was open before: its very layout is there again. */
async function openRoomAsLeft(page: Page, title: string): Promise<void> {
  await page.getByRole('banner').getByRole('button').first().click();
  await page.getByRole('dialog', { name: 'Rooms' }).getByRole('button', { name: title }).first().click();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText(title);
  await expect(status(page)).toHaveText('As given');
  await tab(page, 'Luminaires');
}

/** Nothing is searched for any more. */
async function atRest(page: Page): Promise<void> {
  // note: what was settled before a reload is as given after it.
  await expect(status(page)).toHaveText(/^(Settled|As given)$/, { timeout: 60_000 });
}

/** The work is in the browser's database, as the page says. */
async function kept(page: Page): Promise<void> {
  await atRest(page);
  await page.waitForTimeout(2500); // longer than the work waits to be kept: the page may speak of an earlier time
  await tab(page, 'Results');
  const about = page.getByText('About this room');
  if (!(await page.getByText(/kept in this browser/).isVisible())) await about.click();
  await expect(page.getByText(/kept in this browser/)).toBeVisible();
}

test('a reload right after an edit loses nothing, and each tab has its own work', async ({
  page,
  context,
}) => {
  await openRoom(page, 'Box');
  await setFlux(page, '2340');
  await page.reload();
  await atRest(page);
  await tab(page, 'Luminaires');
  await expect(flux(page)).toHaveValue('2340');
  await kept(page);

  const other = await context.newPage();
  await openApp(other);
  await setFlux(other, '7770');
  await kept(other);
  await other.close();
  await page.reload();
  await atRest(page);
  await tab(page, 'Luminaires');
  await expect(flux(page)).toHaveValue('2340');
});

test('a link that is only looked at leaves the work alone, and leaves the address with another room', async ({
  page,
  context,
}) => {
  await openRoom(page, 'Box');
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  const link = await page.getByRole('textbox', { name: 'Link' }).inputValue();
  await page.keyboard.press('Escape');
  await setFlux(page, '2340');
  await kept(page);
  await page.close();

  const other = await context.newPage();
  await openApp(other, link);
  await other.waitForTimeout(2500); // longer than the work waits to be kept
  await other.close();

  const damaged = await context.newPage();
  await openApp(damaged, link.slice(0, -3));
  await expect(damaged.getByRole('alert')).toContainText('cannot be read');
  await tab(damaged, 'Luminaires');
  await expect(flux(damaged)).toHaveValue('2340');
  await damaged.close();

  const again = await context.newPage();
  await openApp(again);
  await tab(again, 'Luminaires');
  await expect(flux(again)).toHaveValue('2340');
  await openApp(again, link);
  await openRoom(again, 'E corridor');
  expect(new URL(again.url()).hash).toBe('');
});

test('each room keeps its work; a change of rooms is a step back, and undo outlives a reload', async ({
  page,
}) => {
  await openRoom(page, 'Box');
  await setFlux(page, '2340');
  await settled(page);
  const layout = await places(page);
  await openRoom(page, 'E corridor');
  await setFlux(page, '7770');
  await settled(page);

  await openRoomAsLeft(page, 'Box');
  await expect(flux(page)).toHaveValue('2340');
  expect(await places(page)).toEqual(layout);

  // Undo right after the change returns to the corridor; there the edit itself is undone.
  await page.keyboard.press('Control+z');
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('E corridor');
  await tab(page, 'Luminaires');
  await expect(flux(page)).toHaveValue('7770');
  await page.goBack();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Box');
  await page.goForward();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('E corridor');

  await page.reload();
  await expect(status(page)).toHaveText(/^(Settled|As given)$/, { timeout: 60_000 });
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('E corridor');
  await page.keyboard.press('Control+z');
  await tab(page, 'Luminaires');
  await expect(flux(page)).toHaveValue('3000');
});

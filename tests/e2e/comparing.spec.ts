// Two layouts in one picture: kept, wiped by the keyboard, told apart in a table, switched, and kept over a reload.
// The solver is played against. Covers compare-bar, challenge-card, divider, differences, wipe, film.
import { readFileSync } from 'node:fs';
import { BufferSource, Input, WEBM } from 'mediabunny';
import { difference, expect, openRoom, picture, settled, status, tab, test, violations } from './app.ts';

test('a variant is kept as A, compared with what comes after it, and survives a reload', async ({ page }) => {
  await openRoom(page, 'Box');
  await page.keyboard.press('k');
  const divider = page.getByRole('slider', { name: 'Divider between A and B' });
  await expect(divider).toBeVisible();

  await tab(page, 'Luminaires');
  await page.getByRole('textbox', { name: /Flux of each/ }).fill('400');
  await settled(page);
  await divider.press('End');
  const other = await picture(page);
  await divider.press('Home');
  expect(difference(other, await picture(page))).toBeGreaterThan(0.2);
  await divider.press('Shift+ArrowRight');
  await expect(divider).toHaveAttribute('aria-valuenow', '10');

  await page.getByRole('button', { name: 'Table of differences' }).click();
  const table = page.getByRole('table', { name: /A beside B/ });
  await expect(table.getByRole('row', { name: /^Flux/ })).toContainText('−');
  expect(await violations(page)).toEqual([]);

  await page.getByRole('button', { name: 'Switch A and B' }).click();
  await expect(status(page)).toHaveText('As given');
  await expect(table.getByRole('row', { name: /^Flux/ })).toContainText('+');
  await page.reload();
  await expect(status(page)).toHaveText('As given', { timeout: 60_000 });
  await expect(divider).toHaveCount(0);
  await page.keyboard.press('b');
  await expect(divider).toBeVisible();
});

test('six luminaires are placed by hand against the solver, and the link tells the score', async ({
  page,
  context,
}) => {
  await openRoom(page, 'Box');
  await page.getByRole('button', { name: 'Compare', exact: true }).click();
  await page.getByRole('menuitem', { name: /Beat the solver/ }).click();
  const card = page.getByRole('region', { name: 'Beat the solver' });
  const score = card.locator('.score');
  await expect(score).toContainText(/^\d+your score; the solver’s is 100/, { timeout: 60_000 });
  const scattered = await score.innerText();

  // What is to be placed is not behind it, in a small window either.
  const spots = () =>
    page.locator('[data-luminaire]').evaluateAll((tags) =>
      tags.map((tag) => {
        const { top, bottom } = tag.getBoundingClientRect();
        return { top, bottom };
      }),
    );
  for (const viewport of [
    { width: 900, height: 640 },
    { width: 1280, height: 800 },
  ]) {
    await page.setViewportSize(viewport);
    await expect
      .poll(async () => {
        const { y, height } = (await card.boundingBox())!;
        return (await spots()).every(({ top, bottom }) => top > y + height || bottom < y);
      })
      .toBe(true);
  }

  // One is taken elsewhere by the keyboard: it counts at once.
  await tab(page, 'Luminaires');
  await page.getByRole('button', { name: 'L1', exact: true }).focus();
  await page.keyboard.press('Enter');
  for (const key of ['ArrowRight', 'ArrowRight', 'ArrowUp']) await page.keyboard.press(key);
  await expect(score).not.toHaveText(scattered);
  await expect(card).toContainText(/solver/);

  await card.getByRole('button', { name: 'See the solver’s' }).click();
  await expect(page.getByRole('slider', { name: /Divider/ })).toBeVisible();
  const points = /^\d+/.exec(await score.innerText())![0];
  await card.getByRole('button', { name: 'Share' }).click();
  const dialog = page.getByRole('dialog', { name: 'Share this layout' });
  const link = await dialog.getByRole('textbox', { name: 'Link' }).inputValue();
  const other = await context.newPage();
  await other.goto(link);
  const message = other.getByRole('region', { name: 'Messages' }).getByText(/the sender says/);
  await expect(message).toContainText(`${points} points`, { timeout: 60_000 });
});

test('a loop is recorded as a WebM file, and Escape ends it without one', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 700 }); // what is small is drawn soon by software, too
  await openRoom(page, 'Box');
  const record = async () => {
    await page.getByRole('button', { name: 'Compare', exact: true }).click();
    await page.getByRole('menuitem', { name: /five-second loop/ }).click();
    await expect(page.getByRole('region', { name: 'Five-second loop' })).toBeVisible();
  };
  await record();
  await page.keyboard.press('Escape');
  await expect(page.getByRole('region', { name: 'Five-second loop' })).toHaveCount(0);
  const download = page.waitForEvent('download', { timeout: 80_000 });
  await record();
  const file = await download;
  expect(file.suggestedFilename()).toBe('box-loop.webm');
  const film = new Input({ source: new BufferSource(readFileSync(await file.path())), formats: [WEBM] });
  const track = await film.getPrimaryVideoTrack();
  expect((await track?.computePacketStats())?.packetCount).toBe(125);
  expect(await film.computeDuration()).toBeCloseTo(5, 2);
});

// A room from nothing: typed, furnished, seen, saved, opened again and changed; by pointer and by keys; accessible.
// Covers making, making-panel, and web/panel/room-maker.
import { readFileSync } from 'node:fs';
import type { Locator, Page } from '@playwright/test';
import { difference, expect, look, picture, test, violations } from './app.ts';

test.setTimeout(180_000); // every step draws the room anew
test.use({ viewport: { width: 1000, height: 640 } });

const maker = (page: Page) => page.getByRole('complementary', { name: 'Room maker' });

async function newRoom(page: Page): Promise<void> {
  await page.goto('./');
  await page.getByRole('button', { name: 'File and export' }).click();
  await page.getByRole('menuitem', { name: 'New room' }).click();
  await expect(page.getByRole('heading', { name: 'New room' })).toBeVisible();
}

/** What is drawn in the plan is chosen by keys: the picture beside it may still be on its way. */
async function select(shape: Locator): Promise<void> {
  await shape.focus();
  await shape.press('Enter');
}

async function drawn(page: Page) {
  await expect.poll(async () => look(await picture(page)).colors, { timeout: 60_000 }).toBeGreaterThan(8);
  return picture(page);
}

test('a room is typed, furnished, seen, saved and opened again', async ({ page }) => {
  await newRoom(page);
  const plan = page.getByRole('group', { name: 'Plan of the room' });
  const size = page.getByLabel('Width × depth × height');
  await test.step('a size that is none is told, and the room of another size is not lit', async () => {
    await size.fill('12,5 x abc');
    await maker(page).getByRole('button', { name: 'Light it' }).click();
    await expect(maker(page).getByRole('alert')).toContainText('“12,5 x abc” is not a size');
    await expect(size).toBeFocused();
  });
  await size.fill('7 x 4 x 2.8');
  await expect(maker(page).getByRole('alert')).toHaveCount(0);
  await expect(plan.getByRole('button', { name: 'wall north, 7 m' })).toBeVisible();
  const empty = await drawn(page);

  await test.step('doors, windows, furniture in rows', async () => {
    await select(plan.getByRole('button', { name: 'wall north, 7 m' }));
    await maker(page).getByRole('button', { name: 'Window', exact: true }).click();
    await select(plan.getByRole('button', { name: 'wall south, 7 m' }));
    await maker(page).getByRole('button', { name: 'Door', exact: true }).click();
    await expect(plan.getByRole('button', { name: /^(window|door) in wall/ })).toHaveCount(2);
    await maker(page).getByRole('button', { name: 'Add a desk' }).click();
    await maker(page).getByText('Repeat in rows').click();
    await maker(page).getByRole('textbox', { name: 'Across' }).fill('2');
    await maker(page).getByRole('textbox', { name: 'Rows' }).fill('1');
    await maker(page).getByRole('button', { name: 'Place 2' }).click();
    await expect(plan.getByRole('button', { name: /^desk at/ })).toHaveCount(2);
    await expect.poll(async () => difference(await picture(page), empty)).toBeGreaterThan(0.01);
  });

  await test.step('keys move what has the focus, and undo takes it back in one step', async () => {
    const corner = plan.getByRole('button', { name: 'Corner 3, 7 m by 4 m' });
    await corner.focus();
    for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowRight');
    await expect(plan.getByRole('button', { name: 'Corner 3, 7.3 m by 4 m' })).toBeFocused();
    await page.keyboard.press('Control+z');
    await expect(plan.getByRole('button', { name: 'Corner 3, 7 m by 4 m' })).toBeVisible();
  });

  await test.step('a corner is dragged', async () => {
    const from = await plan.getByRole('button', { name: 'Corner 2, 7 m by 0 m' }).boundingBox();
    await page.mouse.move(from!.x + from!.width / 2, from!.y + from!.height / 2);
    await page.mouse.down();
    await page.mouse.move(from!.x - 30, from!.y + 4, { steps: 4 });
    await page.mouse.up();
    await expect(plan.getByRole('button', { name: 'Corner 2, 7 m by 0 m' })).toHaveCount(0);
    await maker(page).getByRole('button', { name: 'Undo in the plan' }).click();
  });

  await test.step('what does not fit is said', async () => {
    await select(plan.getByRole('button', { name: /^window in wall north/ }));
    await maker(page).getByRole('textbox', { name: 'Width, m' }).fill('9');
    await expect(maker(page).getByText('Window 1 does not fit in wall north')).toBeVisible();
    await maker(page).getByRole('textbox', { name: 'Width, m' }).fill('1.6');
    await expect(maker(page).getByText('Window 1 does not fit')).toHaveCount(0);
  });

  const saved = page.waitForEvent('download');
  await maker(page).getByRole('button', { name: 'Save as .glb' }).click();
  const download = await saved;
  expect(download.suggestedFilename()).toBe('7 x 4 x 2.8 m.glb');
  const bytes = readFileSync(await download.path());
  expect(bytes.subarray(0, 4).toString()).toBe('glTF');

  await page.reload();
  await expect(page.getByRole('tab', { name: 'Intentions' })).toBeVisible();
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'File and export' }).click();
  await page.getByRole('menuitem', { name: /^Open a/ }).click();
  await (await chooser).setFiles({ name: 'again.glb', mimeType: 'model/gltf-binary', buffer: bytes });
  await page.getByRole('button', { name: 'Edit the room' }).click();
  await expect(page.getByRole('heading', { name: 'Edit the room' })).toBeVisible();
  await expect(plan.getByRole('button', { name: /^desk at/ })).toHaveCount(2);
  await expect(plan.getByRole('button', { name: 'wall north, 7 m' })).toBeVisible();
  await maker(page).getByRole('button', { name: 'Close the room maker' }).click();
  await expect(maker(page)).toHaveCount(0);
});

test('a measuring plane is drawn in the plan by one drag, and undone in one step', async ({ page }) => {
  await newRoom(page);
  const plan = page.getByRole('group', { name: 'Plan of the room' });
  const draw = maker(page).getByRole('button', { name: 'Draw in the plan' });
  await draw.click();
  await page.keyboard.press('Escape');
  await expect(draw).toHaveAttribute('aria-pressed', 'false');
  await draw.click();
  const { x, y, width, height } = (await plan.boundingBox())!;
  const [left, top] = [x + width / 2 - 60, y + height / 2 - 40];
  await page.mouse.move(left, top);
  await page.mouse.down();
  await page.mouse.move(left + 110, top + 70, { steps: 3 });
  await page.mouse.up();
  await expect(draw).toHaveAttribute('aria-pressed', 'false');
  await expect(plan.getByRole('button', { name: /^task area 1/i })).toHaveAttribute('aria-pressed', 'true');
  const side = (name: string) => maker(page).getByRole('textbox', { name }).first().inputValue();
  const ratio = Number(await side('Width')) / Number(await side('Depth'));
  expect(Math.abs(ratio - 110 / 70)).toBeLessThan(0.25); // both to the decimetre
  await page.keyboard.press('Control+z');
  await expect(plan.getByRole('button', { name: /^task area/i })).toHaveCount(0);
});

test('axe finds nothing serious in the room maker: wide and narrow, light and dark', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await newRoom(page);
  await maker(page).getByRole('button', { name: 'Add a column', exact: true }).click();
  const wall = page
    .getByRole('group', { name: 'Plan of the room' })
    .getByRole('button', { name: /^wall east/ });
  for (const colorScheme of ['light', 'dark'] as const)
    for (const width of [1280, 390]) {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 844 });
      await select(wall);
      expect(await violations(page), `${colorScheme}, ${width} px`).toEqual([]);
    }
});

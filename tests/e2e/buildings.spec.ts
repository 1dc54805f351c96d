// A building of several storeys: cut by them, stood in, and lit in one of them. Covers storeys, mounts-section
// and place-section.
import { makeBuilding } from '../rooms/made-building.mjs';
import { difference, drop, expect, picture, test, violations } from './app.ts';

test.setTimeout(180_000);
test.use({ viewport: { width: 900, height: 600 } });

test('a building is cut by its storeys, stood in room by room, and lit in one of them', async ({ page }) => {
  await page.goto('./?room=box');
  await expect(page.getByRole('tab', { name: 'Intentions' })).toBeVisible();
  await drop(page, { 'building.glb': Buffer.from(await makeBuilding().bytes()) });
  const understood = page.getByRole('button', { name: 'How it was understood' });
  await expect(understood).toBeVisible({ timeout: 60_000 });

  const views = page.getByRole('button', { name: 'Views', exact: true });
  await views.click();
  const storeys = page.getByRole('region', { name: 'Storeys and rooms' });
  const section = storeys.getByRole('slider', { name: 'Section' });
  await expect(section).toHaveAttribute('aria-valuetext', 'not cut');
  await expect(page.getByRole('button', { name: 'Keep this view' })).toHaveCount(0); // of the lit room before
  const whole = await picture(page);
  await storeys.getByRole('button', { name: 'Storey 1' }).click();
  await expect(section).toHaveAttribute('aria-valuetext', 'cut at 1.5 m');
  await section.press('ArrowRight');
  await expect(section).toHaveAttribute('aria-valuetext', 'cut at 1.6 m');
  await expect
    .poll(async () => difference(await picture(page), whole), { timeout: 60_000 })
    .toBeGreaterThan(0.05);
  const upper = storeys.getByRole('group', { name: 'Stand in: Storey 2' });
  await expect(upper.getByRole('button')).toHaveCount(3);
  expect(await violations(page)).toEqual([]);
  await upper.getByRole('button', { name: 'Room 1' }).click();
  await expect(section).toHaveAttribute('aria-valuetext', 'not cut');
  await views.click();

  await understood.click();
  const lower = page
    .getByRole('group', { name: 'In one storey alone' })
    .getByRole('button', { name: 'Storey 1' });
  await lower.click();
  await expect(lower).toHaveAttribute('aria-pressed', 'true');
  await expect(page.getByRole('checkbox', { name: 'slab/underside' })).toBeChecked();
  await expect(page.getByRole('checkbox', { name: 'roof/underside' })).not.toBeChecked();

  // The room that is clicked alone: it is smaller than the building, and may be closed.
  const size = page.locator('.sheet-size');
  await expect(size).toContainText('12.60 × 9.60 m');
  const choose = page.getByRole('button', { name: 'Choose one room' });
  const usual = page.viewportSize()!;
  await page.setViewportSize({ width: 390, height: 844 }); // a phone shows the picture, and what is to be done with it
  await choose.click();
  await expect(page.getByRole('region', { name: 'Light is being computed' })).toBeHidden();
  await expect(page.getByText('Click inside a room in the picture.')).toBeInViewport();
  expect((await page.locator('canvas').first().boundingBox())!.height).toBeGreaterThan(400);
  await page.getByRole('button', { name: 'Not now' }).click();
  await page.setViewportSize(usual);
  const tags = page.locator('.viewer-labels').first();
  await choose.click();
  await expect(tags).toHaveClass(/are-hidden/); // nothing hangs between the click and the room
  await page
    .locator('canvas')
    .first()
    .click({ position: { x: 260, y: 300 } });
  await expect(page.getByText('Only the room that was clicked is lit.')).toBeVisible();
  await expect(tags).not.toHaveClass(/are-hidden/);
  await expect(size).not.toContainText('12.60', { timeout: 60_000 });
  await page
    .getByRole('group', { name: 'Close its doors and windows' })
    .getByRole('button', { name: 'Dark' })
    .click();
  await expect(page.getByRole('checkbox', { name: 'roof/underside' })).toHaveCount(0);
  expect(await violations(page)).toEqual([]);
});

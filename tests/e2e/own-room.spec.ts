// A dropped model is lit in the page: shown, computed as a draft, solved, computed in full, kept among the own rooms.
// Covers lighting, preview-note, own-rooms.
import type { Page } from '@playwright/test';
import { glbOf } from '../../web/room-maker/make-room.mjs';
import { planOf, usualItem } from '../../web/room-maker/room-plan.mjs';
import { drop, expect, expectLit, openRoom, places, settled, status, test } from './app.ts';

const patience = { timeout: 400_000 }; // for light to be computed; nothing measures time

const spot =
  'IESNA:LM-63-2002\r\nTILT=NONE\r\n1 1000 1 3 1 1 2 0.1 0.1 0\r\n1 1 10\r\n0 40 90\r\n0\r\n900 300 0\r\n';

/** A room that is soon computed: 2 m each way, a cupboard before ochre walls, and few places in the ceiling. */
async function smallRoom(): Promise<Buffer> {
  const plan = planOf([[0, 0], [2, 0], [2, 2], [0, 2]], 2.2); // prettier-ignore
  const glb = await glbOf({
    ...plan,
    finishes: { ...plan.finishes, walls: { reflectance: 0.5, colour: '#c99a66' } },
    items: [usualItem('cupboard', [1, 0.4], plan.height)],
    mount: { ...plan.mount, spacing: 0.4, luminaire: 0.3 },
    plane: null,
  });
  return Buffer.from(glb);
}

const working = (page: Page) => page.getByRole('region', { name: 'Light is being computed' });

test('a dropped model is lit, solved and kept', async ({ page }) => {
  test.setTimeout(900_000); // two passes of light, beside a picture that software may draw
  await openRoom(page, 'E corridor');
  await drop(page, { 'my box.glb': await smallRoom() });
  await expect(working(page).getByRole('heading')).toHaveText('“my box”: lighting');
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('my box', patience);
  await expect(working(page).getByRole('heading')).toHaveText('“my box”: preview');
  await settled(page);
  await expectLit(page);
  const draft = await places(page);

  await expect(working(page)).toHaveCount(0, patience);
  await expect(status(page)).toHaveText(/^(Settled|As given)$/);
  expect((await places(page)).length).toBe(draft.length);

  await drop(page, { 'spot.ies': spot });
  const card = page.getByRole('article', { name: 'spot' });
  await expect(card).toContainText(/\d used/, { timeout: 60_000 });
  await expectLit(page);

  await page.getByRole('banner').getByRole('button').first().click();
  const gallery = page.getByRole('dialog', { name: 'Rooms' });
  await expect(gallery.getByRole('heading', { name: 'Your rooms' })).toBeVisible();
  await expect(gallery.getByText(/MB of .* are taken/)).toBeVisible();
  await gallery.getByRole('button', { name: 'Rename my box' }).click();
  await gallery.getByLabel('Name of the room').fill('Atelier');
  await gallery.getByRole('button', { name: 'Rename', exact: true }).click();
  await expect(page.locator('h1')).toHaveText('Atelier'); // the room is on the screen
  await gallery.getByRole('button', { name: /^Atelier/ }).click();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Atelier');
  await expectLit(page);

  await page.getByRole('banner').getByRole('button').first().click();
  await gallery.getByRole('button', { name: 'Delete Atelier' }).click();
  await expect(gallery.getByRole('heading', { name: 'Your rooms' })).toHaveCount(0);
});

test('where the browser stores no more, the room stays on the screen, and that is said', async ({ page }) => {
  test.setTimeout(900_000);
  await page.addInitScript(() => {
    const { put } = IDBObjectStore.prototype;
    IDBObjectStore.prototype.put = function (...asked) {
      if (this.name === 'files') throw new DOMException('the disk is full', 'QuotaExceededError');
      return put.apply(this, asked);
    };
  });
  await openRoom(page, 'Box');
  await drop(page, { 'my box.glb': await smallRoom() });
  const warning = page.getByRole('region', { name: 'Messages' });
  await expect(warning.getByText(/“my box” is not kept in this browser: its storage is full/)).toBeVisible(
    patience,
  );
  await expect(working(page)).toHaveCount(0, patience);
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('my box');
  await expectLit(page);
  await page.getByRole('banner').getByRole('button').first().click();
  const gallery = page.getByRole('dialog', { name: 'Rooms' });
  await expect(gallery.getByRole('heading', { name: 'Rooms', exact: true })).toBeVisible();
  await expect(gallery.getByRole('heading', { name: 'Your rooms' })).toHaveCount(0);
});

test('a model that cannot be lit says why, and the room before it comes back', async ({ page }) => {
  await openRoom(page, 'Box');
  const empty = { asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [] }] };
  await drop(page, { 'nothing.gltf': JSON.stringify(empty) });
  const refusal = page.getByRole('region', { name: 'Messages' }).getByRole('alert');
  await expect(refusal.getByText(/no geometry|no surfaces|no triangles/)).toBeVisible({ timeout: 60_000 });
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Box');
});

// Files by button and by drop: scenes open, damaged files leave what is there.
// Covers opening-files, drop-zone, menu, legend-picture.
import { readFileSync } from 'node:fs';
import path from 'node:path';
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { mapColor } from '../../web/viewer/light/color-maps.ts';
import {
  difference,
  drop,
  expect,
  expectLit,
  openRoom,
  picture,
  pictureAtRest,
  places,
  settled,
  test,
} from './app.ts';

const scenes = path.join(import.meta.dirname, '../../public/scenes');
const messages = (page: Page) => page.getByRole('region', { name: 'Messages' });

async function chooseFile(page: Page, name: string, buffer: Buffer): Promise<void> {
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'File and export' }).click();
  await page.getByRole('menuitem', { name: /^Open a/ }).click();
  await (await chooser).setFiles({ name, mimeType: 'application/octet-stream', buffer });
}

test('files by button and by drop, good and damaged', async ({ page }) => {
  const box = readFileSync(path.join(scenes, 'box.flux'));
  await openRoom(page, 'E corridor');
  const corridor = await places(page);
  const lit = await pictureAtRest(page);

  const flipped = Buffer.from(box);
  flipped[flipped.length >> 1]! ^= 0x10;
  const future = Buffer.from(box);
  future.writeUInt32LE(99, 8);
  const damaged: [string, Buffer, RegExp][] = [
    ['cut.flux', box.subarray(0, box.length >> 1), /./],
    ['flipped.flux', flipped, /damaged/i],
    ['future.flux', future, /version/i],
    ['empty.flux', Buffer.alloc(0), /./],
    ['text.glb', Buffer.from('this is no picture'), /./],
    ['notes.txt', Buffer.from('hello'), /“notes.txt” is not a file of Fiat Lux/],
    ['broken.json', Buffer.from('{"format": 1'), /“broken.json”/],
  ];
  for (const [name, bytes, message] of damaged) {
    await test.step(name, async () => {
      await drop(page, { [name]: bytes });
      const alert = messages(page).getByRole('alert').filter({ hasText: message });
      await expect(alert).toHaveCount(1);
      await expect(alert).toContainText(/\w+ \w+/);
      await alert.getByRole('button', { name: 'Dismiss this message' }).click();
      await expect(alert).toHaveCount(0);
    });
  }
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('E corridor');
  expect(await places(page)).toEqual(corridor);
  await page.mouse.move(2, 2);
  await expect.poll(async () => difference(await picture(page), lit)).toBeLessThan(0.01);

  await drop(page, { 'my room.flux': box });
  await expect(messages(page).getByText(/stays on this computer/)).toBeVisible();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('my room');
  await settled(page);
  await expectLit(page);

  await chooseFile(page, 'second.flux', box);
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('second');
  await settled(page);

  // Both are kept like rooms that were computed here.
  await expect(messages(page).getByText('one of your rooms')).toBeVisible();
  await page.reload();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('second', { timeout: 60_000 });
  await page.getByRole('banner').getByRole('button').first().click();
  const own = page.getByRole('dialog', { name: 'Rooms' }).getByRole('button', { name: /as .flux$/ });
  await expect(own).toHaveCount(2);
});

test('a picture in false colours carries its legend, a realistic one does not', async ({ page }) => {
  await openRoom(page, 'Box');
  const save = async () => {
    const download = page.waitForEvent('download');
    await page.getByRole('button', { name: 'File and export' }).click();
    await page.getByRole('menuitem', { name: /PNG/ }).click();
    return PNG.sync.read(readFileSync(await (await download).path()));
  };
  /** The colour of a pixel counted from the lower left corner. */
  const at = ({ data, width, height }: PNG, x: number, y: number) => [
    ...data.subarray(4 * ((height - y) * width + x)).subarray(0, 3),
  ];
  const apart = (a: readonly number[], b: readonly number[]) =>
    Math.max(...a.map((value, channel) => Math.abs(value - b[channel]!)));
  const realistic = await save();
  await page.keyboard.press('c');
  await expect(page.getByRole('region', { name: 'Legend' })).toBeVisible();
  const colored = await save();
  expect([colored.width, colored.height]).toEqual([realistic.width, realistic.height]);
  for (const place of [0.05, 0.95]) {
    const color = mapColor('viridis', place);
    const x = Math.round(24 + place * 236);
    expect(apart(at(colored, x, 44), color)).toBeLessThan(12);
    expect(apart(at(realistic, x, 44), color)).toBeGreaterThan(40);
  }
});

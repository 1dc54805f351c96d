// Photometric files: dropped, opened, chosen from the generic ones; what cannot be read says why in one sentence.
// Covers luminaire-types, photometric-container, tm33, type-card, luminaire-dialog.
import { readFileSync } from 'node:fs';
import path from 'node:path';
import type { Page } from '@playwright/test';
import { zipSync } from 'fflate';
import {
  difference,
  drop,
  expect,
  openApp,
  openRoom,
  picture,
  status,
  tab,
  test,
  violations,
} from './app.ts';

const luminaires = path.join(import.meta.dirname, '../../public/luminaires');
const generic = (name: string) => readFileSync(path.join(luminaires, name));
const box = './?room=box';
const messages = (page: Page) => page.getByRole('region', { name: 'Messages' });
const card = (page: Page, name: string) => page.getByRole('article', { name });

const xml = (data: string) => `<?xml version="1.0"?><IESTM33-22><Version>1.1</Version>
  <Header><Manufacturer>Maker &amp; Sons</Manufacturer><Description>Cube lamp</Description></Header>
  <Luminaire><Dimensions><Length>300</Length><Width>100</Width><Height>50</Height></Dimensions></Luminaire>
  <Emitter><Quantity>1</Quantity><InputWattage>20</InputWattage><LuminousIntensity><Multiplier>2</Multiplier>
  ${data}</LuminousIntensity></Emitter></IESTM33-22>`;
const even = Array.from({ length: 37 }, (_, i) => `<IntData h="0" v="${5 * i}">50</IntData>`).join('');

test('files that are dropped become cards, several at once', async ({ page }) => {
  await openApp(page, box);
  await drop(page, { 'panel.ldt': generic('panel.ldt'), 'wall-washer.ies': generic('wall-washer.ies') });
  const panel = card(page, 'Panel 600, batwing');
  await expect(panel).toContainText('3\u202f600 lm');
  await expect(panel).toContainText('129 lm/W');
  await expect(panel.getByRole('img', { name: /Polar curve: beam 89 degrees/ })).toBeVisible();
  await expect(
    card(page, 'Wall washer').getByRole('checkbox', { name: 'The search may use it' }),
  ).toBeChecked();

  await page.keyboard.press('Control+z');
  await expect(card(page, 'Wall washer')).toHaveCount(0);
  await drop(page, { 'cube.xml': Buffer.from(xml(even)) });
  const cube = card(page, 'Cube lamp');
  await expect(cube).toContainText('Maker & Sons');
  await expect(cube).toContainText('1\u202f257 lm'); // 4 pi x 100 cd
  await expect(cube).toContainText('20.0 W');

  await drop(page, { 'spot-12.ies': generic('spot-12.ies') });
  await expect(card(page, 'Spot 12 degrees')).toContainText('< 10'); // it sends nothing to any eye
});

test('a luminaire that is dropped lights the room: picture, layout and link change', async ({ page }) => {
  await openRoom(page, 'Box');
  const before = await picture(page);
  await drop(page, { 'spot-24.ldt': generic('spot-24.ldt') });
  const spot = card(page, 'Spot 24 degrees');
  await expect(spot).toContainText(/\d used/, { timeout: 60_000 });
  await expect.poll(async () => difference(before, await picture(page))).toBeGreaterThan(0.1);
  await expect(
    page
      .getByRole('table', { name: /Luminaires in place/ })
      .locator('tbody tr')
      .first(),
  ).toContainText('1\u202f200');
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  const link = await page.getByRole('textbox', { name: 'Link' }).inputValue();
  expect(link).toMatch(/#f2\./);
  expect(link.length).toBeLessThan(1800);

  // The receiver sees the same luminaires, whose file the link brings along.
  await page.goto('about:blank');
  await page.goto(link);
  await expect(status(page)).toHaveText('As given', { timeout: 60_000 });
  await tab(page, 'Luminaires');
  await expect(spot).toContainText(/\d used/, { timeout: 60_000 });
});

test('a file that disagrees with itself is asked about with both numbers', async ({ page }) => {
  await openApp(page, box);
  const lying = generic('wall-washer.ies').toString('latin1').replace('1 2200 ', '1 340 ');
  await drop(page, { 'lying.ies': Buffer.from(lying, 'latin1') });
  const question = page.getByRole('group', { name: /Which flux/ });
  await expect(question).toContainText('The file says 340 lm, its table holds 2\u202f200: which?');
  await question.getByRole('button', { name: '340 lm' }).click();
  await expect(question).toHaveCount(0);
  await expect(card(page, 'Wall washer')).toContainText('340 lm');
});

test('generic luminaires are found and chosen; the page stays accessible', async ({ page }) => {
  await openApp(page, box);
  await tab(page, 'Luminaires');
  await page.getByRole('button', { name: 'Generic luminaires' }).click();
  const dialog = page.getByRole('dialog', { name: 'Generic luminaires' });
  await expect(dialog.getByRole('listitem')).toHaveCount(12);
  await dialog.getByRole('searchbox').fill('spot 24');
  await dialog.getByRole('button', { name: /Spot 24 degrees/ }).click();
  const spot = card(page, 'Spot 24 degrees');
  await expect(spot).toContainText('24°');
  await expect(page.getByText('plain squares of light')).toHaveCount(0);
  await spot.getByRole('button').first().click();
  await spot.getByRole('checkbox', { name: 'The search may use it' }).uncheck();
  await expect(page.getByText('plain squares of light')).toBeVisible(); // what lights the room instead
  expect(await violations(page)).toEqual([]);
});

test('a container of several files lets a person choose', async ({ page }) => {
  await openApp(page, box);
  const gldf = zipSync({
    'product.xml': Buffer.from('<Root/>'),
    'ldc/panel.ldt': generic('panel.ldt'),
    'ldc/batten.ldt': generic('batten.ldt'),
  });
  await drop(page, { 'lamp.gldf': Buffer.from(gldf) });
  const dialog = page.getByRole('dialog', { name: 'Luminaires in lamp.gldf' });
  await dialog.getByRole('button', { name: /batten\.ldt/ }).click();
  await expect(card(page, 'Batten 1200, opal')).toBeVisible();
});

const ies = generic('spot-12.ies').toString('latin1');
const table = (counts: string, rest: string) =>
  Buffer.from(
    `IESNA:LM-63-2002\r\n[LUMINAIRE] x\r\nTILT=NONE\r\n1 1000 1 ${counts} 1 2 0.1 0.1 0\r\n1 1 10\r\n${rest}`,
  );
const bad: readonly (readonly [string, Buffer, RegExp])[] = [
  ['short.ies', Buffer.from(ies.slice(0, 400), 'latin1'), /ends/],
  ['more.ies', table('3 1', '0 45\r\n0\r\n100 50\r\n'), /\w/],
  ['down.ies', table('3 1', '90 45 0\r\n0\r\n1 2 3\r\n'), /ascend|descend|order/i],
  ['nan.ies', table('3 1', '0 45 90\r\n0\r\nnan 2 3\r\n'), /nan|number/i],
  ['bright.ies', table('3 1', '0 45 90\r\n0\r\n1e9 2 3\r\n'), /cd|candela/i],
  ['none.ies', Buffer.from(ies.replace('\n1 900', '\n0 900'), 'latin1'), /lamp/i],
  ['tilt.ies', Buffer.from(ies.replace('TILT=NONE', 'TILT=lamp.tlt'), 'latin1'), /tilt/i],
  ['wide.ies', table('500 1000', '0'), /500|361/],
  [
    'lines.ldt',
    Buffer.from(generic('panel.ldt').toString().split('\r\n').slice(0, 30).join('\r\n')),
    /line|ends/i,
  ],
  ['seven.ldt', Buffer.from(generic('panel.ldt').toString().replace('\r\n4\r\n', '\r\n7\r\n')), /7|symmetr/i],
  ['empty.gldf', Buffer.from(zipSync({ 'product.xml': Buffer.from('<Root/>') })), /has no \.ldt or \.ies/],
  ['bomb.gldf', Buffer.from(zipSync({ 'a.ldt': new Uint8Array(5 << 20) })), /more than 4 MB/],
  ['closed.uld', Buffer.from('ULD\0\0\x01'), /export/],
  ['picture.ies', Buffer.from('\x89PNG\r\n\x1a\n\0\0', 'latin1'), /PNG picture/],
  ['broken.xml', Buffer.from('<IESTM33-22><Emitter>'), /damaged/],
  ['other.xml', Buffer.from('<html/>'), /neither TM-33/],
  ['dark.xml', Buffer.from(xml('')), /no luminous intensities/],
];

test('what cannot be read says why in one sentence, and nothing is lost', async ({ page, watched }) => {
  await openApp(page, box);
  await drop(page, { 'panel.ldt': generic('panel.ldt') });
  await expect(card(page, 'Panel 600, batwing')).toBeVisible();
  for (const [name, bytes, message] of bad) {
    await test.step(name, async () => {
      await drop(page, { [name]: bytes });
      const alert = messages(page)
        .getByRole('alert')
        .filter({ hasText: `“${name}”` });
      await expect(alert).toContainText(message);
      expect((await alert.innerText()).trim().split('\n')).toHaveLength(1);
    });
  }
  await expect(page.getByRole('article')).toHaveCount(1);
  // The browser's own picture of damaged XML has a style, which the policy of the page forbids it.
  expect(watched.faults.filter((fault) => !/style-src/.test(fault))).toEqual([]);
  watched.faults.length = 0;
});

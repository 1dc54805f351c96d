// Links: the same layout and numbers in another page; damaged ones give one readable line and a clean start.
// Covers share-dialog, opening.
import { deflateRawSync, inflateRawSync } from 'node:zlib';
import type { Page } from '@playwright/test';
import { crc32, fromBase64Url, toBase64Url } from '../../web/document/base64url.ts';
import { expect, expectLit, openApp, openRoom, places, results, settled, status, tab, test } from './app.ts';

const shared = (page: Page) => page.getByRole('dialog', { name: 'Share this layout' });

async function linkOf(page: Page): Promise<string> {
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  const link = await shared(page).getByRole('textbox', { name: 'Link' }).inputValue();
  await page.keyboard.press('Escape');
  await expect(shared(page)).toHaveCount(0);
  return link;
}

test('a link holds the view that is on the screen, even while a turn runs out', async ({ page }) => {
  await openRoom(page, 'Box');
  const still = await linkOf(page);
  const box = (await page.getByRole('application').boundingBox())!;
  await page.mouse.move(box.x + 300, box.y + 300);
  await page.mouse.down();
  await page.mouse.move(box.x + 420, box.y + 320, { steps: 4 });
  await page.mouse.up();
  const turned = await linkOf(page);
  const camera = (link: string) => {
    const payload = /#f\d+\.([\w-]+)\./.exec(link)![1]!;
    return JSON.parse(inflateRawSync(fromBase64Url(payload)!).toString()).k;
  };
  expect(camera(turned)).not.toEqual(camera(still));
  await page.waitForTimeout(1500); // longer than a turn runs on: it must have ended with the link
  expect(camera(await linkOf(page))).toEqual(camera(turned));
});

/** The link with its contents changed and a checksum that fits again. */
function forged(link: string, change: (contents: Record<string, any>) => void): string {
  const [address, version, payload] = /^(.*#)(f\d+)\.([\w-]+)\./.exec(link)!.slice(1) as [
    string,
    string,
    string,
  ];
  const contents = JSON.parse(inflateRawSync(fromBase64Url(payload)!).toString());
  change(contents);
  const bytes = deflateRawSync(JSON.stringify(contents));
  return `${address}${version}.${toBase64Url(bytes)}.${crc32(bytes).toString(16).padStart(8, '0')}`;
}

test('a link shows the same layout and the same numbers in a new page', async ({ page, context }) => {
  await openRoom(page, 'Box');
  await tab(page, 'Luminaires');
  await page.getByRole('button', { name: 'Pin L2' }).click();
  await settled(page);
  const [layout, numbers] = [await places(page), await results(page)];
  const link = await linkOf(page);
  expect(new URL(link).hash.length).toBeLessThanOrEqual(1800);

  const other = await context.newPage();
  await openApp(other, link);
  await expect(other.getByRole('heading', { level: 1 })).toHaveText('Box');
  await expect(status(other)).toHaveText('As given');
  await expectLit(other);
  expect(await places(other)).toEqual(layout);
  expect(await results(other)).toEqual(numbers);
  await tab(other, 'Luminaires');
  await expect(other.getByRole('button', { name: 'Unpin L2' })).toBeVisible();
  await other.getByRole('button', { name: 'Re-solve' }).click();
  await settled(other);
  await other.close();

  // The page that made it reads damaged ones: what is shown stays.
  const cases: [string, string, RegExp][] = [
    ['a light outside of the sites', forged(link, ({ y }) => void (y.p[0][0] += 5000)), /L1 .*no place/],
    ['two lights at one place', forged(link, ({ y }) => void (y.p[1] = y.p[0])), /same place/],
    ['a negative flux', forged(link, ({ y }) => void (y.f = [-1])), /cannot be read/],
    [
      'an unknown room',
      forged(link, (contents) => void (contents.r = 'attic')),
      /“attic”.*not part of this site/,
    ],
    [
      'another version of the room',
      forged(link, (c) => void (c.i = '0123456789abcdef')),
      /another version of “Box”/,
    ],
    ['a later version', link.replace('#f1.', '#f9.'), /another version of Fiat Lux/],
    ['half of it', link.slice(0, -60), /cannot be read/],
    [
      'a changed letter',
      link.replace(/(#f1\.[\w-]{20})([\w-])/, (_, head, c) => head + (c === 'A' ? 'B' : 'A')),
      /checksum/,
    ],
    ['bad base64', link.replace(/#.*/, '#f1.%%%notbase64***.00000000'), /cannot be read/],
    ['a script', link.replace(/#.*/, '#javascript:alert(1)'), /cannot be read/],
    ['markup', link.replace(/#.*/, '#<img src=x onerror=alert(1)>'), /cannot be read/],
  ];
  for (const [what, damaged, message] of cases) {
    await test.step(what, async () => {
      await page.evaluate((hash) => void (location.hash = hash), new URL(damaged).hash);
      await expect(page.getByRole('region', { name: 'Messages' }).getByText(message).first()).toBeVisible();
      const close = page.getByRole('button', { name: 'Dismiss this message' });
      while ((await close.count()) > 0) await close.first().click();
      await expect(page.getByRole('heading', { level: 1 })).toHaveText('Box');
    });
  }
  expect(await places(page)).toEqual(layout);

  // A damaged link to another room than the one that is open leaves a solver that still knows this one.
  await openRoom(page, 'E corridor');
  const corridor = await results(page);
  await page.evaluate((hash) => void (location.hash = hash), new URL(cases[0]![1]).hash);
  await expect(page.getByRole('alert').getByText(cases[0]![2])).toBeVisible();
  expect(await results(page)).toEqual(corridor);
  await tab(page, 'Luminaires');
  await page.getByRole('textbox', { name: /Flux of each/ }).fill('2000');
  await settled(page);
  expect((await results(page)).some((row) => row.startsWith('yellow wall'))).toBe(true);
  await expect(page.getByRole('alert').getByText(/solver|worker/)).toHaveCount(0);
});

test('a page that opens with a damaged link starts clean', async ({ page }) => {
  // The browser itself refuses addresses beyond 2 MB.
  await page.goto(`./#f1.${'A'.repeat(1_900_000)}.00000000`);
  await expect(page.getByRole('alert').getByText(/cannot be read/)).toBeVisible();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Open office');
  await settled(page);
  await expectLit(page);
});

// Areas in plan: drawn with the pointer, obeyed by the search, told in numbers; luminaires selected by one. Covers plan-overlay, area-list, area-marks.
import { expect, openRoom, settled, test } from './app.ts';

test('an area that is drawn in the plan stays free of luminaires', async ({ page }) => {
  await openRoom(page, 'Box');
  await page.getByRole('tab', { name: 'Luminaires' }).click();
  const areas = page.getByRole('region', { name: 'Where luminaires may hang' });
  await areas.getByRole('button', { name: 'Keep out' }).click();
  await expect(page.getByText('Drag the area to keep free')).toBeVisible();
  await expect(page.getByText(/room \d+\.\d\d × \d+\.\d\d m/)).toBeVisible();
  await expect(page.getByText('x and y count from the south-west corner')).toBeVisible();
  const plan = (await page.locator('.plan-draw').boundingBox())!;
  const middle = [plan.x + plan.width / 2, plan.y + plan.height / 2] as const;
  await page.mouse.move(middle[0], middle[1] - 90);
  await page.mouse.down();
  await page.mouse.move(middle[0] + 180, middle[1] + 90);
  await page.mouse.up();
  const row = areas.getByRole('group', { name: 'Keep out 1' });
  await expect(row).toBeVisible();
  await settled(page);
  const read = async (name: string) =>
    Number(await row.getByRole('textbox', { name: `Keep out 1: ${name}` }).inputValue());
  const [x, y, wide, deep] = [await read('x'), await read('y'), await read('wide'), await read('deep')];
  expect(wide * deep).toBeGreaterThan(0.1);
  const places = await page.locator('table.list tbody td:nth-child(2)').allTextContents();
  expect(places).toHaveLength(4);
  for (const place of places) {
    const [left, up] = place.split(',').map(Number) as [number, number];
    expect(left > x && left < x + wide && up > y && up < y + deep).toBe(false);
  }
  await row.getByRole('button', { name: 'Remove Keep out 1' }).click();
  await expect(row).toHaveCount(0);

  await page.getByRole('button', { name: 'Select in plan' }).click();
  await page.mouse.move(plan.x + 4, plan.y + 4);
  await page.mouse.down();
  await page.mouse.move(plan.x + plan.width - 4, plan.y + plan.height - 4);
  await page.mouse.up();
  const several = page.getByRole('toolbar', { name: 'Luminaires L1, L2, L3, L4' });
  await several.getByRole('button', { name: 'Pin here' }).click();
  await expect(page.locator('.luminaire-tag.is-pinned')).toHaveCount(4);
});

test('a room type judges the desks that are drawn, and its verdict fits beside the room', async ({
  page,
}) => {
  await openRoom(page, 'Open office');
  for (const desk of ['desk 1', 'desk 6']) await page.getByLabel(/^Add at/).selectOption({ label: desk });
  await page.getByRole('button', { name: 'Ready-made intentions from standards' }).click();
  await page
    .getByRole('dialog')
    .getByRole('button', { name: /Office, writing/ })
    .click();
  const verdict = page.getByRole('table', { name: /^Verdict/ });
  await expect(verdict.getByRole('row', { name: /^task 2 surround .* 300 lx/ })).toBeVisible();
  await settled(page);
  await expect(verdict.locator('.verdict-best').first()).toBeVisible({ timeout: 60_000 }); // felt between the desks
  const beyond = await verdict.evaluate((table) => {
    const { clientWidth, ownerDocument } = table.parentElement!;
    const { paddingLeft, paddingRight } = ownerDocument.defaultView!.getComputedStyle(table.parentElement!);
    return (
      (table as HTMLElement).offsetWidth - clientWidth + parseFloat(paddingLeft) + parseFloat(paddingRight)
    );
  });
  expect(beyond).toBeLessThanOrEqual(0);
});

// Intentions, luminaires and history, by pointer: the light follows while the pointer is held.
// Covers intentions-tab, intention-card, card-more, card-guarantee, infeasible-help, histogram, mean-range,
// selection-bar, paint-section, luminaires-tab, luminaire-hand, luminaire-tags, luminaire-objects, site-marks.
import type { Locator, Page } from '@playwright/test';
import {
  canvas,
  difference,
  expect,
  openRoom,
  picture,
  places,
  results,
  settled,
  tab,
  tagPlaces,
  test,
} from './app.ts';

/** The middle of an element, px of the page. */
async function middle(element: Locator): Promise<{ x: number; y: number }> {
  const box = (await element.boundingBox())!;
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** The thumb of a range input: where a press takes hold of it. */
async function thumb(slider: Locator): Promise<{ x: number; y: number; width: number }> {
  const box = (await slider.boundingBox())!;
  const at = await slider.evaluate((input: HTMLInputElement) => {
    const [low, high] = [Number(input.min), Number(input.max)];
    return (input.valueAsNumber - low) / (high - low);
  });
  const size = 16;
  return { x: box.x + size / 2 + at * (box.width - size), y: box.y + box.height / 2, width: box.width };
}

const card = (page: Page) => page.getByRole('article').filter({ has: page.getByRole('figure') });

/** Asks for bounds of the mean on the opened card. */
async function boundTheMean(page: Page): Promise<void> {
  await card(page).getByRole('button', { name: 'More' }).click();
  await card(page).getByRole('button', { name: 'Bounds of the mean' }).click();
}

const undo = (page: Page) => page.getByRole('button', { name: 'Undo', exact: true });
const redo = (page: Page) => page.getByRole('button', { name: 'Redo', exact: true });

test('a slider moves luminaires and light while it is held; the whole drag is one step of undo', async ({
  page,
}) => {
  await openRoom(page, 'E corridor');
  const before = { picture: await picture(page), tags: await tagPlaces(page) };
  // note: the histogram's handles have the same names, which is right for them
  const least = page.getByRole('slider', { name: 'yellow wall: mean at least' }).and(page.locator('input'));
  const most = page.getByRole('slider', { name: 'yellow wall: mean at most' }).and(page.locator('input'));
  const value = await most.inputValue();

  const at = await thumb(most);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 0.1 * at.width, at.y, { steps: 4 });
  const low = await thumb(least);
  await page.mouse.up();
  expect(Number(await most.inputValue())).toBeGreaterThan(Number(value));

  await page.mouse.move(low.x, low.y);
  await page.mouse.down();
  await page.mouse.move(low.x + 0.12 * low.width, low.y, { steps: 6 });
  // The button is still down.
  await expect.poll(() => tagPlaces(page)).not.toEqual(before.tags);
  await expect.poll(async () => difference(await picture(page), before.picture)).toBeGreaterThan(0.03);
  await page.mouse.up();
  await settled(page);

  await undo(page).click(); // the second drag
  await undo(page).click(); // the first drag
  await expect(undo(page)).toBeDisabled();
  expect(await most.inputValue()).toBe(value);
  await expect.poll(() => tagPlaces(page)).toEqual(before.tags);
  await redo(page).click();
  await redo(page).click();
  await expect(redo(page)).toBeDisabled();
  expect(Number(await least.inputValue())).toBeGreaterThan(30);
});

test('a luminaire that is dragged pins itself while the others place themselves anew', async ({ page }) => {
  await openRoom(page, 'E corridor');
  await canvas(page).press('1'); // plan: no luminaire hides another
  const before = await places(page);
  const tag = page.locator('[data-luminaire="0"]');
  const still = async () => {
    const first = await middle(tag);
    await page.evaluate(
      () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
    );
    const then = await middle(tag);
    return Math.hypot(then.x - first.x, then.y - first.y);
  };
  await expect.poll(still).toBe(0); // the camera has arrived
  const lit = await picture(page);
  const from = await middle(tag);
  const to = await middle(canvas(page));
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 5 });
  await page.mouse.move(to.x, to.y, { steps: 5 });
  // The button is still down: light and places have followed.
  await expect.poll(async () => difference(await picture(page), lit)).toBeGreaterThan(0.03);
  await page.mouse.up();
  await settled(page);
  const after = await places(page);
  expect(after[0]).not.toBe(before[0]);
  expect(after.slice(1)).not.toEqual(before.slice(1));

  const pin = page.getByRole('button', { name: 'Unpin L1' });
  await expect(pin).toHaveAttribute('aria-pressed', 'true');
  await undo(page).click();
  await expect(undo(page)).toBeDisabled(); // one step for the whole drag
  await expect.poll(() => places(page)).toEqual(before);
  await redo(page).click();
  await expect.poll(() => places(page)).toEqual(after);

  await pin.click();
  await expect(page.getByRole('button', { name: 'Pin L1' })).toHaveAttribute('aria-pressed', 'false');
  await page.getByRole('button', { name: 'Pin L2' }).click();
  await expect(page.getByRole('button', { name: 'Unpin L2' })).toHaveAttribute('aria-pressed', 'true');
  const held = (await places(page))[1];
  const flux = page.getByRole('textbox', { name: /Flux of each/ });
  await flux.fill('2500');
  await settled(page);
  expect((await places(page))[1]).toBe(held);
  await flux.fill('2');
  await flux.fill('26');
  await flux.press('Escape'); // takes back what was typed
  await expect(flux).toHaveValue('2500');

  await page.getByRole('button', { name: 'Pin L1' }).click();
  await page.getByRole('textbox', { name: 'Luminaires', exact: true }).fill('1');
  await expect(page.getByText('No fewer: 2 are pinned.')).toBeVisible();
});

test('intentions are added, edited and removed, with every verb', async ({ page }) => {
  await openRoom(page, 'Box');
  await tab(page, 'Results');
  await page.getByRole('button', { name: 'wall north', exact: true }).click();
  const verbs = ['Illuminate', 'Overshadow', 'Homogenize', 'Vary', 'Keep'];
  const bar = page.getByRole('toolbar', { name: 'Intentions for wall north' });
  await bar.getByRole('button', { name: 'Illuminate' }).click();
  const cards = page.getByRole('article');
  await expect(cards).toHaveCount(2);
  const body = page.getByRole('group', { name: 'What the light should do' });
  const means = new Map<string, string>();
  for (const verb of verbs) {
    await body.getByRole('button', { name: verb }).click();
    await expect(
      cards.last().getByRole('button', { name: `${verb} wall north`, exact: true }),
    ).toHaveAttribute('aria-expanded', 'true');
    await settled(page);
    const rows = await results(page);
    means.set(verb, rows.find((row) => row.startsWith('wall north')) ?? '');
    await tab(page, 'Intentions');
  }
  const mean = (verb: string) => Number(means.get(verb)?.split('\t')[1]?.replace(/\s/g, ''));
  expect(mean('Illuminate')).toBeGreaterThan(mean('Overshadow'));
  await expect(page.getByRole('textbox', { name: /wall north: mean at least/ })).not.toHaveValue('');

  await card(page).getByRole('button', { name: 'More' }).click();
  await page.getByRole('button', { name: 'Darkest or brightest spot' }).click();
  const spots = page.getByRole('group', { name: 'Darkest and brightest spot' });
  await spots.getByRole('button', { name: 'Chebyshev' }).click();
  await settled(page);
  await page.getByRole('button', { name: 'Remove: darkest and brightest spot' }).click();

  await page.getByRole('button', { name: 'Remove: keep wall north' }).click();
  await expect(cards).toHaveCount(1);
  for (const verb of verbs) await bar.getByRole('button', { name: verb }).click();
  await expect(cards).toHaveCount(6);
  await settled(page);
});

test('a drag after typing elsewhere is one step of undo, from its first value on', async ({ page }) => {
  await openRoom(page, 'Box');
  await tab(page, 'Luminaires');
  const flux = page.getByRole('slider', { name: 'Flux of each' });
  const typed = page.getByRole('textbox', { name: /Flux of each/ });
  await typed.fill('4000');
  const at = await thumb(flux);
  await page.mouse.move(at.x, at.y); // the caret is still in the field
  await page.mouse.down();
  await page.mouse.move(at.x + 0.2 * at.width, at.y, { steps: 3 });
  await page.mouse.up();
  await expect(typed).not.toHaveValue('4000');
  await undo(page).click();
  await expect(typed).toHaveValue('4000');
});

test('what cannot be placed is told once, with a way back, and forgotten when it can', async ({ page }) => {
  await openRoom(page, 'Box');
  await tab(page, 'Luminaires');
  const apart = page.getByRole('textbox', { name: /Apart by at least/ });
  const refusals = page.getByRole('alert').filter({ hasText: /only \d+ of .* find room/i });
  await apart.fill('3.9');
  await expect(refusals).toHaveCount(1);
  await apart.fill('3.8');
  await apart.press('ArrowDown');
  await expect(refusals).toHaveCount(1);
  await expect(page.getByText('Not solved')).toBeVisible();
  await apart.fill('0');
  await settled(page);
  await expect(refusals).toHaveCount(0);
  await apart.press('Enter');

  await apart.fill('3.9');
  await refusals.getByRole('button', { name: 'Undo' }).click();
  await expect(apart).toHaveValue('0');
  await expect(refusals).toHaveCount(0);
});

test('what cannot be met is named, and one click asks for what can', async ({ page }) => {
  await openRoom(page, 'Box');
  await boundTheMean(page);
  await page.getByRole('textbox', { name: /mean at least/ }).fill('90000');
  await page.getByRole('textbox', { name: /mean at least/ }).press('Enter');
  const help = page.getByRole('region', { name: 'What cannot be met' });
  await expect(help).toContainText(/mean at least 90.000 lx, the best found has/);
  await expect(page.getByText('1 bound not met')).toBeVisible();
  await help.getByRole('button', { name: /^Ask for/ }).click();
  await expect(help).toHaveCount(0);
  await settled(page);
  await expect(help).toHaveCount(0);
  await expect(page.getByText('not met')).toHaveCount(0);
});

test('bounds that cannot both be met stay as typed, and that is said', async ({ page }) => {
  await openRoom(page, 'Box');
  await boundTheMean(page);
  const [least, most] = [/mean at least/, /mean at most/].map((name) => page.getByRole('textbox', { name }));
  await least!.fill('5000');
  await most!.fill('200');
  await most!.press('Enter');
  await expect(least!).toHaveValue('5000');
  await expect(most!).toHaveValue('200');
  await expect(page.getByText('no layout can meet both')).toBeVisible();
});

test('a bound far beyond the light leaves the histogram its shape', async ({ page }) => {
  await openRoom(page, 'Box');
  const bars = page.locator('.histogram .bar');
  const before = await bars.count();
  expect(before).toBeGreaterThan(8);
  await boundTheMean(page);
  await page.getByRole('textbox', { name: /mean at most/ }).fill('9000000');
  await page.getByRole('textbox', { name: /mean at most/ }).press('Enter');
  await settled(page);
  expect(await bars.count()).toBeGreaterThan(before / 3);
  await expect(page.locator('.bound-handle text')).toHaveText(/^≤ 9.000.000$/);
});

test('a surface is painted by its slider, and undo takes the paint off again', async ({ page }) => {
  await openRoom(page, 'Box');
  const before = await results(page);
  const paint = page.getByRole('region', { name: 'Paint' });
  await paint.getByLabel('Surface').selectOption('floor');
  const slider = paint.getByRole('slider', { name: 'Reflectance of floor' });
  const original = await slider.inputValue();
  await slider.press('Shift+ArrowRight');
  await expect.poll(() => results(page)).not.toEqual(before);
  await settled(page);
  await expect(paint.getByText(/^Painted: floor/)).toBeVisible();
  await expect(paint.getByText(/^(lighter|darker): /).first()).toBeVisible();
  await paint.getByRole('button', { name: /^Terracotta/ }).click();
  await expect(slider).toHaveValue('0.2');
  await undo(page).click();
  await undo(page).click();
  await expect(slider).toHaveValue(original);
  await expect.poll(() => results(page)).toEqual(before);
});

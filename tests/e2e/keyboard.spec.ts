// Without a pointer: every control has its turn, the palette and help open by key, luminaires move by arrows.
// Covers panel, first-hint, top-bar, palette, surface-picker, luminaire-list, keyboard, view-input.
import { expect, openRoom, places, settled, tab, test, violations } from './app.ts';

test('everything can be reached and done by keyboard', async ({ page }) => {
  await openRoom(page, 'Box');
  await tab(page, 'Intentions');
  const controls = await page.evaluate(() => {
    const all = document.querySelectorAll<HTMLElement>(
      'button:not(:disabled), input, select, canvas, [role="slider"], [role="tab"]',
    );
    const reachable = [...all].filter((element) => element.checkVisibility() && element.tabIndex >= 0);
    reachable.forEach((element, index) => (element.dataset['order'] = String(index)));
    (document.activeElement as HTMLElement | null)?.blur();
    return reachable.length;
  });
  const visited = new Set<string>();
  for (let presses = 0; presses < controls + 10; presses++) {
    await page.keyboard.press('Tab');
    const order = await page.evaluate(() => (document.activeElement as HTMLElement).dataset['order']);
    if (order !== undefined) visited.add(order);
  }
  expect(visited.size).toBe(controls);

  await page.keyboard.press('Control+K');
  const palette = page.getByRole('dialog', { name: 'All actions' });
  await expect(palette.getByRole('combobox')).toBeFocused();
  await page.keyboard.type('false colour');
  await page.keyboard.press('Enter');
  await expect(palette).toHaveCount(0);
  await expect(page.getByRole('region', { name: 'Legend' })).toBeVisible();

  await page.keyboard.press('?');
  const help = page.getByRole('dialog', { name: 'Keys and help' });
  await expect(help).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(help).toHaveCount(0);

  await page.getByRole('tab', { name: 'Intentions' }).focus();
  await page.keyboard.press('ArrowRight');
  await expect(page.getByRole('tab', { name: 'Luminaires' })).toHaveAttribute('aria-selected', 'true');
  const before = await places(page);
  await page.getByRole('button', { name: 'L1', exact: true }).focus();
  await page.keyboard.press('Enter');
  const x = before.map(Number.parseFloat);
  const isLeft = x[0]! <= x.reduce((sum, each) => sum + each, 0) / x.length;
  await page.keyboard.press(isLeft ? 'ArrowRight' : 'ArrowLeft');
  await expect(page.getByRole('button', { name: 'Unpin L1' })).toBeVisible();
  await expect.poll(async () => (await places(page))[0]).not.toBe(before[0]);
  await settled(page);
  await page.keyboard.press('Control+Z');
  await expect.poll(() => places(page)).toEqual(before);
});

test('axe finds nothing serious: wide and narrow, light and dark, every tab and dialogue', async ({
  page,
}) => {
  await openRoom(page, 'Box');
  await page.emulateMedia({ reducedMotion: 'reduce' });
  for (const colorScheme of ['light', 'dark'] as const) {
    for (const width of [1280, 390]) {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 800 });
      const moving = await page.evaluate(() => document.getAnimations().length);
      expect(moving, `colours that still change, ${colorScheme}, ${width} px`).toBe(0);
      for (const name of ['Intentions', 'Luminaires', 'Results'] as const) {
        await tab(page, name);
        expect(await violations(page), `${name}, ${colorScheme}, ${width} px`).toEqual([]);
      }
      for (const name of ['Views', 'Picture settings', 'Compare']) {
        await page.getByRole('button', { name, exact: true }).click();
        expect(await violations(page), `${name}, ${colorScheme}, ${width} px`).toEqual([]);
        await page.keyboard.press('Escape');
      }
    }
    await tab(page, 'Results');
    await page.getByRole('button', { name: 'wall north', exact: true }).click();
    await page.keyboard.press('c');
    expect(await violations(page), `selection and false colour, ${colorScheme}`).toEqual([]);
    await page.keyboard.press('c');
    for (const key of ['Control+K', '?', 'g']) {
      await page.keyboard.press(key);
      await expect(page.getByRole('dialog'), key).toBeVisible();
      expect(await violations(page), `dialogue of ${key}, ${colorScheme}`).toEqual([]);
      await page.keyboard.press('Escape');
      await expect(page.locator('dialog')).toHaveCount(0); // gone, not only hidden: keys are heard again
    }
    await page.getByRole('button', { name: 'wall north', exact: true }).click();
  }
});

test('what is typed right after the key of the palette arrives in it', async ({ page }) => {
  await openRoom(page, 'Box');
  const download = page.waitForEvent('download');
  await page.keyboard.press('Control+k');
  await page.keyboard.type('csv');
  await page.keyboard.press('Enter');
  expect((await download).suggestedFilename()).toBe('box-luminaires.csv');
});

test('surfaces and luminaires are found by name; Delete takes a luminaire away', async ({ page }) => {
  await openRoom(page, 'Box');
  await page.getByRole('button', { name: /^Surfaces: / }).press('Enter');
  await expect(page.getByRole('searchbox', { name: 'Find a surface' })).toBeFocused();
  await page.keyboard.type('wall q'); // and no key of the page
  await expect(page.getByText('No surface is called that.')).toBeVisible();
  await page.keyboard.press('Backspace');
  await page.keyboard.type('n');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('button', { name: 'Surfaces: wall north' })).toBeFocused();

  await page.keyboard.press('Control+K');
  await page.keyboard.type('wall south');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('toolbar', { name: 'Intentions for wall south' })).toBeVisible();

  await page.keyboard.press('Control+K');
  await page.keyboard.type('L2');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('toolbar', { name: 'Luminaire L2' })).toBeVisible();
  expect(await places(page)).toHaveLength(4);
  await page.keyboard.press('Delete');
  await expect(page.getByRole('toolbar', { name: /^Luminaire/ })).toHaveCount(0);
  await expect.poll(() => places(page)).toHaveLength(3);
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect.poll(() => places(page)).toHaveLength(4);
});

test('a number field says how it read a comma, what is no number, and what it cut', async ({ page }) => {
  await openRoom(page, 'Box');
  const field = page.getByRole('textbox', { name: /aim at a mean/ });
  const hint = page.getByText('Drag the slider');
  await expect(hint).toBeVisible();
  await field.fill('1,250');
  await expect(page.getByRole('status').filter({ hasText: /^Read as 1.250$/ })).toBeVisible();
  await field.press('Enter');
  await expect(field).toHaveValue('1250');
  await expect(hint).toHaveCount(0);
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect(hint).toHaveCount(0);
  await tab(page, 'Luminaires');
  const count = page.getByRole('textbox', { name: 'Luminaires', exact: true });
  const before = await count.inputValue();
  await count.focus();
  await page.keyboard.type('1e9'); // its 1 is taken back
  await count.press('Enter');
  await expect(page.getByRole('status').filter({ hasText: /^Not a plain number$/ })).toBeVisible();
  await expect(count).toHaveValue(before);
  await count.fill('5000');
  await expect(page.getByRole('status').filter({ hasText: /^At most/ })).toBeVisible();
});

// What a person sees first: a lit, solved room; every room and experiment of the gallery.
import {
  canvas,
  difference,
  expect,
  expectLit,
  openApp,
  openRoom,
  picture,
  places,
  results,
  settled,
  test,
} from './app.ts';

test('the first screen is a lit, solved room, and every room of the gallery is', async ({ page }) => {
  test.setTimeout(180_000);
  await openApp(page);
  await settled(page);
  await expect(page.getByRole('dialog')).toHaveCount(0);
  await expectLit(page);
  expect(new Set(await places(page)).size).toBeGreaterThan(6);
  let last = await picture(page);
  for (const room of ['E corridor', 'Classroom', 'Gallery', 'Box']) {
    await test.step(room, async () => {
      await openRoom(page, room);
      await expectLit(page);
      const now = await picture(page);
      expect(difference(now, last)).toBeGreaterThan(0.2);
      last = now;
      expect((await results(page)).length).toBeGreaterThan(3);
      expect(new Set(await places(page)).size).toBeGreaterThan(3);
    });
  }
});

test('an experiment of the paper states its bounds and meets them', async ({ page }) => {
  await openRoom(page, '5.2 Homogenize');
  const card = page.getByRole('article');
  await expect(card.getByRole('button', { name: 'Homogenize', exact: true })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
  await expect(card.getByRole('img', { name: 'met', exact: true })).toBeVisible();
  await expect(card.getByRole('textbox', { name: /mean at least/ })).not.toHaveValue('');
  await expect(page.getByRole('button', { name: /Exitance/ })).toHaveAttribute('aria-pressed', 'true');
});

test('false colour, views and cut-away change the picture', async ({ page }) => {
  await openRoom(page, 'Box');
  const realistic = await picture(page);
  await page.getByRole('button', { name: 'False colour' }).click();
  await expect.poll(async () => difference(await picture(page), realistic)).toBeGreaterThan(0.2);
  await expect(page.getByRole('region', { name: 'Legend' })).toBeVisible();
  const colored = await picture(page);
  await canvas(page).press('1'); // plan
  await expect.poll(async () => difference(await picture(page), colored)).toBeGreaterThan(0.1);
  const plan = await picture(page);
  await page.getByRole('button', { name: 'Picture settings' }).click();
  await page.getByRole('checkbox', { name: 'Isolux lines' }).check();
  await page.keyboard.press('Escape');
  await expect.poll(async () => difference(await picture(page), plan)).toBeGreaterThan(0.002);
});

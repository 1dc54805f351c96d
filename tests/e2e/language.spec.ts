/** German: asked for by the address, and the way back to English in the open page. */
import { expect, test } from './app.ts';

test('the page speaks German where its address says so, until another language is chosen', async ({
  page,
}) => {
  await page.goto('./?room=box&lang=de');
  await expect(page.locator('html')).toHaveAttribute('lang', 'de');
  await expect(page.getByText(/^(Fertig|Wie vorgegeben)$/)).toBeVisible({ timeout: 60_000 });

  // Its words are longer: nothing leaves the open card on the narrowest of screens.
  const usual = page.viewportSize()!;
  await page.setViewportSize({ width: 320, height: 640 });
  const beyond = await page.locator('.card.open').evaluate((card) => {
    const parts = [...card.querySelectorAll('.field, .field-head > *, input, button')];
    const { right } = card.getBoundingClientRect();
    return parts.filter((part) => part.getBoundingClientRect().right > right).map((part) => part.className);
  });
  expect(beyond).toEqual([]);
  await page.getByRole('tab', { name: 'Ergebnisse' }).click();
  const cut = await page
    .locator('.results .plain')
    .evaluateAll((names) =>
      names.filter((each) => each.scrollWidth > each.clientWidth).map((each) => each.textContent),
    );
  expect(cut, 'names of surfaces that are cut').toEqual([]);
  await page.setViewportSize(usual);

  for (const name of ['Ziele', 'Leuchten', 'Ergebnisse']) await page.getByRole('tab', { name }).click();
  const evenness = page.getByRole('table', { name: 'Licht je Fläche' }).locator('td').last();
  await expect(evenness).toHaveText(/^\d,\d\d$/);

  await page.getByRole('button', { name: 'Datei und Export' }).click();
  await page.getByRole('menuitem', { name: 'English' }).click();
  await expect(page.getByRole('tab', { name: 'Results' })).toBeVisible();
  await expect(page.locator('html')).toHaveAttribute('lang', 'en');
  await expect(page.getByRole('table', { name: 'Light by surface' }).locator('td').last()).toHaveText(
    /^\d\.\d\d$/,
  );
  expect(new URL(page.url()).searchParams.has('lang')).toBe(false);
});

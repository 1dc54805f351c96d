// Files that are broken or meant to harm, dropped one after another: each is refused in a line, nothing is fetched, and the
// page goes on. Covers too-much in the page.
import { refused } from '../web/hostile-models.ts';
import { drop, expect, openApp, test } from './app.ts';

test.setTimeout(400_000); // so many drops where software draws
test.use({ viewport: { width: 900, height: 600 } });

test('each is refused in a line that names it', async ({ page }) => {
  await openApp(page, './?room=box');
  const messages = page.getByRole('region', { name: 'Messages' });
  for (const [name, make] of Object.entries(refused)) {
    await drop(page, { [name]: Buffer.from(make()) });
    const stem = name.replace(/\..*/, '');
    const said = messages.getByText(stem === 'scene' ? /scene file/ : new RegExp(`^“?${stem}\\.`, 'i'));
    const unlit = page.getByRole('heading', { name: `“${stem}” could not be lit` });
    await expect(said.or(unlit).first(), name).toBeVisible();
  }
});

// The view inside another page: only looked at, moved by messages; nothing is kept of it.
// Covers embed-caption, embedding, share-embed, share-dialog.
import type { Locator, Page } from '@playwright/test';
import { expect, openRoom, status, test } from './app.ts';

test('a shared line of HTML shows the room in another page, which moves it and hears of it', async ({
  page,
  context,
}) => {
  await openRoom(page, 'Box');
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  const line = await page.getByRole('textbox', { name: 'HTML to embed' }).inputValue();
  const stored = (of: Page) => of.evaluate(() => JSON.stringify({ ...localStorage }));
  const before = await stored(page);
  await page.close();

  const host = await context.newPage();
  const script = `heard = [];
    addEventListener('message', ({ data, source }) => {
      heard.push(data);
      if (data.type === 'ready') source.postMessage({ fiatlux: 1, type: 'view', view: 'plan' }, location.origin);
    });`;
  const body = `<!doctype html><title>host</title><body><script>${script}</script>${line}</body>`;
  await host.route('**/host.html', (route) => route.fulfill({ contentType: 'text/html', body }));
  await host.goto('./host.html');
  const heard = (type: string) =>
    host.evaluate(
      (wanted) => (globalThis as unknown as { heard: any[] }).heard.filter(({ type }) => type === wanted),
      type,
    );
  await expect
    .poll(() => heard('shown'))
    .toContainEqual(expect.objectContaining({ room: 'box', state: 'given' }));
  await expect.poll(async () => (await heard('camera')).at(-1)?.camera.plan).toBe(true);

  const frame = host.frameLocator('iframe');
  await expect(frame.getByText('Box', { exact: true })).toBeVisible();
  await host.evaluate(() => {
    const view = document.querySelector('iframe')!.contentWindow!;
    const display = { mode: 'falseColor', range: [10, 500] };
    view.postMessage({ fiatlux: 1, type: 'display', display }, location.origin);
  });
  const legend = frame.getByRole('img', { name: 'From 10 to 500 lx' });
  await expect(legend).toBeVisible();
  // Scale and legend stand below the plan, not on it.
  const rect = (of: Locator) => of.evaluate((each) => each.getBoundingClientRect().toJSON() as DOMRect);
  const tops = [await rect(legend), await rect(frame.getByRole('note', { name: /Scale bar/ }))];
  const tags = await Promise.all((await frame.locator('[data-luminaire]').all()).map(rect));
  const lowest = Math.max(...tags.map(({ bottom }) => bottom));
  for (const { top } of tops) expect(top).toBeGreaterThan(lowest);
  // In a narrow frame the scale keeps its numbers: no fields stand beside it.
  const narrow = (width: string) =>
    host.evaluate((css) => void (document.querySelector('iframe')!.style.width = css), width);
  await narrow('340px');
  await expect(legend.getByText('500')).toBeVisible();
  await narrow('');
  for (const role of ['tab', 'button', 'slider', 'textbox'] as const)
    await expect(frame.getByRole(role)).toHaveCount(0);
  const view = frame.getByRole('application');
  await view.hover({ position: { x: 400, y: 250 } });
  await expect.poll(async () => (await heard('pointer')).some(({ lux }) => lux > 0)).toBe(true);
  // A press where a luminaire hangs takes nothing: the layout stays as given.
  const tag = await frame
    .locator('[data-luminaire]')
    .first()
    .evaluate((each) => each.getBoundingClientRect().toJSON());
  await view.dragTo(view, {
    sourcePosition: { x: tag.x + tag.width / 2, y: tag.y + tag.height / 2 },
    targetPosition: { x: 300, y: 300 },
  });
  expect((await heard('shown')).at(-1)).toMatchObject({ state: 'given' });
  expect(await stored(host)).toBe(before);

  const [whole] = await Promise.all([
    context.waitForEvent('page'),
    frame.getByRole('link', { name: 'Open in Fiat Lux' }).click(),
  ]);
  await expect(whole.getByRole('heading', { level: 1 })).toHaveText('Box');
  await expect(status(whole)).toHaveText('As given');
});

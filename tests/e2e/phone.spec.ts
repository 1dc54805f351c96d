// A phone in the hand: nothing is clipped, the room stays in sight, everything is done by fingers.
// Covers camera-rig, pointer-input, view-input, slider, use-sheet, read-on.
import type { CDPSession, Page } from '@playwright/test';
import {
  canvas,
  difference,
  drop,
  expect,
  openApp,
  openRoom,
  picture,
  places,
  results,
  settled,
  tab,
  tagPlaces,
  test,
} from './app.ts';

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
test.use({ contextOptions: { reducedMotion: 'reduce' } }); // where things stand, they stand at once

type Finger = readonly [number, number];

/** Fingers that go down, move and rise together; the screen sees every step. */
async function drag(
  session: CDPSession,
  from: readonly Finger[],
  to: readonly Finger[],
  steps = 8,
): Promise<void> {
  const touch = (type: string, fingers: readonly Finger[]) =>
    session.send('Input.dispatchTouchEvent', {
      type: type as 'touchStart',
      touchPoints: fingers.map(([x, y], id) => ({ x, y, id })),
    });
  await touch('touchStart', from);
  for (let step = 1; step <= steps; step++) {
    const at = from.map(([x, y], i): Finger => {
      const [endX, endY] = to[i]!;
      return [x + ((endX - x) * step) / steps, y + ((endY - y) * step) / steps];
    });
    await touch('touchMove', at);
    await new Promise((resolve) => setTimeout(resolve, 30));
  }
  await touch('touchEnd', []);
}

/** Controls that reach beyond the screen, or that are too small for a finger. */
function outside(page: Page): Promise<string[]> {
  return page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>('button, input, [role="tab"], h1')]
      .filter((element) => element.checkVisibility() && !element.closest('.unseen'))
      .filter((element) => {
        const { left, right } = element.getBoundingClientRect();
        return left < -0.5 || right > innerWidth + 0.5;
      })
      .map((element) => element.getAttribute('aria-label') ?? element.textContent ?? element.className),
  );
}

test('nothing is wider than the screen, and the toolbar covers nothing of the room', async ({ page }) => {
  await openApp(page);
  await settled(page);
  for (const name of ['Intentions', 'Luminaires', 'Results'] as const) {
    await tab(page, name);
    expect(await outside(page), name).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth), name).toBe(390);
    const panel = page.getByRole('tabpanel');
    expect(await panel.evaluate((element) => element.scrollWidth - element.clientWidth), name).toBe(0);
  }
  // Beside the toolbar, in the strip that it takes, there is nothing but the ground (48 px away, where the toolbar's shadow ends).
  const strip = await picture(page);
  const bar = (await page.getByRole('toolbar', { name: 'View' }).boundingBox())!;
  const stage = (await canvas(page).boundingBox())!;
  const scale = strip.width / stage.width;
  const [from, rows] = [
    Math.ceil((bar.x + bar.width + 48) * scale),
    Math.floor((bar.y + bar.height - stage.y) * scale),
  ];
  for (let y = 0; y < rows; y++) {
    const pixel = (x: number) => [0, 1, 2].map((c) => strip.data[4 * (y * strip.width + x) + c]!);
    const first = pixel(from);
    for (let x = from; x < strip.width; x++) {
      const off = Math.max(...pixel(x).map((value, c) => Math.abs(value - first[c]!)));
      if (off > 6) throw new Error(`something at ${x}, ${y} of the strip`);
    }
  }
});

test('the narrowest screen shows tags below the toolbar and no half of a figure', async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 640 });
  await openRoom(page, 'Box');
  const bar = (await page.getByRole('toolbar', { name: 'View' }).boundingBox())!;
  const tags = await page.locator('[data-luminaire]').all();
  for (const tag of tags) expect((await tag.boundingBox())!.y).toBeGreaterThanOrEqual(bar.y + bar.height);
  // What is compared is in one bar, whole, with every button that it can have.
  await page.getByRole('button', { name: 'Compare', exact: true }).click();
  await page.getByRole('menuitem', { name: /Keep this layout/ }).click();
  const compared = page.getByRole('toolbar', { name: 'Comparison' });
  await expect(compared).toBeVisible();
  const ends = await compared
    .getByRole('button')
    .evaluateAll((all) => all.map((each) => each.getBoundingClientRect().right));
  expect(Math.max(...ends)).toBeLessThanOrEqual(320);
  expect((await compared.getByRole('combobox').boundingBox())!.width).toBeGreaterThan(48);
  await compared.getByRole('button', { name: 'End the comparison' }).click();

  const figures = page.locator('.status-figures');
  const [frame, text] = [(await figures.boundingBox())!, (await figures.locator('span').boundingBox())!];
  const isWhole = text.x + text.width <= frame.x + frame.width + 1;
  expect(isWhole || text.y >= frame.y + frame.height).toBe(true);
  await results(page);
  await page.getByRole('button', { name: 'floor', exact: true }).click();
  const selection = (await page.getByRole('toolbar', { name: 'Intentions for floor' }).boundingBox())!;
  const free = selection.y - (bar.y + bar.height);
  expect(free).toBeGreaterThan(2 * selection.height); // of the room's strip
  await page.getByRole('button', { name: 'Clear the selection' }).click();

  // On a tablet the panel leaves the verbs of a surface less room than a phone does.
  await page.setViewportSize({ width: 820, height: 1180 });
  await results(page);
  await page.getByRole('button', { name: 'floor', exact: true }).click();
  const verbs = page.getByRole('toolbar', { name: 'Intentions for floor' }).getByRole('button');
  await expect(verbs.first()).toBeVisible();
  const tooLong = (all: Element[]) => all.filter((verb) => verb.scrollWidth > verb.clientWidth).length;
  expect(await verbs.evaluateAll(tooLong)).toBe(0);
});

test('what can be done with a selected surface hides nothing of the room', async ({ page }) => {
  await openRoom(page, 'Box');
  await tab(page, 'Results');
  await page.getByRole('button', { name: 'floor', exact: true }).click();
  for (const [width, height] of [
    [390, 844],
    [1440, 900],
  ] as const) {
    await page.setViewportSize({ width, height });
    const rowAbove = async () => {
      const bar = (await page.getByRole('toolbar', { name: /^Intentions for/ }).boundingBox())!;
      const stage = (await canvas(page).boundingBox())!;
      const { data, width: pixels } = await picture(page);
      const scale = pixels / stage.width;
      const y = Math.floor((bar.y - stage.y - 1) * scale);
      const at = (x: number) => [0, 1, 2].map((c) => data[4 * (y * pixels + Math.round(x)) + c]!);
      const middle = at((bar.x + bar.width / 2) * scale); // where the room's nearest corner would be
      const beside = at((bar.x + 0.25 * bar.width) * scale);
      return Math.max(...middle.map((value, c) => Math.abs(value - beside[c]!)));
    };
    await expect.poll(rowAbove, `${width} px`).toBeLessThan(12);
  }
});

test('fingers orbit, pinch, drag a luminaire, slide a bound and raise the sheet', async ({
  page,
  context,
}) => {
  await openRoom(page, 'Box');
  const session = await context.newCDPSession(page);
  const stage = (await canvas(page).boundingBox())!;
  const [x, y] = [stage.x + stage.width / 2, stage.y + stage.height * 0.75];

  let before = await picture(page);
  await drag(session, [[x - 60, y]], [[x + 60, y + 10]]);
  await expect.poll(async () => difference(await picture(page), before)).toBeGreaterThan(0.1);
  before = await picture(page);
  await drag(
    session,
    [
      [x - 20, y],
      [x + 20, y],
    ],
    [
      [x - 90, y],
      [x + 90, y],
    ],
  );
  await expect.poll(async () => difference(await picture(page), before)).toBeGreaterThan(0.1);
  await page.getByRole('button', { name: 'Home view' }).tap();

  // A luminaire under the finger pins itself.
  const held = await places(page);
  const home = await tagPlaces(page);
  await page.getByRole('button', { name: 'Views' }).tap();
  await page.getByRole('button', { name: 'Plan', exact: true }).tap();
  await expect(page.getByRole('group', { name: 'Views' })).toHaveCount(0); // the picture is seen
  const tag = page.locator('[data-luminaire="0"]');
  await expect.poll(() => tagPlaces(page)).not.toEqual(home);
  const box = (await tag.boundingBox())!;
  const start: Finger = [box.x + box.width / 2, box.y + box.height / 2];
  await drag(session, [start], [[start[0] + (start[0] < x ? 70 : -70), start[1]]]);
  await expect(page.getByRole('button', { name: 'Unpin L1' })).toBeVisible();
  await expect.poll(async () => (await places(page))[0]).not.toBe(held[0]);
  await settled(page);

  // The room is in sight while the aim is dragged, and follows it.
  await tab(page, 'Intentions');
  const thumb = page.getByRole('slider', { name: 'floor: about' });
  await thumb.scrollIntoViewIfNeeded();
  expect(stage.height).toBeGreaterThan(300);
  const track = (await thumb.boundingBox())!;
  const share = await thumb.evaluate((input: HTMLInputElement) => input.valueAsNumber / Number(input.max));
  const grip: Finger = [track.x + 12 + share * (track.width - 24), track.y + track.height / 2];
  const value = Number(await thumb.inputValue());
  await drag(session, [grip], [[grip[0] + 60, grip[1]]]);
  expect(Number(await thumb.inputValue())).toBeGreaterThan(value);

  // The sheet follows the finger and rests.
  const sheet = page.getByRole('complementary');
  const handle = (await page.getByRole('tablist').boundingBox())!;
  const middle: Finger = [handle.x + handle.width / 2, handle.y + 4];
  const height = async () => (await sheet.boundingBox())!.height;
  const half = await height();
  await drag(session, [middle], [[middle[0], middle[1] + 260]]);
  await expect.poll(height).toBeLessThan(half - 200);
  await tab(page, 'Results');
  await expect.poll(height).toBe(half);
  // Raised, it leaves a glance at the plan, with nothing over it.
  const scale = page.getByRole('note', { name: /Scale bar/ });
  await expect(scale).toBeVisible();
  await page.getByRole('button', { name: 'Raise the panel' }).tap();
  await expect(scale).toBeHidden();
});

test('what a phone shows is all there where a tablet opens its link', async ({ page, context }) => {
  await openApp(page);
  await settled(page);
  const shown = await tagPlaces(page);
  expect(shown).toHaveLength(24);
  await page.getByRole('button', { name: 'Share', exact: true }).tap();
  const link = await page.getByRole('dialog').getByRole('textbox', { name: 'Link' }).inputValue();
  const other = await context.newPage();
  await other.setViewportSize({ width: 820, height: 1180 });
  await openApp(other, link);
  const { x, width } = (await canvas(other).boundingBox())!;
  const beyond = () =>
    other
      .locator('[data-luminaire]')
      .evaluateAll(
        (tags, [from, to]) =>
          tags
            .map((tag) => tag.getBoundingClientRect())
            .filter(({ left, right }) => !(left > from! && right < to!)).length,
        [x, x + width],
      );
  await expect.poll(beyond).toBe(0); // tags stand in the corner until the first picture
});

/** A box of 4 x 3 x 5 m, open at two ends, of which there is to be remarked that nothing has a material. */
function openBox(): string {
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map(
    (i) => `v ${(i & 1) * 4} ${((i >> 1) & 1) * 3} ${(i >> 2) * 5}`,
  );
  const faces = ['1 5 6 2', '3 4 8 7', '1 3 7 5', '2 6 8 4'].map((face) => `f ${face}`);
  return ['o room', ...corners, ...faces].join('\n');
}

test('what is told of a dropped model leaves its picture in sight, and is there for who reads on', async ({
  page,
}) => {
  test.setTimeout(300_000); // beside light that is computed
  await openRoom(page, 'Box');
  await drop(page, { 'room.obj': openBox() });
  const note = page.getByRole('region', { name: 'Light is being computed' });
  const remark = page.locator('.toast-warning').first();
  const heightOf = async (told: typeof note) => (await told.boundingBox())?.height ?? 0;
  await expect(remark).toBeVisible({ timeout: 120_000 });
  expect(await heightOf(note)).toBeLessThan(72);
  expect(await heightOf(remark)).toBeLessThan(72);
  await expect(note.getByText(/^\d+ %$/)).toBeVisible();
  const before = await heightOf(remark);
  await remark.getByRole('button', { name: 'Read on' }).tap();
  expect(await heightOf(remark)).toBeGreaterThan(before);
  await note.getByRole('button', { name: 'Read on' }).tap();
  await expect(note.getByText(/ %/)).toBeVisible();
  const lost = page.getByRole('status', { name: 'About this light' });
  await expect(lost).toBeVisible({ timeout: 200_000 });
  expect(await heightOf(lost)).toBeLessThan(72);
  await lost.getByRole('button', { name: 'Read on' }).tap();
  await expect(lost.getByText(/leaves the model/)).toBeVisible();
});

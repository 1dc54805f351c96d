/**
 * The real app for a test: opened, watched (console, violations of the content security policy, requests that leave
 * the site; a test fails on any of them), and read the way a person reads it.
 */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { test as base, expect, type BrowserContext, type Page } from '@playwright/test';
import { PNG } from 'pngjs';

export { expect };

/** Everything that must not happen while a test runs; a test that provokes something empties what it expects. */
export interface Watched {
  readonly faults: string[];
}

export const test = base.extend<{ watched: Watched }>({
  watched: [
    async ({ context, baseURL }, use) => {
      const watched = { faults: await watch(context, new URL(baseURL ?? '').origin) };
      await use(watched);
      expect(watched.faults, 'errors, violations and requests that leave the site').toEqual([]);
    },
    { auto: true },
  ],
});

/** Collects, as long as the context lives, what must not happen on its pages. */
export async function watch(context: BrowserContext, origin: string): Promise<string[]> {
  const faults: string[] = [];
  context.on('console', (message) => {
    if (message.type() === 'error') faults.push(`console: ${message.text()}`);
  });
  context.on('weberror', (error) => faults.push(`page error: ${error.error().message}`));
  context.on('request', (request) => {
    const { protocol, origin: asked } = new URL(request.url());
    if (/^https?:$/.test(protocol) && asked !== origin) faults.push(`request: ${request.url()}`);
  });
  await context.exposeFunction('reportViolation', (what: string) => faults.push(`policy: ${what}`));
  await context.addInitScript(drawFast);
  await context.addInitScript(() => {
    document.addEventListener('securitypolicyviolation', (event) => {
      const { reportViolation } = window as unknown as { reportViolation(what: string): void };
      reportViolation(`${event.violatedDirective} ${event.blockedURI}`);
    });
  });
  return faults;
}

/** Edges that are not smoothed take software half as long to draw, and no test looks at them. */
function drawFast(): void {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (
    this: HTMLCanvasElement,
    kind: string,
    options?: object,
  ) {
    return getContext.call(this, kind, kind === 'webgl2' ? { ...options, antialias: false } : options);
  } as typeof getContext;
}

const patience = { timeout: 60_000 }; // for rooms to load; nothing measures time

/** The first screen, or what a link shows. */
export async function openApp(page: Page, address = './'): Promise<void> {
  await page.goto(address);
  await expect(status(page)).toHaveText(/^(Settled|As given)$/, patience);
}

// Rooms that the address can name, so that a test need not load the first room as well.
const ids: Readonly<Record<string, string>> = {
  'Open office': 'office',
  'E corridor': 'e-corridor',
  Box: 'box',
};

/** A room or an experiment: where the page is not open yet, a room by its address, else by the gallery. */
export async function openRoom(page: Page, title: string, address = './'): Promise<void> {
  const isOpen = page.url() !== 'about:blank';
  const id = ids[title];
  if (!isOpen) await page.goto(id ? `${address}?room=${id}` : address);
  if (isOpen || !id) {
    await page.getByRole('banner').getByRole('button').first().click();
    const gallery = page.getByRole('dialog', { name: 'Rooms' });
    await gallery.getByRole('button', { name: title }).first().click();
  }
  await expect(page.getByRole('heading', { level: 1 })).toHaveText(title, patience);
  await settled(page);
}

export function status(page: Page) {
  return page.getByLabel('Intentions and results').getByText(/^(Settled|Improving|As given|Not solved)$/);
}

/** The search has ended. For use after the page was seen to take the wish. */
export async function settled(page: Page): Promise<void> {
  await expect(status(page)).toHaveText('Settled', patience);
}

export async function tab(page: Page, name: 'Intentions' | 'Luminaires' | 'Results'): Promise<void> {
  await page.getByRole('tab', { name }).click();
}

/** Where the luminaires are: "x, y, z" in metres, by the list on the tab of the luminaires. */
export async function places(page: Page): Promise<string[]> {
  await tab(page, 'Luminaires');
  const cells = page.getByRole('table', { name: /Luminaires in place/ }).locator('tbody td:nth-of-type(1)');
  await expect(cells.first()).toBeVisible(patience); // a room that takes another's place is lit anew
  return cells.allTextContents();
}

/** Every number of the table of results. */
export async function results(page: Page): Promise<string[]> {
  await tab(page, 'Results');
  const rows = page.getByRole('table', { name: /Light by surface/ }).locator('tbody tr');
  await expect(rows.first()).toBeVisible();
  return rows.allInnerTexts();
}

/**
 * Where the tags stand on the picture: what tells that luminaires moved while a pointer is held. Those behind the eye are
 * hidden where they last were.
 */
export function tagPlaces(page: Page): Promise<string[]> {
  return page
    .locator('[data-luminaire]')
    .evaluateAll((tags) =>
      (tags as HTMLElement[]).map((tag) => (tag.hidden ? 'behind the eye' : tag.style.transform)),
    );
}

/** A drop as the browser makes it: a DataTransfer with files, on the page. */
export async function drop(page: Page, files: Readonly<Record<string, Buffer | string>>): Promise<void> {
  const named = Object.entries(files).map(([name, bytes]) => [name, Buffer.from(bytes).toString('base64')]);
  const transfer = await page.evaluateHandle((all) => {
    const data = new DataTransfer();
    for (const [name, base64] of all) {
      const bytes = Uint8Array.from(atob(base64!), (character) => character.charCodeAt(0));
      data.items.add(new File([bytes], name!));
    }
    return data;
  }, named);
  for (const type of ['dragenter', 'dragover', 'drop'])
    await page.getByRole('main').dispatchEvent(type, { dataTransfer: transfer });
}

export function canvas(page: Page) {
  return page.getByRole('application');
}

/** The pixels of the canvas as they are on the screen. */
export async function picture(page: Page): Promise<PNG> {
  // note: hiding the caret would need a style sheet, which the policy of the page forbids
  return PNG.sync.read(await canvas(page).screenshot({ caret: 'initial' }));
}

/** The picture once it has come to rest: light takes its colour, and shadows near contacts, some time after it is there. */
export async function pictureAtRest(page: Page): Promise<PNG> {
  await page.waitForFunction(() => performance.getEntriesByName('contacts lit').length > 0, null, patience);
  for (let last = await picture(page); ;) {
    await page.waitForTimeout(1500);
    const now = await picture(page);
    if (difference(now, last) < 0.001) return now;
    last = now;
  }
}

/** How many colours a picture has (5 bits a channel) and how bright it is on average (0 to 255). */
export function look({ data }: PNG): { colors: number; mean: number } {
  const colors = new Set<number>();
  let sum = 0;
  for (let i = 0; i < data.length; i += 4) {
    const [r, g, b] = [data[i]!, data[i + 1]!, data[i + 2]!];
    colors.add(((r >> 3) << 10) | ((g >> 3) << 5) | (b >> 3));
    sum += (r + g + b) / 3;
  }
  return { colors: colors.size, mean: sum / (data.length / 4) };
}

/** The share of pixels that differ by more than a few levels. */
export function difference(a: PNG, b: PNG): number {
  if (a.width !== b.width || a.height !== b.height) return 1;
  let different = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    const by = Math.max(...[0, 1, 2].map((c) => Math.abs(a.data[i + c]! - b.data[i + c]!)));
    if (by > 4) different += 1;
  }
  return different / (a.width * a.height);
}

/** A lit room: neither blank nor flat nor black. */
export async function expectLit(page: Page, colors = 150): Promise<void> {
  await expect.poll(async () => look(await picture(page)).colors, patience).toBeGreaterThan(colors);
  expect(look(await picture(page)).mean).toBeGreaterThan(20);
}

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** Serious and critical violations of the page as it is. */
export async function violations(page: Page): Promise<string[]> {
  // note: evaluated, not added as a script element, which the policy of the page forbids
  await page.evaluate(`{ const module = undefined; ${axe} }`);
  return page.evaluate(async () => {
    const { axe } = window as unknown as { axe: { run(): Promise<{ violations: any[] }> } };
    const found = (await axe.run()).violations.filter(({ impact }) => /serious|critical/.test(impact));
    return found.map(
      ({ id, nodes }) => `${id}: ${nodes.map((node: any) => node.target.join(' ')).join(', ')}`,
    );
  });
}

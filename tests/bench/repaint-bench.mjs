/**
 * The built app in Chromium: how long from a step of the reflectance slider until the worker has posted the light of the
 * layout in the painted room. The office, its largest wall, luminaires of the one type that it opens with: 260 candidates.
 */
import { inBrowser, recordWorkers, served } from './drag-bench.mjs';

const steps = 40;
const pause = 250; // ms between two steps, of a search that the next one ends
const settled = 60_000; // ms that a search may take to settle

/** In the page: moves the slider; resolves with ms until the first answer. */
async function paint([reflectance, patience]) {
  const slider = document.querySelector('.paint input[type="range"]');
  const { answered } = globalThis.__record;
  answered.length = 0;
  const isOwn = ({ askedAt }) => askedAt >= performance.timeOrigin + begun - 1; // not of the step before
  const begun = performance.now();
  slider.value = String(reflectance);
  slider.dispatchEvent(new Event('input', { bubbles: true }));
  while (!answered.some(isOwn)) {
    if (performance.now() - begun > 10_000) return Infinity;
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
  const { askedAt, postedAt } = answered.find(isOwn);
  await new Promise((resolve) => setTimeout(resolve, patience));
  return postedAt - askedAt;
}

/** ms of each step but the first, which finds out about the room what the others know. */
export async function repaintsOfOffice(root) {
  const isSettled = () => document.querySelector('.lamp.settled, .lamp.unmet') !== null;
  return served(root, (address) =>
    inBrowser(async (page) => {
      await page.addInitScript(recordWorkers);
      await page.goto(address);
      await page.waitForFunction(isSettled, null, { timeout: settled });
      await page.getByRole('tab', { name: 'Results' }).click();
      const choice = page.locator('.paint select');
      const walls = await choice.locator('option').allTextContents();
      await choice.selectOption({ label: walls.find((name) => /wall/i.test(name)) });
      const times = [];
      for (let i = 0; i <= steps; ++i)
        times.push(await page.evaluate(paint, [(i % 2 ? 0.3 : 0.6) + 0.005 * i, pause]));
      return times.slice(1);
    }),
  );
}

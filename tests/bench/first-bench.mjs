/**
 * How long a first visit takes on a line of 10 Mbit/s with 40 ms, nothing cached: from the navigation until the office is
 * seen in its light, and until a slider that is moved as soon as it is there has been answered.
 */
import path from 'node:path';
import { inBrowser, recordWorkers } from './drag-bench.mjs';
import { onSlowLine } from './slow-line.mjs';

const line = { bytesPerSecond: 10e6 / 8, delay: 40 };
const visits = 5;

/** ms since the navigation began, in the page. With reduced motion the light does not fade on: its first frame is full. */
async function visit(address) {
  const measured = async (page) => {
    await page.addInitScript(recordWorkers);
    await page.goto(address, { waitUntil: 'commit' });
    // The frame after the light was set shows it.
    const light = page.waitForFunction(
      () => performance.getEntriesByName('light set').length > 0 && performance.now(),
      null,
      { polling: 'raf', timeout: 120_000 },
    );
    const slider = page.getByRole('slider', { name: /: about$/ }).first();
    await slider.waitFor({ timeout: 120_000 });
    const before = await page.evaluate(() => globalThis.__record.asked.length);
    await slider.press('ArrowRight');
    const answer = await page.waitForFunction(
      (from) => {
        const { asked, answered } = globalThis.__record;
        const wish = asked[from];
        const found = wish && answered.find(({ revision }) => revision === wish.revision);
        return (
          found && {
            asked: wish.sentAt - performance.timeOrigin,
            at: found.postedAt - performance.timeOrigin,
          }
        );
      },
      before,
      { timeout: 120_000 },
    );
    return { light: await (await light).jsonValue(), answer: await answer.jsonValue() };
  };
  return inBrowser(measured, { reducedMotion: 'reduce' });
}

/** Of each visit: ms until lit, until answered, and when the slider was moved. */
export async function firstVisits(root) {
  return onSlowLine({ folder: path.join(root, 'dist'), ...line }, async (address) => {
    const seen = [];
    for (let i = 0; i < visits; ++i) {
      const { light, answer } = await visit(address);
      seen.push({ light, answer: answer.at, asked: answer.asked });
    }
    return seen;
  });
}

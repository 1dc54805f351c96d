/**
 * The built app in Chromium: how long from the drop of a photometric file on the office until the worker has posted the
 * light of its luminaires on the places of the layout (`picture`), and the first layout of a search among all of them
 * (`layout`). Each drop is of another file, a panel by another name, for a known one is not computed again. The office
 * opens with panels: what is dropped beside them has 260 candidates of its own.
 */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { inBrowser, served } from './drag-bench.mjs';

const drops = 20;
const settled = 60_000; // ms that a search may take to settle

/** In the page, before its scripts: every Worker writes down what it answers about luminaires of types. */
function recordTypes() {
  const record = (globalThis.__types = { answers: [], settled: 0 });
  globalThis.Worker = class extends Worker {
    constructor(...args) {
      super(...args);
      this.addEventListener('message', ({ data: { type, shown, postedAt, evaluations } }) => {
        if (type === 'settled') record.settled += 1;
        if (type !== 'improved' && type !== 'settled') return;
        if (shown.layout.mountings)
          record.answers.push({ at: postedAt - performance.timeOrigin, evaluations });
      });
    }
  };
}

/** ms from a drop to the light of one layout and to the first of the search. */
async function drop(page, name, text) {
  const begun = await page.evaluate(
    ([file, contents]) => {
      const data = new DataTransfer();
      data.items.add(new File([contents], file));
      globalThis.__types.answers.length = globalThis.__types.settled = 0;
      const at = performance.now();
      for (const type of ['dragenter', 'dragover', 'drop']) {
        const event = new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true });
        document.querySelector('main').dispatchEvent(event);
      }
      return at;
    },
    [name, text],
  );
  await page.waitForFunction(() => globalThis.__types.settled > 0, null, { timeout: settled });
  const answers = await page.evaluate(() => globalThis.__types.answers);
  const isSearched = ({ evaluations }) => evaluations > 1;
  return {
    picture: (answers[0]?.at ?? Infinity) - begun,
    layout: (answers.find(isSearched)?.at ?? Infinity) - begun,
  };
}

/** Of each drop; the first one finds out about the places what the others know. */
export async function dropsOnOffice(root) {
  const panel = readFileSync(path.join(root, 'public/luminaires/panel.ldt'), 'latin1');
  return served(root, (address) =>
    inBrowser(async (page) => {
      await page.addInitScript(recordTypes);
      await page.goto(address);
      await page.waitForFunction(() => globalThis.__types.settled > 0, null, { timeout: settled });
      const times = [];
      for (let i = 0; i < drops; ++i) {
        times.push(await drop(page, `panel-${i}.ldt`, panel.replace('Panel 600', `Panel ${i}`)));
        await page.evaluate(() => (globalThis.__types.answers.length = 0));
        await page.keyboard.press('Control+z');
        await page.waitForFunction(() => globalThis.__types.answers.length > 0, null, { timeout: settled });
      }
      return times;
    }),
  );
}

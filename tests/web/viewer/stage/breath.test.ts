/** A long work lets other tasks in between its pieces, a short one ends in its own. */
import { expect, test } from '@jest/globals';
import { breaths } from '../../../../web/viewer/stage/breath.ts';

const busy = (ms: number) => {
  for (const end = performance.now() + ms; performance.now() < end;);
};

test('a young task goes on at once, an old one lets others in and is young again', async () => {
  const rested = breaths();
  expect(rested()).toBeUndefined();
  busy(10);
  let others = 0;
  setTimeout(() => others++);
  await rested();
  expect(others).toBe(1);
  expect(rested()).toBeUndefined();
});

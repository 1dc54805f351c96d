import { beforeEach, expect, test } from '@jest/globals';
import { FrameLoop } from '../../../../web/viewer/stage/frame-loop.ts';

let waiting = new Map<number, FrameRequestCallback>();

beforeEach(() => {
  waiting = new Map();
  let last = 0;
  globalThis.requestAnimationFrame = (action) => (waiting.set(++last, action), last);
  globalThis.cancelAnimationFrame = (id) => void waiting.delete(id);
});

test('a flush draws at once, in place of the frame that was waiting', () => {
  let drawn = 0;
  const loop = new FrameLoop(() => void drawn++);
  loop.invalidate();
  loop.flush();
  expect(drawn).toBe(1);
  expect(waiting.size).toBe(0);
  loop.invalidate();
  expect(waiting.size).toBe(1);
  loop.suspend();
  loop.flush();
  expect(drawn).toBe(1);
});

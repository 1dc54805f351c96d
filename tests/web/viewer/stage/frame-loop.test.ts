import { beforeEach, expect, test } from '@jest/globals';
import { FrameLoop } from '../../../../web/viewer/stage/frame-loop.ts';

let waiting = new Map<number, FrameRequestCallback>();

beforeEach(() => {
  waiting = new Map();
  let last = 0;
  globalThis.requestAnimationFrame = (action) => (waiting.set(++last, action), last);
  globalThis.cancelAnimationFrame = (id) => void waiting.delete(id);
});

/** The browser comes to the one frame that is waited for. */
function frame(): void {
  const [[id, action]] = [...waiting] as [[number, FrameRequestCallback]];
  waiting.delete(id);
  action(0);
}

test('what an animation does unseen is not drawn, unless something else changed', () => {
  let drawn = 0;
  const loop = new FrameLoop(() => void drawn++);
  const answers = ['unseen', true, 'unseen', 'unseen', false] as const;
  let next = 0;
  loop.animate(() => answers[next++]!);
  const after: number[] = [];
  for (let i = 0; i < answers.length; ++i) {
    if (i === 3) loop.invalidate();
    frame();
    after.push(drawn);
  }
  expect(after).toEqual([1, 2, 2, 3, 4]); // what was there before the first is drawn with it
  expect(waiting.size).toBe(0);
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

test('a frame that is left to the page is drawn one later, a flush is not', () => {
  let drawn = 0;
  const loop = new FrameLoop(() => void drawn++);
  loop.invalidate();
  loop.standBack();
  frame();
  expect(drawn).toBe(0);
  frame();
  expect(drawn).toBe(1);
  loop.standBack();
  loop.flush();
  expect(drawn).toBe(2);
  loop.invalidate();
  frame();
  expect(drawn).toBe(3);
});

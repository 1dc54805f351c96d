/** What is drawn when: with the event of a person, after the task of anything else. */
import { afterEach, expect, test } from '@jest/globals';
import { createRenderTasks } from '../../../web/panel/render-tasks.ts';

const globals = globalThis as { event?: Event };
afterEach(() => void delete globals.event);

const nextTask = () => new Promise((resolve) => setTimeout(resolve, 20));

/** What of two renderings has happened when the microtasks of this task are over, and what later. */
async function drawn(event?: Event): Promise<string[][]> {
  const done: string[] = [];
  const channel = new MessageChannel();
  const render = createRenderTasks(new EventTarget(), undefined, channel);
  if (event) globals.event = event;
  render(() => void done.push('first'));
  render(() => void done.push('second'));
  await Promise.resolve();
  const soon = [...done];
  await nextTask();
  channel.port1.close();
  return [soon, done];
}

test('what a frame has changed is drawn in a later task, in order', async () => {
  expect(await drawn()).toEqual([[], ['first', 'second']]);
});

test('so is what a worker has told', async () => {
  expect(await drawn(new MessageEvent('message'))).toEqual([[], ['first', 'second']]);
});

test('what a person does is answered before the next event', async () => {
  expect(await drawn(new Event('input'))).toEqual([
    ['first', 'second'],
    ['first', 'second'],
  ]);
});

test('a person finds drawn what was waiting', async () => {
  const [page, channel, done] = [new EventTarget(), new MessageChannel(), [] as string[]];
  const render = createRenderTasks(page, undefined, channel);
  render(() => void done.push('first'));
  render(() => void done.push('second'));
  page.dispatchEvent(new Event('keydown'));
  expect(done).toEqual(['first', 'second']);
  await nextTask();
  channel.port1.close();
  expect(done).toEqual(['first', 'second']);
});

test('what takes long in a task of its own is told, not what a person waits for', async () => {
  const [page, channel, told] = [new EventTarget(), new MessageChannel(), [] as string[]];
  let doing = '';
  const render = createRenderTasks(page, () => void told.push(doing), channel);
  const taking = (ms: number, name: string) => () => {
    const end = performance.now() + ms;
    while (performance.now() < end);
    doing = name;
  };
  render(taking(20, 'much'));
  render(taking(0, 'little'));
  await nextTask();
  expect(told).toEqual(['much']);
  render(taking(20, 'asked for'));
  page.dispatchEvent(new Event('keydown'));
  await nextTask();
  channel.port1.close();
  expect([doing, told]).toEqual(['asked for', ['much']]);
});

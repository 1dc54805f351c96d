/** A game against the solver: who goes first, what counts, and what goes into a link. Covers challenge-card. */
import { beforeEach, expect, jest, test } from '@jest/globals';
import { App } from '../../../web/app/app.ts';
import { Store } from '../../../web/app/state/store.ts';
import { fakeHost } from '../fake-host.ts';
import { FakeSolver } from '../fake-solver.ts';
import { fakeViewer } from '../fake-viewer.ts';

let solver: FakeSolver;
let app: App;
let frames: (() => void)[];

async function settle(): Promise<void> {
  for (let round = 0; round < 4; round++) {
    jest.advanceTimersByTime(4000);
    solver.flush();
    await new Promise((resolve) => setImmediate(resolve));
    frames.splice(0).forEach((draw) => draw());
  }
}

beforeEach(async () => {
  jest.useFakeTimers({ doNotFake: ['setImmediate', 'queueMicrotask'] });
  frames = [];
  fakeHost();
  globalThis.requestAnimationFrame = (draw) => frames.push(() => draw(0));
  app = new App(new Store(), {
    canvas: null as unknown as HTMLCanvasElement,
    labels: null as unknown as HTMLElement,
    createViewer: fakeViewer().create,
    createWorker: () => (solver = new FakeSolver()),
  });
  const opening = app.opening.files([new File([new Uint8Array(4)], 'room.flux')]);
  await settle();
  await opening;
  app.addCard('illuminate', ['floor']);
  await settle();
  void app.challenge.start();
  expect(app.challenge.stage.value).toBe('solving');
  await settle();
});

test('six luminaires are scattered, all of them by hand, and scored against the solver’s', () => {
  const { luminaires } = app.store.document.value;
  expect([luminaires.count, luminaires.pinned.length, luminaires.minDistance]).toEqual([6, 6, 0]);
  expect(app.challenge.stage.value).toBe('playing');
  const { goals } = app.store.shown.value!;
  const standing = app.challenge.standing.value!;
  expect(standing.score).toBeGreaterThan(0);
  expect(goals).toHaveLength(app.store.traced.value.intentions.goals.length);
  expect(app.store.score.value).toBe(Math.round(standing.score));
  expect(app.variants.isThere('best')).toBe(true);
});

test('a luminaire in the hand changes the score at once; help of the solver does not count', async () => {
  const before = app.challenge.standing.value!.score;
  const taken = app.store.shown.value!.layout.sites;
  const free = Array.from({ length: 16 }, (_, site) => site).filter((site) => !taken.includes(site));
  let isChanged = false;
  for (const site of free) {
    app.hand.moveTo(0, site, true);
    await settle();
    isChanged ||= app.challenge.standing.value!.score !== before;
  }
  expect(isChanged).toBe(true);
  app.hand.unpinAll();
  await settle();
  expect([app.challenge.standing.value, app.store.score.value]).toEqual([null, null]);
});

test('ends with the layout as it is, or with another room', async () => {
  const { sites } = app.store.shown.value!.layout;
  app.challenge.end();
  expect([app.challenge.stage.value, app.store.score.value]).toEqual([null, null]);
  expect(app.store.shown.value!.layout.sites).toEqual(sites);
});

test('a score that came with a link is told, and played against', async () => {
  app.challenge.end();
  app.store.sentScore.value = 87;
  const message = app.store.messages.value.at(-1)!;
  expect(message.text).toMatch(/^Placed by hand: 87 points, the sender says/);
  message.action!.run();
  expect(app.challenge.stage.value).toBe('solving');
});

test('but not in a page that it is embedded in', () => {
  const before = app.store.messages.value.length;
  Object.defineProperty(globalThis, 'location', { value: { search: '?embed' }, configurable: true });
  try {
    app.store.sentScore.value = 87;
  } finally {
    Reflect.deleteProperty(globalThis, 'location');
  }
  expect(app.store.messages.value).toHaveLength(before);
  expect(app.store.sentScore.value).toBeNull();
});

/** The proof by pairs in a worker of its own (web/solver/pair-proof.ts, pair-worker.ts): its code on the module as it was built. */
import { readFileSync } from 'node:fs';
import { afterAll, beforeAll, expect, jest, test } from '@jest/globals';
import { coreIntentions } from '../../web/solver/core-intentions.ts';
import { proveAside, type Proved } from '../../web/solver/pair-proof.ts';
import { bytesOf, loadBuiltCore, openFile, syntheticFile } from './solver-module.ts';

const realFetch = globalThis.fetch;
const scope: { postMessage: (proved: Proved) => void; onmessage?: (event: { data: Float64Array }) => void } =
  {
    postMessage: () => {},
  };
/** What the page starts instead of a thread: the worker's own code, in this one. */
class WorkerHere {
  onmessage: ((event: { data: Proved }) => void) | null = null;
  onerror: ((event: { preventDefault: () => void }) => void) | null = null;
  terminate = jest.fn(() => {
    scope.postMessage = () => {};
    for (const port of turns.splice(0)) port.close();
  });
  constructor(readonly address: URL) {
    started.push(this);
  }
  postMessage(pairs: Float64Array, moved: ArrayBuffer[]) {
    expect(moved).toEqual([pairs.buffer]);
    scope.postMessage = (data) => this.onmessage?.({ data });
    scope.onmessage?.({ data: pairs });
  }
}
let started: WorkerHere[] = [];
/** Turns of the worker: they end with it, as with a thread, or the process would wait for them. */
const turns: MessagePort[] = [];
class Turns extends MessageChannel {
  constructor() {
    super();
    turns.push(this.port1, this.port2);
  }
}

const core = await loadBuiltCore();
const session = new core.Session();

beforeAll(async () => {
  const wasm = readFileSync(new URL('../../web/solver/core.wasm', import.meta.url));
  const headers = { 'content-type': 'application/wasm' };
  globalThis.fetch = () => Promise.resolve(new Response(wasm, { headers }));
  Object.assign(globalThis, { self: scope, Worker: WorkerHere, MessageChannel: Turns });
  await import('../../web/solver/pair-worker.ts');
  openFile(session, bytesOf(syntheticFile()));
});
afterAll(() => {
  session.delete();
  for (const port of turns) port.close();
  globalThis.fetch = realFetch;
});

function pairsOfABound() {
  const asked = {
    quantity: 'illuminance',
    luminaires: { count: 3, flux: 1000, dimming: [1, 1], pinned: [], excluded: [], minDistance: 0 },
    goals: [{ statistic: 'sigma', sense: 'min', weight: 1, surfaces: ['all'] }],
    constraints: [],
  } as const;
  expect(session.setIntentions(coreIntentions(asked, session.info()?.surfaces ?? []))).toBe('');
  expect(session.start(1)).toBe('');
  const { goal } = session.advance(50_000);
  expect(session.startBound()).toBe('');
  return { goal, pairs: session.takePairs() };
}

/** A thread would not come to its first turn after its end; here that turn is waited for and closed. */
async function neverTurns() {
  while (turns.length === 0) await new Promise((resolve) => setTimeout(resolve, 5));
  for (const port of turns.splice(0)) port.close();
}

const provedBy = (pairs: Float64Array) =>
  new Promise<Proved[]>((resolve) => {
    const told: Proved[] = [];
    proveAside(pairs, (proved) => {
      told.push(proved);
      if (proved.done) resolve(told);
    });
  });

test('tells what is proved whenever that is more, never above the best layout, and ends', async () => {
  const { goal, pairs } = pairsOfABound();
  started = [];
  const goals = (await provedBy(pairs)).map((proved) => proved.goal);
  expect(goals).toEqual([...goals].sort((a, b) => a - b));
  expect(goals.at(-1)).toBeLessThanOrEqual(goal);
  expect(goals.at(-1)).toBeGreaterThan(0.7 * goal);
  expect(started[0]?.terminate).toHaveBeenCalledTimes(1);
}, 60_000);

test('numbers that are no pairs, or a worker that breaks, prove nothing', async () => {
  started = [];
  expect(await provedBy(Float64Array.of(7))).toEqual([{ goal: -Infinity, done: true }]);
  const told: Proved[] = [];
  proveAside(pairsOfABound().pairs, (proved) => void told.push(proved));
  const held = { preventDefault: jest.fn() };
  started[1]?.onerror?.(held);
  expect(told).toEqual([{ goal: -Infinity, done: true }]);
  expect(held.preventDefault).toHaveBeenCalled();
  expect(started.map(({ terminate }) => terminate.mock.calls.length)).toEqual([1, 1]);
  await neverTurns();
});

test('nothing is told after it was ended', async () => {
  started = [];
  const told: Proved[] = [];
  proveAside(pairsOfABound().pairs, (proved) => void told.push(proved))();
  expect(started[0]?.terminate).toHaveBeenCalled();
  await neverTurns();
  expect(told).toEqual([]);
});

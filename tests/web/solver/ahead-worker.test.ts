// A worker that opens a file before anybody asks: its answers wait for whoever opens those very bytes.
import { beforeEach, expect, test } from '@jest/globals';
import { AheadWorker, type RawWorker } from '../../../web/solver/ahead-worker.ts';
import { WorkerEnded } from '../../../web/solver/worker-ended.ts';
import type { AheadRequest, FetchedAhead, FromWorker, ToWorker } from '../../../web/solver/protocol.ts';

let sent: (ToWorker | AheadRequest)[];
let raw: RawWorker;
let deaths: number;
let heard: FromWorker[];

const say = (data: FromWorker | FetchedAhead) => raw.onmessage?.({ data } as MessageEvent);
const room = { type: 'room', revision: 0, room: new ArrayBuffer(1) } as const;
const opened = { type: 'opened', revision: 0, scene: {} } as unknown as FromWorker;

function start(): AheadWorker {
  raw = {
    postMessage: (message) => void sent.push(message),
    terminate: () => {},
    onmessage: null,
    onerror: null,
    onmessageerror: null,
  };
  return new AheadWorker(raw, 'scenes/box.flux', () => void deaths++);
}

beforeEach(() => {
  sent = [];
  heard = [];
  deaths = 0;
});

test('asks for the file at once and answers under the revision that adopts it, in order', async () => {
  const worker = start();
  expect(sent).toEqual([{ type: 'fetch', address: 'scenes/box.flux' }]);
  worker.onmessage = ({ data }) => void heard.push(data);
  say({ type: 'ready' });
  say({ type: 'begun', isThere: true });
  say(room);
  expect(heard).toEqual([{ type: 'ready' }]);
  await worker.begun;
  expect(worker.adopt(worker.bytes, 3)).toBe(true); // its last bytes are still on their way
  expect(heard.slice(1)).toEqual([{ ...room, revision: 3 }]);
  say(opened);
  expect(heard.at(-1)).toEqual({ ...opened, revision: 3 });
  const late = { type: 'failed', revision: 4, message: 'other', fatal: false } as const;
  say(late);
  expect(heard.at(-1)).toEqual(late);
  say({ type: 'fetched', bytes: new ArrayBuffer(8) });
  expect((await worker.bytes).byteLength).toBe(8);
  expect(worker.adopt(worker.bytes, 5)).toBe(false); // a second opening is one of its own
  expect(sent).toHaveLength(1);
});

test('says nothing of its file where another one is opened', async () => {
  const worker = start();
  worker.onmessage = ({ data }) => void heard.push(data);
  say(room);
  expect(worker.adopt(new ArrayBuffer(8), 1)).toBe(false);
  expect(sent.at(-1)).toEqual({ type: 'abandon' });
  say(opened);
  expect(heard).toEqual([]);
});

test('where the file cannot be had, or the worker dies, its bytes reject and say which', async () => {
  const worker = start();
  say({ type: 'begun', isThere: false });
  await expect(worker.begun).rejects.toThrow();
  const cut = start();
  say({ type: 'begun', isThere: true });
  say({ type: 'fetched', bytes: null });
  await cut.begun;
  await expect(cut.bytes).rejects.not.toBeInstanceOf(WorkerEnded);
  const other = start();
  raw.onerror?.({ message: 'Uncaught Error: core.wasm is old' } as ErrorEvent);
  await expect(other.bytes).rejects.toThrow(new WorkerEnded('Uncaught Error: core.wasm is old'));
  await expect(other.bytes).rejects.toBeInstanceOf(WorkerEnded);
  expect(deaths).toBe(1);
});

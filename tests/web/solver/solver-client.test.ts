/** Latest wins on the page's side, and a new worker where the old one dies. */
import type { SceneInfo } from '../../../web/document/types.ts';
import { beforeEach, describe, expect, test } from '@jest/globals';
import type { FromWorker, Seen, ToWorker } from '../../../web/solver/protocol.ts';
import { SolverClient, type WorkerLike } from '../../../web/solver/solver-client.ts';
import { WorkerEnded } from '../../../web/solver/worker-ended.ts';
import type { PhotometricDescription } from '../../../web/document/photometry.ts';
import { described as sample } from '../described.ts';
import { asked } from './fake-session.ts';

class FakeWorker implements WorkerLike {
  readonly sent: ToWorker[] = [];
  terminated = false;
  onmessage: WorkerLike['onmessage'] = null;
  onerror: WorkerLike['onerror'] = null;
  onmessageerror: WorkerLike['onmessageerror'] = null;
  postMessage(message: ToWorker, transfer: Transferable[]) {
    this.sent.push(structuredClone(message, { transfer: transfer as ArrayBuffer[] }));
  }
  terminate() {
    this.terminated = true;
  }
  answer(data: FromWorker) {
    this.onmessage?.({ data } as MessageEvent<FromWorker>);
  }
  die(message: string) {
    this.onerror?.({ message, preventDefault: () => undefined } as ErrorEvent);
  }
}

let workers: FakeWorker[];
let received: FromWorker[];
let client: SolverClient;
const worker = () => workers.at(-1) as FakeWorker;
const layout = { sites: [0], flux: [1], dimming: 1 };
const file = () => Uint8Array.of(1, 2, 3).buffer;
const opened = (revision: number): FromWorker => ({
  type: 'opened',
  revision,
  scene: {} as SceneInfo,
  light: null,
});
const bounded = (revision: number): FromWorker => ({
  type: 'bounded',
  revision,
  bound: 1,
  gap: 0,
  done: true,
});
const failed = (revision: number): FromWorker => ({ type: 'failed', revision, message: 'no', fatal: false });

beforeEach(() => {
  workers = [];
  received = [];
  client = new SolverClient(
    () => {
      workers.push(new FakeWorker());
      return worker();
    },
    (message) => received.push(message),
  );
});

describe('a file that is still arriving', () => {
  test('is opened when all of it is there, by a worker that is not opening it already', async () => {
    const revision = client.open(Promise.resolve(file()));
    expect(worker().sent).toEqual([]);
    await Promise.resolve();
    expect(worker().sent).toMatchObject([{ type: 'open', revision }]);
  });

  test('is not opened any more where another one was asked for meanwhile', async () => {
    client.open(Promise.resolve(file()));
    const newer = client.open(file());
    await Promise.resolve();
    expect(worker().sent).toMatchObject([{ type: 'open', revision: newer }]);
  });

  test('and does not arrive fails, before or after it was told of', async () => {
    const lost = client.open(Promise.reject(new Error('gone')));
    await new Promise((resolve) => setTimeout(resolve));
    expect(received.at(-1)).toMatchObject({ type: 'failed', revision: lost });
    expect(received.at(-1)).toMatchObject({ message: expect.stringContaining('the connection was lost') });
    client.open(Promise.reject(new WorkerEnded('Uncaught Error: core.wasm is old')));
    await new Promise((resolve) => setTimeout(resolve));
    const message = 'the room could not be loaded: the solver stopped (core.wasm is old); try again';
    expect(received.at(-1)).toMatchObject({ message });
    const told = client.open(file());
    worker().answer(opened(told));
    worker().answer(failed(told));
    expect(received.at(-1)).toEqual(failed(told));
  });
});

describe('latest wins', () => {
  test('of two files, only the newer one shows its room', () => {
    const older = client.open(file());
    const newer = client.open(file());
    const room = new ArrayBuffer(0);
    for (const revision of [older, newer])
      worker().onmessage?.({ data: { type: 'room', revision, room } } as MessageEvent<FromWorker>);
    expect(received).toMatchObject([{ type: 'room', revision: newer }]);
  });

  test('answers to superseded wishes are dropped', () => {
    const first = client.solve(asked, null, 1, 0);
    const second = client.solve(asked, null, 1, 0);
    worker().answer(failed(first));
    worker().answer(failed(second));
    expect(received).toEqual([failed(second)]);
  });

  test('a bound lives beside the search that it belongs to, not beyond it', () => {
    const solve = client.solve(asked, null, 1, 0);
    const bound = client.bound(asked);
    worker().answer(bounded(bound));
    worker().answer(failed(solve));
    client.show(asked, layout);
    worker().answer(bounded(bound));
    expect(received).toEqual([bounded(bound), failed(solve)]);
  });

  test('another file makes every older answer stale', () => {
    const solve = client.solve(asked, null, 1, 0);
    const first = client.open(file());
    const second = client.open(file());
    for (const revision of [solve, first]) worker().answer(failed(revision));
    worker().answer(opened(second));
    expect(received).toEqual([opened(second)]);
  });
});

describe('the search that a bound or a check is about', () => {
  const last = () => worker().sent.at(-1);

  test('is the latest one for the very same intentions', () => {
    const solve = client.solve(asked, null, 1, 0);
    client.bound(asked);
    expect(last()).toMatchObject({ type: 'bound', search: solve });
    client.stop();
    client.check(asked, layout);
    expect(last()).toMatchObject({ type: 'check', search: solve });
    client.check({ ...asked, goals: [] }, layout);
    expect(last()).toMatchObject({ type: 'check', search: null });
  });

  test.each([
    ['a layout that is only shown', () => client.show(asked, layout)],
    ['an alpha-search', () => client.alpha(asked, 1, null)],
    ['another file', () => client.open(file())],
  ])('is gone after %s', (_, request) => {
    client.solve(asked, null, 1, 0);
    request();
    client.bound(asked);
    expect(last()).toMatchObject({ type: 'bound', search: null });
  });
});

describe('a worker that cannot be had', () => {
  const blocked = () => worker().onerror?.({ preventDefault: () => undefined } as ErrorEvent);

  test('is told without its reason, and another file is another try', () => {
    for (let death = 0; death < 3; death++) blocked();
    expect(received).toMatchObject([
      { type: 'failed', fatal: true, message: expect.stringContaining('its script cannot be loaded') },
    ]);
    expect(workers).toHaveLength(3);
    const revision = client.open(file());
    expect(workers).toHaveLength(4);
    expect(worker().sent).toMatchObject([{ type: 'open', revision }]);
    blocked();
    expect(received).toHaveLength(2);
    expect(received[1]).toMatchObject({ type: 'failed', fatal: true });
    client.open(file());
    worker().answer(opened(client.open(file())));
    expect(received.at(-1)).toMatchObject({ type: 'opened' });
  });
});

describe('a worker that dies', () => {
  test('is replaced; file and wish are sent again, and the page sees no second "opened"', () => {
    const revision = client.open(file());
    worker().answer(opened(revision));
    const solve = client.solve(asked, layout, 1, 0);
    worker().die('out of memory');
    expect(workers).toHaveLength(2);
    expect(workers[0]?.terminated).toBe(true);
    expect(worker().sent).toMatchObject([
      { type: 'open', revision, bytes: file() },
      { type: 'solve', revision: solve },
    ]);
    worker().answer(opened(revision));
    worker().answer(failed(solve));
    expect(received).toEqual([opened(revision), failed(solve)]);
  });

  test('keeps the room that was open where a later file was refused', () => {
    const good = client.open(file());
    worker().answer(opened(good));
    const bad = client.open(Uint8Array.of(9).buffer);
    worker().answer(failed(bad));
    worker().die('gone');
    expect(worker().sent).toMatchObject([{ type: 'open', revision: good }]);
  });

  test('again and again without an answer is said, not retried for ever', () => {
    for (let i = 0; i < 3; ++i) worker().die('no memory');
    expect(workers).toHaveLength(3);
    expect(received).toMatchObject([
      { type: 'failed', fatal: true, message: expect.stringContaining('reload the page') },
    ]);
  });

  test('again and again is said where the room had not all arrived, too: that it is lost is no answer of a worker', async () => {
    const arriving = Promise.reject(new WorkerEnded('no memory'));
    const revision = client.open(arriving);
    worker().answer(opened(revision));
    for (let i = 0; i < 3; ++i) {
      worker().die('no memory');
      await new Promise((resolve) => setTimeout(resolve));
    }
    expect(workers).toHaveLength(3);
    expect(received.at(-1)).toMatchObject({ type: 'failed', fatal: true });
  });

  test('is told in its own words, without those of the browser', () => {
    for (let i = 0; i < 3; ++i) worker().die('Uncaught Error: core.wasm does not fit this page');
    const message = 'the solver stopped (core.wasm does not fit this page); reload the page to go on';
    expect(received).toMatchObject([{ type: 'failed', message }]);
  });
});

describe('a photometric file', () => {
  const described = (revision: number, description: PhotometricDescription | string): FromWorker => ({
    type: 'described',
    revision,
    description,
  });
  const revisionOf = (at: number) => {
    const message = worker().sent[at];
    return message?.type === 'describe' ? message.revision : -1;
  };

  test('each is told to whoever asked, in whatever order, and the bytes stay', async () => {
    const bytes = Uint8Array.of(7, 8);
    const [one, other] = [client.describe(bytes), client.describe(Uint8Array.of(9))];
    worker().answer(described(revisionOf(1), 'this is a picture'));
    worker().answer(described(revisionOf(0), sample(5)));
    await expect(one).resolves.toMatchObject({ maxCandela: 5 });
    await expect(other).rejects.toThrow('this is a picture');
    expect([...bytes]).toEqual([7, 8]);
    expect(received).toEqual([]);
  });

  test('of which the worker dies is told of', async () => {
    const reading = client.describe(Uint8Array.of(7));
    worker().die('out of memory');
    await expect(reading).rejects.toThrow(/stopped while it read the file/);
  });
});

describe('the light of another layout', () => {
  const readings = (revision: number, shown: Seen | string): FromWorker => ({
    type: 'readings',
    revision,
    shown,
  });

  test('comes to whoever asked for it, whatever is asked since; what cannot hang is one line', async () => {
    const [one, other] = [client.read(asked, layout), client.read(asked, { ...layout, sites: [9] })];
    const [first, second] = worker().sent.flatMap((message) =>
      message.type === 'read' ? message.revision : [],
    );
    client.solve(asked, null, 1, 0);
    worker().answer(readings(second!, 'there is no site 9'));
    worker().answer(readings(first!, { goal: 7 } as Seen));
    await expect(one).resolves.toEqual({ goal: 7 });
    await expect(other).rejects.toThrow('there is no site 9');
    expect(received).toEqual([]);
  });

  test('of a room that is left is not waited for', async () => {
    const reading = client.read(asked, layout);
    client.open(file());
    await expect(reading).rejects.toThrow('another room');
  });
});

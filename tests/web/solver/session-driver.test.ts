/**
 * Messages in, answers out: the protocol, latest wins, pace.
 * Covers search-job, search-task, alpha-task, bound-task, pair-proof, compare-task, core-intentions, mounts, painted-session.
 */
import { beforeEach, describe, expect, test } from '@jest/globals';
import type { FromWorker, ToWorker } from '../../../web/solver/protocol.ts';
import { pace } from '../../../web/solver/pacing.ts';
import type { Proved } from '../../../web/solver/pair-proof.ts';
import { ArrivingFile } from '../../../web/solver/scene-stream.ts';
import { SessionDriver } from '../../../web/solver/session-driver.ts';
import { asked, FakeCandidates, FakeClock, FakeColoredLight, FakeSession } from './fake-session.ts';
import type { Intentions, LuminaireType } from '../../../web/document/types.ts';
import { described } from '../described.ts';
import { outlineOf } from '../../../web/document/areas.ts';
import { luminaireType } from '../document/luminaire-type.ts';

/** Reads files of one byte: their luminous intensity. */
const reader = {
  describePhotometry: (file: Uint8Array) =>
    file[0]
      ? described(file[0], { luminous: { length: file[0] > 100 ? 9 : 0, width: 0, height: 0, round: false } })
      : 'the file is empty; fetch it again',
  Session: class {
    constructor() {
      return (mounted = new FakeSession(clock));
    }
  } as unknown as new () => FakeSession,
  Candidates: FakeCandidates,
  ColoredLight: FakeColoredLight,
};

let mounted: FakeSession; // the latest session of candidates
let clock: FakeClock;
let session: FakeSession;
let driver: SessionDriver;
let answers: FromWorker[];
let transferred: Transferable[];
let proofs: { pairs: Float64Array; tell: (proved: Proved) => void; isEnded: boolean }[];
let woken: number; // times that the driver had work without a message

beforeEach(() => {
  clock = new FakeClock();
  session = new FakeSession(clock);
  answers = [];
  transferred = [];
  woken = 0;
  proofs = [];
  driver = new SessionDriver(
    reader,
    session,
    (message, transfer) => {
      answers.push(message);
      transferred.push(...transfer);
    },
    clock.read,
    () => ++woken,
    (pairs, tell) => {
      const proof = { pairs, tell, isEnded: false };
      proofs.push(proof);
      return () => void (proof.isEnded = true);
    },
  );
});

const open = (revision: number, ...bytes: number[]): ToWorker => ({
  type: 'open',
  revision,
  bytes: Uint8Array.from(bytes).buffer,
});
const solve = (revision: number, more: Partial<Extract<ToWorker, { type: 'solve' }>> = {}): ToWorker => ({
  type: 'solve',
  revision,
  intentions: asked,
  start: null,
  moved: [],
  seed: 3,
  askedAt: clock.now,
  ...more,
});
const settle = () => {
  while (driver.busy) driver.step();
};
const kinds = () => answers.map((answer) => `${answer.type} ${'revision' in answer ? answer.revision : ''}`);

async function opened(): Promise<void> {
  await driver.receive(open(1, 1, 7));
  answers.length = transferred.length = 0;
}

describe('open', () => {
  test('transfers the room, then answers with the scene', async () => {
    await driver.receive(open(1, 1, 7));
    expect(answers).toMatchObject([
      { type: 'room', revision: 1 },
      { type: 'opened', revision: 1, scene: { patches: 2, provenance: null } },
    ]);
    expect(transferred).toHaveLength(1);
  });

  test('of a file that is still arriving is told early; requests wait for the rest', async () => {
    let close = () => {};
    const body = new ReadableStream<Uint8Array>({
      start: (controller) => {
        controller.enqueue(new Uint8Array(64));
        close = () => controller.close();
      },
    });
    session.lateAt = 100;
    const opening = driver.open(4, new ArrivingFile(body));
    while (answers.length < 2) await new Promise((resolve) => setTimeout(resolve, 1));
    expect(answers).toMatchObject([
      { type: 'room', revision: 4 },
      { type: 'opened', revision: 4, light: { layout: { sites: [1] } } },
    ]);
    await driver.receive(solve(5));
    expect(driver.busy).toBe(false);
    close();
    await opening;
    expect(answers.at(-1)).toMatchObject({ type: 'failed', revision: 4 }); // it ended too early
    expect(driver.busy).toBe(false);
    const { message } = answers.at(-1) as { message: string };
    await driver.receive(solve(6));
    driver.step();
    expect(answers.at(-1)).toMatchObject({ type: 'failed', revision: 6, message }); // the same, not another riddle
  });

  test('a wish that came meanwhile is begun before what only luminaire types need is there', async () => {
    const body = new ReadableStream<Uint8Array>({
      start: (controller) => controller.enqueue(new Uint8Array(64)), // and no end
    });
    session.operatorAt = 100;
    void driver.open(4, new ArrivingFile(body));
    await driver.receive(solve(5));
    expect(driver.busy).toBe(false);
    while (woken === 0) await new Promise((resolve) => setTimeout(resolve, 1));
    driver.step();
    expect(kinds()).toEqual(['room 4', 'opened 4', 'improved 5']);
  });

  test('the latest of several files wins; the others are not answered', async () => {
    await Promise.all([
      driver.receive(open(1, 1, 7)),
      driver.receive(open(2, 1, 7)),
      driver.receive(open(3, 1, 7)),
    ]);
    expect(kinds()).toEqual(['room 3', 'opened 3']);
  });

  test('a file that is refused leaves the scene that was open', async () => {
    await opened();
    await driver.receive(open(2, 0));
    await driver.receive(solve(3));
    driver.step();
    expect(kinds()).toEqual(['failed 2', 'improved 3']);
  });

  test('requests that come meanwhile wait for it', async () => {
    const opening = driver.receive(open(1, 1, 7));
    await driver.receive(solve(2));
    expect(driver.busy).toBe(false);
    await opening;
    driver.step();
    expect(kinds()).toEqual(['room 1', 'opened 1', 'improved 2']);
  });
});

describe('solve', () => {
  test('without a scene is refused', async () => {
    await driver.receive(solve(1));
    driver.step();
    expect(answers).toMatchObject([
      { type: 'failed', revision: 1, message: expect.stringContaining('no scene') },
    ]);
    expect(driver.busy).toBe(false);
  });

  test('an unknown surface is refused by name', async () => {
    await opened();
    const goal = { statistic: 'sigma', sense: 'min', weight: 1, surfaces: ['roof'] } as const;
    await driver.receive(solve(2, { intentions: { ...asked, goals: [goal] } }));
    driver.step();
    expect(answers).toMatchObject([{ type: 'failed', message: expect.stringContaining('"roof"') }]);
  });

  test('answers at once, with everything that is shown, and echoes askedAt', async () => {
    await opened();
    await driver.receive(solve(2, { askedAt: 123.5 }));
    driver.step();
    expect(answers).toMatchObject([
      {
        type: 'improved',
        revision: 2,
        askedAt: 123.5,
        evaluations: pace.firstEvaluations,
        shown: {
          layout: {
            sites: [0, 1],
            flux: [100, 100],
            dimming: 1,
          },
          surfaces: [
            {
              name: 'floor',
              mean: 0,
              max: 3,
            },
            { name: 'plane' },
            {
              name: 'all',
              area: 2,
              mean: 8,
            },
          ],
          goals: [
            {
              value: 5,
              met: true,
            },
          ],
          constraints: [
            {
              value: 30,
              met: false,
              violation: 0.5,
            },
          ],
          violation: 0.5,
        },
      },
    ]);
    const [answer] = answers;
    if (answer?.type !== 'improved') throw new Error('no answer');
    expect(answer.postedAt).toBe(clock.now);
    expect(transferred).toEqual([answer.shown.illuminance.buffer]);
  });
});

describe('a photometric file', () => {
  const read = (revision: number, ...bytes: number[]): ToWorker => ({
    type: 'describe',
    revision,
    file: Uint8Array.from(bytes).buffer,
  });

  test('is read at once, before there is a room and while one is opened', async () => {
    await driver.receive(read(1, 7));
    const opening = driver.receive(open(2, 1, 7));
    await driver.receive(read(3, 9));
    expect(kinds()).toEqual(['described 1', 'described 3']);
    await opening;
    expect(answers[0]).toMatchObject({ description: { maxCandela: 7 } });
  });

  test('is expected to be used once it has been told of, unless it is none', async () => {
    await driver.receive(read(1));
    expect(session.expected).toEqual([]);
    session.expectType = (file) => void session.expected.push(file[0]!, answers.length);
    await driver.receive(read(2, 7));
    expect(session.expected).toEqual([7, 2]);
  });

  test('makes room for the question that comes next, but not for ever', async () => {
    await opened();
    await driver.receive(solve(2));
    driver.step();
    await driver.receive(read(3, 7));
    const { calls } = session;
    const before = calls.length;
    driver.step();
    expect(driver.busy).toBe(false);
    expect(calls.length).toBe(before);
    await driver.receive(solve(4));
    expect(driver.busy).toBe(true);
    await driver.receive(read(5, 7));
    clock.now += 101;
    expect(driver.busy).toBe(true);
    settle();
    expect(kinds().at(-1)).toBe('settled 4');
  });

  test('lets a search go on, and is answered by one line where it is none', async () => {
    await opened();
    await driver.receive(solve(2));
    driver.step();
    await driver.receive(read(3));
    expect(answers.at(-1)).toEqual({
      type: 'described',
      revision: 3,
      description: 'the file is empty; fetch it again',
    });
    settle();
    expect(kinds().at(-1)).toBe('settled 2');
  });
});

test('a search in which there is one layout only settles: as one that was looked at', async () => {
  await opened();
  session.isOnlyLayout = true;
  await driver.receive(solve(2));
  settle();
  expect(answers.at(-1)).toMatchObject({ type: 'settled', revision: 2, evaluations: 1 });
});

const type = luminaireType('t1', 'spot');
const ofTypes = (more: Partial<LuminaireType> = {}): Intentions => ({
  ...asked,
  luminaires: { ...asked.luminaires, types: [{ ...type, ...more }] },
});
const start = { sites: [1, 0], flux: [100, 100], dimming: 1 };
const mounting = { type: 't1', turn: 0, aim: null };
const searched = () => [...session.calls, ...mounted.calls].filter((call) => call.startsWith('start'));

/** A room whose file knows any photometry, and a photometric file. */
async function openedForTypes(): Promise<void> {
  mounted = session;
  session.hasOperator = true;
  await opened();
  await driver.receive({ type: 'bring', hash: type.hash, file: Uint8Array.of(7).buffer });
}

test('of a task area, too, light may be asked of types', async () => {
  await openedForTypes();
  const outline = outlineOf([-9, -9, 9, 9]);
  const intentions: Intentions = {
    ...ofTypes(),
    taskAreas: [{ name: 'task 1', surface: 'floor', outline }],
    constraints: [{ statistic: 'mean', min: 60, surfaces: ['task 1'] }],
  };
  await driver.receive(solve(2, { intentions }));
  settle();
  expect(answers.filter(({ type: kind }) => kind === 'failed')).toEqual([]);
  expect(kinds().at(-1)).toBe('settled 2');
});

test('where another file is no scene the room stays, with what types have made of it', async () => {
  await openedForTypes();
  await driver.receive(solve(2, { intentions: ofTypes() }));
  settle();
  await driver.receive(open(3, 0, 7));
  expect(kinds().at(-1)).toBe('failed 3');
  await driver.receive(solve(4, { intentions: ofTypes() }));
  settle();
  expect(kinds().at(-1)).toBe('settled 4');
  expect(mounted.calls).toEqual(['adopt 0 0 1 0', 'start 3', 'start 3']);
  await driver.receive(open(5, 1, 7));
  expect(kinds().at(-1)).toBe('opened 5');
  expect(mounted.calls.at(-1)).toBe('delete');
});

test('types are asked about before the statistics are there, squares are not', async () => {
  let end!: () => void;
  const body = new ReadableStream<Uint8Array>({
    start: (controller) => {
      controller.enqueue(new Uint8Array(64));
      end = () => {
        controller.enqueue(new Uint8Array(64));
        controller.close();
      };
    },
  });
  session.operatorAt = 10;
  session.statisticsAt = 100;
  const opening = driver.open(4, new ArrivingFile(body));
  await driver.receive({ type: 'bring', hash: type.hash, file: Uint8Array.of(7).buffer });
  await driver.receive(solve(5, { intentions: ofTypes(), start }));
  while (woken === 0) await new Promise((resolve) => setTimeout(resolve, 1));
  driver.step();
  expect(kinds()).toEqual(['room 4', 'opened 4', 'improved 5']);
  expect(session.calls).toEqual(['finishLight']);
  settle();
  await driver.receive(solve(6));
  expect(driver.busy).toBe(false);
  end();
  await opening;
  expect(session.calls).toEqual(['finishLight', 'finishStatistics']);
  driver.step();
  expect(kinds().at(-1)).toBe('improved 6');
});

test('what types will need is prepared while the responses are on their way', async () => {
  const body = new ReadableStream<Uint8Array>({
    start: (controller) => controller.enqueue(new Uint8Array(64)), // and no end
  });
  session.operatorAt = 10;
  session.lateAt = 100;
  session.statisticsAt = 120;
  void driver.open(4, new ArrivingFile(body));
  await driver.receive(solve(5, { intentions: { ...ofTypes(), glare: { max: 19 } } }));
  while (woken === 0) await new Promise((resolve) => setTimeout(resolve, 1));
  driver.step();
  expect(driver.busy).toBe(true); // there is more to see
  await driver.receive(open(6, 0));
  expect(driver.busy).toBe(false);
  expect(session.calls).toEqual(['prepare and look']);
});

test('light that somebody else has computed is read beside what was searched, which stays', async () => {
  await openedForTypes();
  await driver.receive(solve(2, { intentions: ofTypes(), start }));
  settle();
  const searching = mounted;
  const layout = { ...start, mountings: [mounting, mounting] };
  const read = (revision: number, columns: Float32Array<ArrayBuffer>) =>
    driver.receive({ type: 'read', revision, intentions: ofTypes(), layout, columns });
  await read(3, new Float32Array(4));
  settle();
  expect(answers.at(-1)).toMatchObject({ type: 'readings', shown: { layout: { sites: [1, 0] } } });
  expect(mounted.calls.at(-1)).toBe('delete');
  await driver.receive(solve(4, { intentions: ofTypes(), start }));
  settle();
  expect(searching.calls).not.toContain('delete');
  await read(5, new Float32Array());
  settle();
  expect(answers.at(-1)).toMatchObject({ type: 'readings', shown: expect.stringContaining('not that of') });
});

test('all that may be tried is begun in a step of its own, and lit in others', async () => {
  await openedForTypes();
  await driver.receive(solve(2, { intentions: ofTypes() }));
  const both: number[] = [];
  while (driver.busy) {
    const [begun, advanced] = [FakeCandidates.begun, FakeCandidates.advanced];
    driver.step();
    if (FakeCandidates.begun > begun) both.push(FakeCandidates.advanced - advanced);
  }
  expect(both).toEqual([0]);
  expect(kinds().at(-1)).toBe('settled 2');
});

describe('luminaires of types', () => {
  beforeEach(openedForTypes);

  test('the start is lit at once, then all that may be tried is made and searched', async () => {
    await driver.receive(solve(2, { intentions: ofTypes(), start }));
    driver.step();
    expect(answers).toMatchObject([
      {
        type: 'improved',
        revision: 2,
        evaluations: 1,
        shown: { layout: { mountings: [mounting, mounting] } },
      },
    ]);
    expect(mounted.calls).toEqual(['adopt 1 0 0 0', 'show 0 1']);
    expect(searched()).toEqual([]);
    settle();
    expect(mounted.calls).toContain('adopt 0 0 1 0');
    expect(mounted.observed).toMatchObject({ glare: null }); // while they were made, slice by slice
    expect(searched()).toEqual(['start 3 from 1 0']);
    expect(kinds().at(-1)).toBe('settled 2');
  });

  test('the statistics of all that may be tried are made in slices, which a newer wish ends', async () => {
    await opened();
    session.unprepared = 3;
    await driver.receive(solve(2));
    driver.step();
    driver.step();
    await driver.receive(solve(3));
    expect(session.calls.filter((call) => call.startsWith('start'))).toEqual([]);
    session.unprepared = 1;
    for (let i = 0; i < 3; ++i) driver.step();
    expect(session.calls.filter((call) => call.startsWith('start'))).toEqual(['start 3']);
    expect(kinds()).toEqual(['improved 3']);
  });

  test('what they will need of an open room is made while nothing else is to be done', async () => {
    session.hasOperator = true;
    await opened();
    await driver.receive(solve(2));
    driver.step();
    expect(session.calls).not.toContain('prepare');
    settle();
    expect(session.calls.at(-1)).toBe('prepare');
    expect(driver.busy).toBe(false);
  });
});

describe('candidates of types', () => {
  beforeEach(openedForTypes);

  test('serve the next wish', async () => {
    await driver.receive(solve(2, { intentions: ofTypes(), start }));
    settle();
    const known = mounted;
    await driver.receive(solve(3, { intentions: ofTypes(), start, seed: 4 }));
    settle();
    expect(mounted).toBe(known);
    expect(searched()).toEqual(['start 3 from 1 0', 'start 4 from 1 0']);
  });

  test('that are known of one type are not made again beside another', async () => {
    await driver.receive(solve(2, { intentions: ofTypes(), start }));
    settle();
    const other = luminaireType('t2', 'flood');
    await driver.receive({ type: 'bring', hash: other.hash, file: Uint8Array.of(8).buffer });
    const intentions = { ...asked, luminaires: { ...asked.luminaires, types: [type, other] } };
    await driver.receive(solve(3, { intentions, start }));
    settle();
    expect(mounted.calls).toContain('adopt 0 0 0 1 1 0 1 1');
    expect(mounted.calls).toContain('took 0 - 1 -'); // of the search before
    expect(mounted.calls).toContain('took - 1 - 0'); // of the start, which hung as the new one does
  });

  test('on places that are excluded are not lit until they are allowed', async () => {
    const without = (excluded: number[]) => {
      const { luminaires, ...rest } = ofTypes();
      return { ...rest, luminaires: { ...luminaires, excluded } };
    };
    await driver.receive(solve(2, { intentions: without([0]), start: null }));
    settle();
    expect(mounted.calls).toContain('dark 0');
    const [known, { begun }] = [mounted, FakeCandidates];
    await driver.receive(solve(3, { intentions: without([0, 1]), start: null }));
    settle();
    expect(mounted).toBe(known); // what is lit may be excluded, too
    expect(FakeCandidates.begun).toBe(begun);
    await driver.receive(solve(4, { intentions: without([1]), start: null }));
    settle();
    expect(mounted).not.toBe(known);
    expect(mounted.calls).toContain('took - 1'); // what was dark is not known
    expect(mounted.calls.some((call) => call.startsWith('dark'))).toBe(false);
    const all = mounted;
    await driver.receive(solve(5, { intentions: without([0]), start: null }));
    settle();
    expect(mounted).toBe(all); // both have their light now
    expect(kinds().at(-1)).toBe('settled 5');
  });

  test('the latest wish wins while candidates are being made', async () => {
    await driver.receive(solve(2, { intentions: ofTypes(), start }));
    driver.step();
    await driver.receive(solve(3, { intentions: ofTypes({ flux: 500 }), start }));
    settle();
    expect(searched()).toEqual(['start 3 from 1 0']);
    expect(kinds().at(-1)).toBe('settled 3');
  });
});

describe('luminaires of types that', () => {
  beforeEach(openedForTypes);

  test('the room, the file or the rules do not let shine are squares', async () => {
    await driver.receive(solve(2, { intentions: ofTypes({ isAllowed: false }), start }));
    settle();
    await driver.receive(solve(3, { intentions: ofTypes({ hash: 'f'.repeat(16) }), start }));
    settle();
    session.hasOperator = false;
    await opened();
    await driver.receive(solve(4, { intentions: ofTypes(), start }));
    settle();
    expect(mounted).toBe(session);
  });

  test('are shown hang exactly as they did, their own aims included', async () => {
    const aimed = { ...mounting, aim: [1, 2, 3] as const };
    const layout = { ...start, mountings: [aimed, mounting] };
    await driver.receive({ type: 'show', revision: 2, intentions: ofTypes(), layout });
    expect(answers).toMatchObject([
      { type: 'improved', shown: { layout: { mountings: [aimed, mounting] } } },
    ]);
  });

  test('fit nowhere are refused in one line', async () => {
    await driver.receive({ type: 'bring', hash: 'e'.repeat(16), file: Uint8Array.of(200).buffer });
    await driver.receive(
      solve(2, { intentions: ofTypes({ hash: 'e'.repeat(16), name: 'Long one' }), start }),
    );
    settle();
    expect(answers.at(-1)).toMatchObject({
      type: 'failed',
      message: expect.stringMatching(/“Long one” fits on no/),
    });
  });

  test('without a luminous area are refused where glare is asked for', async () => {
    const intentions = { ...ofTypes(), glare: { max: 19 } };
    await driver.receive(solve(2, { intentions, start }));
    settle();
    expect(answers.at(-1)).toMatchObject({
      type: 'failed',
      message: expect.stringMatching(/^“.+” has no luminous area, so nobody can say how it glares: /),
    });
  });
});

describe('the colour of light', () => {
  const paint = (...colors: number[]): ToWorker => ({ type: 'paint', colors: Float32Array.from(colors) });
  const layout = { sites: [1], flux: [100], dimming: 1 };
  const show = (revision: number): ToWorker => ({ type: 'show', revision, intentions: asked, layout });

  test('follows the light that was shown, once operator and paint are there', async () => {
    session.hasOperator = true;
    await opened();
    await driver.receive(show(2));
    settle();
    expect(kinds()).toEqual(['improved 2']);
    const [first] = answers;
    const lux = first?.type === 'improved' ? [...first.shown.illuminance] : [];
    await driver.receive(paint(1, 0, 0));
    settle();
    expect(answers.at(-1)).toMatchObject({ type: 'colored', revision: 2, colors: Float32Array.from(lux) });
    await driver.receive(show(3));
    settle();
    expect(kinds()).toEqual(['improved 2', 'colored 2', 'improved 3', 'colored 3']);
  });

  test('comes with the light of another layout', async () => {
    session.hasOperator = true;
    await opened();
    await driver.receive(show(2));
    await driver.receive({ type: 'read', revision: 3, intentions: asked, layout });
    settle();
    await driver.receive(paint(1, 0, 0));
    await driver.receive({ type: 'read', revision: 4, intentions: asked, layout });
    settle();
    const seen = answers.flatMap((each) =>
      each.type === 'readings' && typeof each.shown !== 'string' ? [each.shown] : [],
    );
    expect(seen.map(({ colors }) => colors)).toEqual([null, seen[1]?.illuminance]);
  });

  test('is not told of grey rooms, nor of those without an operator', async () => {
    session.hasOperator = true;
    await opened();
    await driver.receive(paint(0.5, 0.5, 0.5));
    await driver.receive(show(2));
    settle();
    session.hasOperator = false;
    await driver.receive(open(3, 1, 7));
    await driver.receive(paint(1, 0, 0));
    await driver.receive(show(4));
    settle();
    expect(kinds().filter((kind) => kind.startsWith('colored'))).toEqual([]);
  });

  test('leaves a running search its time', async () => {
    session.hasOperator = true;
    session.improvesAt = [1000, 30_000, 60_000, 90_000, 120_000, 150_000];
    await opened();
    await driver.receive(paint(1, 0, 0));
    await driver.receive(solve(2));
    settle();
    const told = kinds();
    expect(told.at(-1)).toBe('colored 2'); // of what the search ended with
    const count = (kind: string) => told.filter((each) => each.startsWith(kind)).length;
    expect(count('colored')).toBeLessThan(count('improved') + count('settled'));
  });
});

describe('paint', () => {
  const start = { sites: [1], flux: [100], dimming: 1 };
  const painted: Intentions = { ...asked, paint: [{ surface: 'floor', reflectance: 0.25 }] };

  beforeEach(() => void (mounted = session));

  test('shows the layout in the painted room at once, then searches all of its places', async () => {
    session.hasOperator = true;
    await opened();
    await driver.receive(solve(2, { intentions: painted, start }));
    driver.step();
    expect(answers.at(-1)).toMatchObject({ type: 'improved', revision: 2, shown: { layout: start } });
    expect(mounted.calls).toContain('adopt 1 0 0.25'); // one place; the floor, a quarter
    settle();
    expect(mounted.calls).toContain('adopt 0 1 0 0.25');
    expect(answers.at(-1)).toMatchObject({ type: 'settled', revision: 2 });
  });

  test('of luminaires of types is made of what they are without it', async () => {
    await openedForTypes();
    const intentions = { ...ofTypes(), paint: painted.paint! };
    await driver.receive(solve(2, { intentions, start: { ...start, mountings: [mounting] } }));
    driver.step();
    expect(mounted.calls).toContain('adopt 1 0 0 0.25');
    expect(kinds()).toEqual(['improved 2']);
    settle();
    expect(mounted.calls).toContain('adopt 0 0 1 0 0 0.25');
    expect(kinds().at(-1)).toBe('settled 2');
  });

  test('leaves the light of types to the next step of paint', async () => {
    await openedForTypes();
    const wish = (reflectance: number) => ({
      intentions: { ...ofTypes(), paint: [{ surface: 'floor', reflectance }] },
      start: { ...start, mountings: [mounting] },
    });
    await driver.receive(solve(2, wish(0.25)));
    settle();
    const { begun } = FakeCandidates;
    await driver.receive(solve(3, wish(0.5)));
    settle();
    expect(FakeCandidates.begun).toBe(begun);
    expect(mounted.calls).toContain('adopt 0 0 1 0 0 0.5');
  });

  test('of surfaces that are not there, or in a room whose file cannot tell, changes nothing', async () => {
    await opened();
    await driver.receive(solve(2, { intentions: painted, start }));
    settle();
    session.hasOperator = true;
    await driver.receive(open(3, 1, 7));
    const elsewhere: Intentions = { ...asked, paint: [{ surface: 'sail', reflectance: 0.25 }] };
    await driver.receive(solve(4, { intentions: elsewhere, start }));
    settle();
    expect(mounted).toBe(session); // nothing else was made
    expect(answers.at(-1)).toMatchObject({ type: 'settled', revision: 4 });
  });

  test('tells what lighter paint gains, beside what runs', async () => {
    session.hasOperator = true;
    await opened();
    await driver.receive({ type: 'gains', revision: 2, intentions: painted, layout: start });
    const gains = [{ surface: 0, goals: [0.75], constraints: [1] }];
    expect(answers.at(-1)).toEqual({ type: 'gained', revision: 2, gains });
    expect(mounted.calls.at(-1)).toBe('gains 0'); // in the session that has the light of this one place
  });
});

describe('the pace of a search', () => {
  test('on a slow scene the first answer does not wait for all its evaluations', async () => {
    session = new FakeSession(clock, 20);
    driver = new SessionDriver(
      reader,
      session,
      (message) => answers.push(message),
      clock.read,
      () => {},
      () => () => {},
    );
    await driver.receive(open(1, 1, 7));
    const asking = clock.now;
    await driver.receive(solve(2));
    driver.step();
    expect(answers.at(-1)).toMatchObject({ type: 'improved', revision: 2 });
    expect(clock.now - asking).toBeLessThan(pace.firstMilliseconds + pace.probe / 20 + 1);
  });

  test('starts from the given layout', async () => {
    await opened();
    await driver.receive(solve(2, { start: { sites: [1, 0], flux: [100, 100], dimming: 1 } }));
    driver.step();
    expect(session.calls).toContain('start 3 from 1 0');
  });

  test('after a luminaire was moved only those beside it follow, where that is wished', async () => {
    await opened();
    const start = { sites: [1, 0], flux: [100, 100], dimming: 1 };
    await driver.receive(solve(2, { start, moved: [1] }));
    driver.step();
    expect(session.calls).toContain('start 3 from 1 0 near 1');
  });
  test('the latest wins: of a burst only the last is begun, and nothing old is answered', async () => {
    await opened();
    await driver.receive(solve(2));
    driver.step();
    for (let revision = 3; revision <= 20; ++revision)
      await driver.receive(solve(revision, { seed: revision }));
    answers.length = 0;
    settle();
    expect(session.calls.filter((call) => call.startsWith('start'))).toEqual(['start 3', 'start 20']);
    expect(new Set(answers.map((answer) => 'revision' in answer && answer.revision))).toEqual(new Set([20]));
  });

  test('then answers improvements only, a frame apart, and settles', async () => {
    await opened();
    session.improvesAt = [10_000, 400_000, 500_000, 600_000, 2_000_000];
    await driver.receive(solve(2));
    settle();
    const times = answers.map((answer) => ('postedAt' in answer ? answer.postedAt : 0));
    expect(kinds()).toEqual([...Array(4).fill('improved 2'), 'settled 2']);
    for (let i = 1; i < times.length; ++i)
      expect((times[i] ?? 0) - (times[i - 1] ?? 0)).toBeGreaterThanOrEqual(pace.answerGap);
    const last = answers.at(-1);
    if (last?.type !== 'settled') throw new Error('not settled');
    expect(last.evaluations).toBeGreaterThanOrEqual(2_000_000 + pace.fruitlessEvaluations);
    expect(last.shown.goal).toBe(-5);
  });

  test('what cannot be met serves the goals before it settles, where there are any', async () => {
    await opened();
    session.violation = 0.2;
    await driver.receive(solve(2, { intentions: { ...asked, goals: [] } }));
    settle();
    expect(session.calls).not.toContain('settle');
    const sigma = { statistic: 'sigma', sense: 'min', weight: 1, surfaces: ['all'] } as const;
    await driver.receive(solve(3, { intentions: { ...asked, goals: [sigma] } }));
    settle();
    expect(session.calls).toContain('settle');
    expect(kinds().at(-1)).toBe('settled 3');
  });

  test('a slice never takes much longer than intended', async () => {
    await opened();
    await driver.receive(solve(2));
    driver.step();
    for (let i = 0; i < 20 && driver.busy; ++i) {
      const before = clock.now;
      driver.step();
      expect(clock.now - before).toBeLessThan(2 * pace.sliceMilliseconds);
    }
  });
});

describe('show and check', () => {
  test('show answers once and ends the search', async () => {
    await opened();
    await driver.receive(solve(2));
    driver.step();
    await driver.receive({
      type: 'show',
      revision: 3,
      intentions: asked,
      layout: { sites: [1], flux: [5], dimming: 1 },
    });
    settle();
    expect(kinds()).toEqual(['improved 2', 'improved 3']);
  });

  test('show refuses a layout that cannot be', async () => {
    await opened();
    await driver.receive({
      type: 'show',
      revision: 2,
      intentions: asked,
      layout: { sites: [9], flux: [5], dimming: 1 },
    });
    expect(answers).toEqual([
      { type: 'failed', revision: 2, message: 'layout: there is no site 9', fatal: false },
    ]);
  });

  test('check leaves the search for the same intentions running', async () => {
    await opened();
    await driver.receive(solve(2));
    driver.step();
    const layout = { sites: [1], flux: [5], dimming: 1 };
    await driver.receive({ type: 'check', revision: 3, intentions: asked, search: 2, layout });
    expect(driver.busy).toBe(true);
    expect(answers.at(-1)).toMatchObject({ type: 'checked', revision: 3 });
    await driver.receive({
      type: 'check',
      revision: 4,
      intentions: { ...asked, goals: [] },
      search: null,
      layout,
    });
    expect(driver.busy).toBe(false);
  });

  test('check says where statistics and patches differ most, and the margins', async () => {
    await opened();
    await driver.receive({
      type: 'check',
      revision: 2,
      intentions: asked,
      search: null,
      layout: { sites: [1], flux: [5], dimming: 1 },
    });
    expect(answers).toEqual([
      {
        type: 'checked',
        revision: 2,
        largestDifference: 1e-5,
        surface: 'floor',
        margins: [
          {
            constraint: 0,
            margin: 0.25,
          },
        ],
      },
    ]);
  });
});

describe('what is long of a bound', () => {
  test('goes on beside the driver, and the better of both is told', async () => {
    await opened();
    session.pairs = Float64Array.of(7);
    await driver.receive({ type: 'bound', revision: 2, intentions: asked, search: null, isBrief: false });
    settle();
    expect(proofs.map(({ pairs }) => [...pairs])).toEqual([[7]]);
    expect(answers.at(-1)).toMatchObject({ type: 'bounded', done: false });
    answers.length = 0;
    for (const [gap, done] of [
      [0.3, false], // less than is known
      [0.05, false],
      [0.048, true],
    ] as const)
      proofs[0]!.tell({ goal: -1 - gap, done });
    const told = answers.map((answer) => answer.type === 'bounded' && [answer.gap.toFixed(3), answer.done]);
    expect(told).toEqual([
      ['0.050', false],
      ['0.048', true],
    ]);
    expect(proofs[0]!.isEnded).toBe(false);
  });

  test('is left out where it is not asked for', async () => {
    await opened();
    session.pairs = Float64Array.of(7);
    await driver.receive({ type: 'bound', revision: 2, intentions: asked, search: null, isBrief: true });
    settle();
    expect(proofs).toEqual([]);
    expect(answers.at(-1)).toMatchObject({ type: 'bounded', gap: 0.1, done: true });
  });

  test('a worker that ends without a proof leaves what is proved', async () => {
    await opened();
    session.pairs = Float64Array.of(7);
    await driver.receive({ type: 'bound', revision: 2, intentions: asked, search: null, isBrief: false });
    settle();
    proofs[0]!.tell({ goal: -Infinity, done: true });
    expect(answers.at(-1)).toMatchObject({ type: 'bounded', gap: 0.1, done: true });
  });

  test.each<ToWorker>([
    { type: 'solve', revision: 3, intentions: asked, start: null, moved: [], seed: 3, askedAt: 0 },
    { type: 'show', revision: 3, intentions: asked, layout: { sites: [1], flux: [100], dimming: 1 } },
    { type: 'stop' },
  ])('$type ends the proof at once, before anything of its own is done', async (message) => {
    await opened();
    session.pairs = Float64Array.of(7);
    await driver.receive({ type: 'bound', revision: 2, intentions: asked, search: null, isBrief: false });
    settle();
    await driver.receive(message);
    expect(proofs.map(({ isEnded }) => isEnded)).toEqual([true]);
  });
});

describe('alpha, bound and stop', () => {
  test('alpha tells every iteration once, then the verdict with its layout', async () => {
    await opened();
    const held = { sites: [7, 3], flux: [1, 1], dimming: 1 };
    await driver.receive({ type: 'alpha', revision: 2, intentions: asked, seed: 4, held });
    settle();
    expect(kinds()).toEqual(['alphaStep 2', 'alphaStep 2', 'alphaStep 2', 'alphaDone 2']);
    expect(answers[1]).toMatchObject({ step: { iteration: 2, interval: [0, 1], goal: 3, region: 'II' } });
    expect(answers[3]).toMatchObject({
      alpha: 0.5,
      verdict: expect.stringContaining('enough'),
      shown: { layout: { sites: [1] } },
    });
    expect(session.calls).toContain('alpha 4 held by 7 3');
  });

  test('a new wish ends the alpha-search', async () => {
    await opened();
    await driver.receive({ type: 'alpha', revision: 2, intentions: asked, seed: 4, held: null });
    driver.step();
    await driver.receive(solve(3));
    settle();
    expect(kinds().filter((kind) => kind.startsWith('alpha'))).toEqual([]);
  });

  test('bound waits for the search, uses it, and tells smaller and smaller gaps', async () => {
    await opened();
    await driver.receive(solve(2));
    await driver.receive({ type: 'bound', revision: 3, intentions: asked, search: 2, isBrief: false });
    settle();
    expect(session.calls.filter((call) => call.startsWith('start') || call === 'bound')).toEqual([
      'start 3',
      'bound',
    ]);
    const first = kinds().indexOf('bounded 3');
    expect(kinds()[first - 1]).toBe('settled 2');
    const gaps = answers.flatMap((answer) => (answer.type === 'bounded' ? [answer.gap] : []));
    expect(gaps.length).toBeGreaterThan(2);
    expect(gaps).toEqual([...gaps].sort((a, b) => b - a));
    expect(answers.at(-1)).toMatchObject({ type: 'bounded', gap: 0.1, done: true });
  });

  test('bound without a search of the same intentions makes one', async () => {
    await opened();
    await driver.receive({ type: 'bound', revision: 2, intentions: asked, search: null, isBrief: false });
    settle();
    expect(session.calls).toContain('start 1');
    expect(answers.at(-1)).toMatchObject({ type: 'bounded', revision: 2, done: true });
  });

  test('a new wish ends the bound', async () => {
    await opened();
    await driver.receive({ type: 'bound', revision: 2, intentions: asked, search: null, isBrief: false });
    driver.step();
    await driver.receive(solve(3));
    answers.length = 0;
    settle();
    expect(new Set(kinds())).toEqual(new Set(['improved 3', 'settled 3']));
  });

  test('stop ends the search with what it has', async () => {
    await opened();
    await driver.receive(solve(2));
    driver.step();
    await driver.receive({ type: 'stop' });
    expect(driver.busy).toBe(false);
    expect(kinds()).toEqual(['improved 2', 'settled 2']);
  });
});

const variants = [1, 2, 4].map((count) => ({ ...asked, luminaires: { ...asked.luminaires, count } }));
const compare = (revision: number): Extract<ToWorker, { type: 'compare' }> => ({
  type: 'compare',
  revision,
  intentions: asked,
  variants,
  start: { sites: [1], flux: [100], dimming: 1 },
  seed: 5,
  evaluations: 1000,
});

test('other ways are tried for whoever looks also where the rules of the wish leave no layout', async () => {
  session.hasOperator = true;
  session.mostLuminaires = 3;
  await opened();
  const wish = (count: number): Intentions => ({
    ...asked,
    glare: { observers: [{ name: 'A', position: [1, 1.2, 1], direction: [1, 0, 0] }] },
    luminaires: { ...asked.luminaires, count },
  });
  await driver.receive(solve(2, { intentions: wish(5) }));
  settle();
  expect(kinds()).toEqual(['failed 2']);
  const variants = [wish(5), wish(2)];
  await driver.receive({ ...compare(3), intentions: wish(5), variants });
  settle();
  const told = answers.flatMap((answer) => (answer.type === 'compared' ? [answer.outcome?.met] : []));
  expect(told).toEqual([undefined, true]);
});

describe('other ways', () => {
  test('are tried one after the other once no search runs, each from the one before', async () => {
    await opened();
    await driver.receive(solve(2));
    await driver.receive(compare(3));
    settle();
    const told = answers.flatMap((answer) => (answer.type === 'compared' ? [answer] : []));
    expect(told.map(({ variant, done }) => [variant, done])).toEqual([
      [0, false],
      [1, false],
      [2, true],
    ]);
    expect(told[0]?.outcome).toMatchObject({ met: false, violation: 0.25 });
    expect(told[1]?.outcome).toMatchObject({ met: true, layout: { sites: [0, 1] } });
    expect(told[2]?.outcome).toBeNull();
    expect(session.calls.filter((call) => call.startsWith('try'))).toEqual([
      'try 1 with 5 from 1',
      'try 2 with 5 from 0',
      'try 4 with 5 from 0 1',
    ]);
    expect(kinds().findIndex((kind) => kind === 'settled 2')).toBeLessThan(kinds().indexOf('compared 3'));
  });

  test('are tried on all places of a type also where only a layout is shown', async () => {
    await openedForTypes();
    const layout = { sites: [1], flux: [100], dimming: 1, mountings: [mounting] };
    await driver.receive({ type: 'show', revision: 2, intentions: ofTypes(), layout });
    const few = mounted;
    expect(few.calls).toContain('adopt 1 0');
    const intentions = ofTypes();
    await driver.receive({ ...compare(3), intentions, variants: [intentions] } as ToWorker);
    settle();
    expect(kinds().at(-1)).toBe('compared 3');
    expect(few.calls.filter((call) => call.startsWith('try'))).toEqual([]);
    expect(mounted.calls).toContain('adopt 0 0 1 0');
    expect(mounted.calls.filter((call) => call.startsWith('try'))).toHaveLength(1);
  });

  test.each([0, 9])('are tried in slices, so that whoever asks meanwhile does not wait', async (starts) => {
    await opened();
    session.starts = starts; // steps in no time say nothing of the next ones
    await driver.receive({ ...compare(2), variants: [asked], evaluations: 1_000_000 } as ToWorker);
    let longest = 0;
    while (driver.busy) {
      const begun = clock.now;
      driver.step();
      longest = Math.max(longest, clock.now - begun);
    }
    expect(kinds()).toEqual(['compared 2']);
    expect(longest).toBeLessThanOrEqual(pace.sliceMilliseconds + 1);
  });

  test('are begun again where the session was asked something in between', async () => {
    await opened();
    await driver.receive({ ...compare(2), variants: [asked], evaluations: 1_000_000 } as ToWorker);
    driver.step();
    const layout = { sites: [1], flux: [100], dimming: 1 };
    await driver.receive({ type: 'show', revision: 3, intentions: asked, layout });
    settle();
    expect(session.calls.filter((call) => call.startsWith('try'))).toHaveLength(2);
    expect(kinds()).toEqual(['improved 3', 'compared 2']);
  });

  test('are forgotten with the wish that they were for', async () => {
    await opened();
    await driver.receive(compare(2));
    driver.step();
    await driver.receive(solve(3));
    settle();
    expect(kinds().filter((kind) => kind.startsWith('compared'))).toEqual(['compared 2']);
  });
});

test('room is looked for beside what runs', async () => {
  await opened();
  await driver.receive(solve(2));
  const luminaires = [5, 4, 3, 2].map((count) => ({ ...asked.luminaires, count }));
  await driver.receive({ type: 'fit', revision: 3, luminaires });
  await driver.receive({ type: 'fit', revision: 4, luminaires: luminaires.slice(0, 2) });
  const told = answers.flatMap((answer) => (answer.type === 'fitted' ? [answer.first] : []));
  expect(told).toEqual([2, null]);
  settle();
  expect(kinds().at(-1)).toBe('settled 2');
});

test('a search that has tried everything settles at once', async () => {
  session.provedAt = 1;
  await opened();
  await driver.receive(solve(2));
  const begun = clock.now;
  settle();
  expect(kinds()).toContain('settled 2');
  expect(clock.now - begun).toBeLessThan(pace.fruitlessMilliseconds / 2);
});

describe('the light of another layout', () => {
  const read = (revision: number, sites: number[]): ToWorker => ({
    type: 'read',
    revision,
    intentions: asked,
    layout: { sites, flux: sites.map(() => 1), dimming: 1 },
  });

  test('is read beside a search, which goes on and settles as without it', async () => {
    await opened();
    await driver.receive(solve(2));
    driver.step();
    await driver.receive(read(3, [0]));
    await driver.receive(read(4, [1]));
    settle();
    const told = kinds().filter((kind) => !kind.startsWith('improved'));
    expect(told).toEqual(['readings 3', 'readings 4', 'settled 2']);
    expect(answers.find(({ type }) => type === 'readings')).toMatchObject({
      shown: { layout: { sites: [0] } },
    });
  });
});

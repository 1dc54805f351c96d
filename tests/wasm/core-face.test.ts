/** The TypeScript face (web/solver/core.ts) against the module as it was built. */
import { afterAll, beforeAll, describe, expect, jest, test } from '@jest/globals';
import { coreIntentions } from '../../web/solver/core-intentions.ts';
import { codes, sessionMethods, type Session } from '../../web/solver/core.ts';
import { bytesOf, loadBuiltCore, openFile, syntheticFile } from './solver-module.ts';

const core = await loadBuiltCore();
let session: Session;

beforeAll(() => {
  session = new core.Session();
  openFile(session, bytesOf(syntheticFile()));
});
afterAll(() => session.delete());

const even = {
  quantity: 'illuminance',
  luminaires: { count: 3, flux: 1000, dimming: [1, 1], pinned: [], excluded: [], minDistance: 0 },
  goals: [{ statistic: 'sigma', sense: 'min', weight: 1, surfaces: ['all'] }],
  constraints: [{ statistic: 'mean', min: 1, surfaces: ['floor'] }],
} as const;

test("numbers stand for the page's words: none is missing, none is another", () => {
  const inOrder = (numbers: Readonly<Record<string, number>>) =>
    Object.keys(numbers).sort((a, b) => numbers[a]! - numbers[b]!);
  const words = Object.entries(codes).map(([kind, numbers]) => [kind, inOrder(numbers)]);
  expect(core.codes()).toEqual(Object.fromEntries(words));
});

test('a pinned luminaire keeps its number', () => {
  const luminaires = { ...even.luminaires, pinned: [17] };
  const constraints = [{ statistic: 'minimum', min: 1, surfaces: ['floor'] }] as const;
  const asked = coreIntentions({ ...even, luminaires, constraints }, session.info()?.surfaces ?? []);
  const sites = Uint32Array.of(3, 30, 17);
  expect(session.setIntentions(asked)).toBe('');
  expect(session.startFrom(1, sites, Float64Array.of(1000, 1000, 1000), 1)).toBe('');
  session.advance(5000);
  const shown = session.incumbent();
  if (typeof shown === 'string') throw new Error(shown);
  expect(shown.layout.sites[2]).toBe(17);
  expect(session.setIntentions(asked)).toBe('');
  expect(session.startAlpha(1, sites)).toBe('');
  let progress = session.advanceAlpha(20_000, 0);
  while (typeof progress !== 'string' && !progress.done) progress = session.advanceAlpha(20_000, 0);
  if (typeof progress === 'string') throw new Error(progress);
  expect(progress.layout?.sites[2]).toBe(17);
});

test('an aim is met by the common dimming', () => {
  const luminaires = { ...even.luminaires, dimming: [0.01, 1] } as const;
  const goals = [{ statistic: 'mean', sense: 'near', target: 5, weight: 1, surfaces: ['floor'] }] as const;
  const asked = coreIntentions(
    { ...even, luminaires, goals, constraints: [] },
    session.info()?.surfaces ?? [],
  );
  expect(session.setIntentions(asked)).toBe('');
  expect(session.start(1)).toBe('');
  session.advance(1000);
  const shown = session.incumbent();
  if (typeof shown === 'string') throw new Error(shown);
  expect(shown.surfaces[0]).toBeCloseTo(5, 6);
  expect(shown.goals[0]).toBeCloseTo(0, 6);
});

describe('every method', () => {
  test('of the module is declared, and the other way round', () => {
    // note: delete and friends are on Embind's own base class.
    const built = Object.getOwnPropertyNames(core.Session.prototype).filter((name) => name !== 'constructor');
    expect([...built, 'delete'].sort()).toEqual(Object.keys(sessionMethods).sort());
  });

  // Embind refuses a wrong number of arguments and says how many it takes.
  for (const [name, count] of Object.entries(sessionMethods)) {
    if (name === 'delete') continue;
    test(`${name} takes ${count} arguments`, () => {
      const method = Reflect.get(session, name) as (...args: unknown[]) => unknown;
      const tooMany: unknown[] = Array.from({ length: count + 1 }, () => 0);
      expect(() => method.apply(session, tooMany)).toThrow(`expected ${count} args`);
    });
  }
});

describe('values have the declared shapes', () => {
  test('info', () => {
    const info = session.info();
    if (!info) throw new Error('no scene');
    const rows = info.patches + info.receivers;
    const sites = info.siteSize.length;
    expect(info.identity).toMatch(/^[0-9a-f]{16}$/);
    expect(info.surfaces.map(({ name, measuring }) => [name, measuring])).toEqual([
      ['floor', false],
      ['wall é', false],
      ['desk plane', true],
    ]);
    expect(info.surfaceOfPatch).toBeInstanceOf(Uint32Array);
    expect(info.surfaceOfPatch).toHaveLength(rows);
    expect(info.patchArea).toHaveLength(rows);
    expect(info.patchCenter).toHaveLength(3 * rows);
    expect(info.patchReflectance).toHaveLength(rows);
    info.surfaces.forEach((surface, s) => {
      const rowsOf = [...info.surfaceOfPatch.keys()].filter((row) => info.surfaceOfPatch[row] === s);
      const reflected = rowsOf.reduce(
        (sum, row) => sum + (info.patchReflectance[row] ?? 0) * (info.patchArea[row] ?? 0),
        0,
      );
      expect(reflected / surface.area).toBeCloseTo(surface.measuring ? 0 : surface.reflectance, 5);
    });
    expect(sites).toBe(40);
    for (const array of [info.sitePosition, info.siteNormal, info.siteAxis])
      expect(array).toHaveLength(3 * sites);
    const area = info.patchArea.reduce((sum, patch) => sum + patch, 0);
    expect(area).toBeCloseTo(
      info.surfaces.reduce((sum, surface) => sum + surface.area, 0),
      3,
    );
  });

  test('shown', () => {
    const info = session.info();
    if (!info) throw new Error('no scene');
    expect(session.setIntentions(coreIntentions(even, info.surfaces))).toBe('');
    expect(session.start(1)).toBe('');
    const progress = session.advance(1000);
    expect(progress.evaluations).toBe(1000);
    const shown = session.incumbent();
    if (typeof shown === 'string') throw new Error(shown);
    expect(shown.layout.sites).toHaveLength(3);
    expect([...shown.layout.flux]).toEqual([1000, 1000, 1000]);
    expect(shown.illuminance).toHaveLength(info.patches + info.receivers);
    expect(shown.surfaces).toHaveLength(4 * (info.surfaces.length + 1));
    expect(shown.goals[0]).toBeCloseTo(shown.surfaces[4 * 3 + 1] ?? NaN, 3);
    expect(shown.constraints[0]).toBeCloseTo(shown.surfaces[0] ?? NaN, 3);
    const { sites, flux, dimming } = shown.layout;
    expect(session.show(sites, flux, dimming)).toEqual(shown);
    expect(session.check(sites, flux, dimming)).toMatchObject({ largestDifference: expect.any(Number) });
  });

  test('copies outlive the growth of the memory', () => {
    const shown = session.incumbent();
    if (typeof shown === 'string') throw new Error(shown);
    const before = shown.illuminance.slice();
    const another = new core.Session();
    openFile(another, bytesOf(syntheticFile()));
    another.delete();
    expect(shown.illuminance).toEqual(before);
    expect(shown.illuminance.buffer.byteLength).toBe(4 * before.length);
  });
});

test('memory that the browser refuses is a trap, by which the page knows that it needs another worker', async () => {
  const told = jest.spyOn(console, 'warn').mockImplementation(() => undefined); // the glue says "Aborted()"
  const own = await loadBuiltCore(); // no use afterwards
  const starved = new own.Session();
  const { grow } = WebAssembly.Memory.prototype;
  WebAssembly.Memory.prototype.grow = () => {
    throw new RangeError('no memory');
  };
  try {
    expect(() => starved.openTable(new Uint8Array(256 << 20))).toThrow(WebAssembly.RuntimeError);
  } finally {
    WebAssembly.Memory.prototype.grow = grow;
    told.mockRestore();
  }
});

test('an alpha-search ends with a verdict and a layout that can be shown', () => {
  const info = session.info();
  if (!info) throw new Error('no scene');
  const constraints = [{ statistic: 'minimum', min: 1, surfaces: ['floor'] }] as const;
  expect(session.setIntentions(coreIntentions({ ...even, constraints }, info.surfaces))).toBe('');
  expect(session.startAlpha(1, Uint32Array.of())).toBe('');
  let progress = session.advanceAlpha(1000, 0);
  for (let slice = 0; slice < 10_000 && typeof progress !== 'string' && !progress.done; ++slice)
    progress = session.advanceAlpha(20_000, 0);
  if (typeof progress === 'string') throw new Error(progress);
  expect(progress).toMatchObject({ done: true, verdict: expect.stringMatching(/.{10}/) });
  expect(progress.steps.length).toBeGreaterThan(0);
  expect(progress.steps[0]?.region).toMatch(/^I{1,3}$/);
  if (!progress.layout) throw new Error('no layout');
  const { sites, flux, dimming } = progress.layout;
  expect(session.show(sites, flux, dimming)).toMatchObject({ layout: { dimming } });
});

test('a bound is proved below the goal that the search reached', () => {
  const info = session.info();
  if (!info) throw new Error('no scene');
  expect(session.setIntentions(coreIntentions({ ...even, constraints: [] }, info.surfaces))).toBe('');
  expect(session.startBound()).toMatch(/no search/);
  expect(session.start(1)).toBe('');
  const { goal } = session.advance(50_000);
  expect(session.startBound()).toBe('');
  let progress = session.advanceBound(200);
  for (let slice = 0; slice < 10_000 && typeof progress !== 'string' && !progress.done; ++slice)
    progress = session.advanceBound(1000);
  if (typeof progress === 'string') throw new Error(progress);
  expect(progress.done).toBe(true);
  expect(progress.goal).toBeLessThanOrEqual(goal);
  expect(progress.gap).toBeCloseTo((goal - progress.goal) / Math.abs(progress.goal), 9);
});

test('the pairs of a bound are gone through in another module', () => {
  const info = session.info();
  if (!info) throw new Error('no scene');
  expect(session.setIntentions(coreIntentions({ ...even, constraints: [] }, info.surfaces))).toBe('');
  expect(session.start(1)).toBe('');
  const { goal } = session.advance(50_000);
  expect(session.takePairs()).toHaveLength(0);
  expect(session.startBound()).toBe('');
  const pairs = session.takePairs();
  expect(pairs.length).toBeGreaterThan(0);
  const proof = new core.PairProof();
  expect(proof.begin(pairs.subarray(1))).toBe(false);
  expect(proof.begin(pairs)).toBe(true);
  expect(proof.goal()).toBe(-Infinity);
  while (!proof.advance());
  expect(proof.goal()).toBeLessThanOrEqual(goal);
  session.provedByPairs(proof.goal());
  const known = session.advanceBound(0);
  if (typeof known === 'string') throw new Error(known);
  expect(known.goal).toBeCloseTo(proof.goal(), 6);
  expect(known.gap).toBeLessThan(0.5);
  expect(session.start(2)).toBe('');
  session.provedByPairs(proof.goal()); // of a search that is no longer there
  proof.delete();
});

describe('errors are one readable line', () => {
  const line = /^[^\n]{8,200}$/;
  test('before anything is open', () => {
    const empty = new core.Session();
    expect(empty.info()).toBeNull();
    for (const error of [
      empty.start(1),
      empty.finish(),
      empty.finishOperator(),
      empty.incumbent(),
      empty.show(Uint32Array.of(1), Float64Array.of(1), 1),
    ])
      expect(error).toMatch(line);
    empty.delete();
  });
  test('a light outside the sites', () => {
    expect(session.show(Uint32Array.of(40), Float64Array.of(1), 1)).toContain('no site 40');
  });
  test('more luminaires than sites', () => {
    const asked = coreIntentions(
      { ...even, luminaires: { ...even.luminaires, count: 41 } },
      session.info()?.surfaces ?? [],
    );
    expect(session.setIntentions(asked)).toMatch(line);
  });
});

/** Luminaires of photometric types in the built module: their light adds up, and the search finds the best of them. */
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { expect, test } from '@jest/globals';
import { candidatesOf } from '../../web/document/candidates.ts';
import type { Intentions, Layout, LuminaireType, SceneInfo } from '../../web/document/types.ts';
import { coreIntentions, gainsOf, shownOf } from '../../web/solver/core-intentions.ts';
import { beginCandidates, MountedSession } from '../../web/solver/mounted-session.ts';
import { openScene } from '../../web/solver/open-scene.ts';
import { wholeFile } from '../../web/solver/scene-stream.ts';
import { bytesOf, loadBuiltCore, operatorFile, root } from './solver-module.ts';

const core = await loadBuiltCore();
const folder = mkdtempSync(path.join(tmpdir(), 'fiatlux-'));
execFileSync('node', [path.join(root, 'rooms/luminaires.mjs'), '--folder', folder], { stdio: 'ignore' });
const files = new Map(
  ['spot-24.ldt', 'panel.ldt'].map((name) => [name, new Uint8Array(readFileSync(path.join(folder, name)))]),
);
const fileOf = ({ file }: LuminaireType) => files.get(file)!;

const use = { name: 'x', maker: '', hash: '0', watts: 10, isAllowed: true, tilt: 0 } as const;
const range = { count: [0, 9], turns: [0] } as const;
const spot: LuminaireType = { ...use, ...range, id: 's', file: 'spot-24.ldt', flux: 1200, aims: [] };
const panel: LuminaireType = { ...use, ...range, id: 'p', file: 'panel.ldt', flux: 3600, aims: [] };

const room = new core.Session();
let scene!: SceneInfo;
await openScene(room, wholeFile(bytesOf(operatorFile()).buffer), () => true, {
  room: () => undefined,
  scene: (opened) => void (scene = opened),
  prepare: () => undefined,
  ready: () => undefined,
});
const sites = [3, 8, 14, 21, 29, 36];
const anywhere = { flux: 1, dimming: [1, 1], pinned: [], excluded: [], minDistance: 0 } as const;

/** A session of these types on a few sites, asked for even light by `count` luminaires. */
function sessionOf(
  types: readonly LuminaireType[],
  count = 2,
  more: Partial<Intentions['luminaires']> = {},
  constraints: Intentions['constraints'] = [],
  glare?: Intentions['glare'],
): MountedSession {
  const candidates = candidatesOf(types, () => undefined, scene).filter(({ site }) => sites.includes(site));
  const making = new core.Candidates();
  beginCandidates(making, room, candidates, fileOf);
  while (!making.advance(5)) continue;
  const session = new core.Session();
  const asked: Intentions = {
    quantity: 'illuminance',
    luminaires: { ...anywhere, count, types, ...more },
    goals: [{ statistic: 'mean', sense: 'near', target: 40, weight: 1, surfaces: ['floor'] }],
    constraints,
    ...(glare && { glare }),
  };
  expect(session.adopt(making, coreIntentions(asked, scene.surfaces))).toBe('');
  making.delete();
  const mounted = new MountedSession(session, candidates);
  mounted.ask(asked.luminaires, true);
  expect(mounted.setIntentions(coreIntentions(asked, scene.surfaces))).toBe('');
  return mounted;
}

const valid = <T>(value: T | string): T => {
  if (typeof value === 'string') throw new Error(value);
  return value;
};
const light = (session: MountedSession, layout: Layout) => valid(session.show(...session.take(layout)));
const layoutOf = (hung: readonly (readonly [number, LuminaireType])[]): Layout => ({
  sites: hung.map(([site]) => site),
  flux: hung.map(([, { flux }]) => flux),
  dimming: 1,
  mountings: hung.map(([, { id }]) => ({ type: id, turn: 0, aim: null })),
});

test('the file has an operator, and its room says so', () => {
  expect(scene.hasOperator).toBe(true);
});

test('light of several types adds up, and is as strong as their lumens', () => {
  const session = sessionOf([spot, panel]);
  const both = light(
    session,
    layoutOf([
      [8, spot],
      [21, panel],
    ]),
  );
  const one = light(session, layoutOf([[8, spot]]));
  const other = light(session, layoutOf([[21, panel]]));
  both.illuminance.forEach((value, p) =>
    expect(value).toBeCloseTo(one.illuminance[p]! + other.illuminance[p]!, 3),
  );
  const twice = light(sessionOf([{ ...spot, flux: 2400 }]), layoutOf([[8, spot]]));
  twice.illuminance.forEach((value, p) => expect(value).toBeCloseTo(2 * one.illuminance[p]!, 3));
  expect(both.layout.mountings).toEqual(
    layoutOf([
      [8, spot],
      [21, panel],
    ]).mountings,
  );
  expect([...both.layout.flux]).toEqual([1200, 3600]);
});

test('what observers see of candidates is looked for one place after the other', () => {
  const candidates = candidatesOf([spot], () => undefined, scene).filter(({ site }) => sites.includes(site));
  const eyes = [0.5, 0.7, 0.9].map((x, i) => ({
    name: `P${i}`,
    position: [x, 1.2, 1],
    direction: [1, 0, 0],
  }));
  const glare = { max: 10, observers: eyes } as unknown as Intentions['glare'];
  const luminaires = {
    ...anywhere,
    count: 1,
    types: [spot],
  } as const;
  const asked = coreIntentions(
    { quantity: 'illuminance', luminaires, goals: [], constraints: [], ...(glare && { glare }) },
    scene.surfaces,
  );
  const [plain, observed] = [false, true].map((isObserved) => {
    const making = new core.Candidates();
    beginCandidates(making, room, candidates, fileOf);
    if (isObserved) making.observe(asked);
    let slices = 1;
    while (!making.advance(1000)) ++slices;
    expect(slices).toBe(isObserved ? eyes.length : 1);
    const session = new core.Session();
    expect(session.adopt(making, asked)).toBe('');
    making.delete();
    const mounted = new MountedSession(session, candidates);
    mounted.ask(luminaires, false);
    expect(mounted.setIntentions(asked)).toBe('');
    return light(mounted, layoutOf([[8, spot]]));
  });
  expect([...observed!.observers.numbers]).toEqual([...plain!.observers.numbers]);
  expect(observed!.observers.names).toEqual(['P0', 'P1', 'P2']);
});

test('a luminaire on a dark place is not shown as one without light', () => {
  const candidates = candidatesOf([spot], () => undefined, scene).filter(({ site }) => sites.includes(site));
  const dark = new Set([8]);
  const making = new core.Candidates();
  beginCandidates(making, room, candidates, fileOf);
  making.leaveDark(
    Uint32Array.from(candidates.flatMap(({ site }, index) => (dark.has(site) ? [index] : []))),
  );
  while (!making.advance(5)) continue;
  const luminaires = { ...anywhere, count: 2, excluded: [...dark], types: [spot] } as const;
  const goals = [{ statistic: 'mean', sense: 'max', weight: 1, surfaces: ['floor'] }] as const;
  const asked = coreIntentions(
    { quantity: 'illuminance', luminaires, goals, constraints: [] },
    scene.surfaces,
  );
  const session = new core.Session();
  expect(session.adopt(making, asked)).toBe('');
  making.delete();
  const mounted = new MountedSession(session, candidates, dark);
  mounted.ask(luminaires, true);
  expect(mounted.setIntentions(asked)).toBe('');
  const both = layoutOf([
    [8, spot],
    [21, spot],
  ]);
  expect(mounted.has(both)).toBe(false);
  expect(mounted.has(layoutOf([[21, spot]]))).toBe(true);
  expect([...light(mounted, both).layout.sites]).toEqual([21]);
  // Nor does a search go there.
  expect(mounted.start(1)).toBe('');
  valid(mounted.advance(2_000));
  const found = valid(mounted.incumbent());
  expect(found.layout.sites).toHaveLength(2);
  expect(found.layout.sites).not.toContain(8);
  expect(Math.min(...found.illuminance)).toBeGreaterThanOrEqual(0);
});

test('a rule binds a search that has all candidates, not the places of one layout', () => {
  const session = sessionOf([panel]);
  const luminaires = {
    ...anywhere,
    count: 5,
    types: [panel],
    arrangement: { rule: 'field' },
  } as const;
  const asked = { quantity: 'illuminance', luminaires, goals: [], constraints: [] } as const;
  const refusal = (hasAll: boolean, more: Partial<Intentions['luminaires']> = {}) => {
    session.ask(luminaires, hasAll);
    const wished = { ...asked, luminaires: { ...luminaires, ...more } };
    return session.setIntentions(coreIntentions(wished, scene.surfaces));
  };
  expect(refusal(true)).toMatch(/found no regular field of 5/);
  expect(refusal(false)).toBe('');
  const excluded = sites.slice(4);
  expect(refusal(true, { excluded })).toMatch(/5 luminaires on 4 free sites/);
  expect(refusal(false, { excluded })).toBe('');
});

test('a spot that is aimed is brightest where it is aimed', () => {
  const shown = shownOf(light(sessionOf([spot]), layoutOf([[8, spot]])), 0, scene.surfaces);
  const brightest = shown.illuminance.indexOf(Math.max(...shown.illuminance));
  const { position } = scene.sites;
  expect(scene.patchCenter[3 * brightest]).toBeCloseTo(position[24]!, 0);
  const target = [0, 1, 2].map((i) => scene.patchCenter[3 * 40 + i]!) as [number, number, number];
  const aimed = light(sessionOf([{ ...spot, aims: [target] }]), layoutOf([[8, spot]])).illuminance;
  expect(aimed[40]).toBeGreaterThan(3 * shown.illuminance[40]!);
});

/** How near to its aim the best layout of so many luminaires comes, every one of them tried. */
function bestOfAll(types: readonly LuminaireType[], count: number): number {
  const session = sessionOf(types, count);
  const best = (hung: readonly (readonly [number, LuminaireType])[], from: number): number => {
    if (hung.length === count) return light(session, layoutOf(hung)).goals[0] ?? Infinity;
    const more = sites
      .slice(from)
      .flatMap((site, i) => types.map((type) => best([...hung, [site, type]], from + i + 1)));
    return Math.min(...more);
  };
  return best([], 0);
}

test.each([1, 2, 3])('place and type of %i are found together, as well as by trying everything', (count) => {
  const [spots, panels, both] = [[spot], [panel], [spot, panel]].map((types) => bestOfAll(types, count));
  expect(both).toBeLessThanOrEqual(Math.min(spots!, panels!));
  const session = sessionOf([spot, panel], count);
  expect(session.start(3)).toBe('');
  session.advance(20_000);
  const found = valid(session.incumbent());
  expect(found.goals[0]).toBeCloseTo(both!, 6);
  expect(new Set(found.layout.sites).size).toBe(count);
});

test('a slider of paint that comes back to where it was brings back the light, patch by patch', () => {
  const candidates = candidatesOf([spot], () => undefined, scene).filter(({ site }) => sites.includes(site));
  const [leaf, wall] = [...scene.surfaces.entries()].find(([, { measuring }]) => !measuring)!;
  const asked = coreIntentions(
    {
      quantity: 'illuminance',
      luminaires: { count: 2, flux: 1, dimming: [1, 1], pinned: [], excluded: [], minDistance: 0 },
      goals: [],
      constraints: [],
    },
    scene.surfaces,
  );
  const lightOf = (paint: readonly number[]) => {
    const base = new core.Candidates();
    beginCandidates(base, room, candidates, fileOf);
    while (!base.advance(5)) continue;
    const painted = new core.Candidates();
    expect(painted.beginPainted(base, room, Float64Array.from(paint))).toBe('');
    while (!painted.advance(5)) continue;
    const session = new core.Session();
    expect(session.adopt(painted, asked)).toBe('');
    for (const each of [base, painted]) each.delete();
    const mounted = new MountedSession(session, candidates);
    expect(mounted.setIntentions(asked)).toBe('');
    return light(
      mounted,
      layoutOf([
        [8, spot],
        [21, spot],
      ]),
    ).illuminance;
  };
  const before = lightOf([]);
  const lighter = lightOf([leaf, 0.9]);
  const back = lightOf([leaf, wall.reflectance]);
  expect(Math.max(...lighter.map((value, p) => value / before[p]!))).toBeGreaterThan(1.01);
  back.forEach((value, p) => expect(Math.abs(value - before[p]!)).toBeLessThanOrEqual(1e-6 * before[p]!));
});

test('counts of types are kept, and a luminaire is of the type that it must be', () => {
  const ofTypes = (session: MountedSession) => {
    expect(session.start(5)).toBe('');
    session.advance(5_000);
    return valid(session.incumbent()).layout.mountings?.map(({ type }) => type);
  };
  const counted = ofTypes(sessionOf([{ ...spot, count: [1, 1] }, panel], 3));
  expect(counted?.filter((type) => type === 's')).toHaveLength(1);
  const asked = ofTypes(sessionOf([spot, panel], 3, { ofType: [null, 's', 'p'] }));
  expect(asked?.slice(1)).toEqual(['s', 'p']);
});

test('power is in watts, of a type without any by a usual efficacy', () => {
  const silent = { ...panel, watts: 0 }; // 3600 lm
  const session = sessionOf([spot, silent], 2, {}, [{ statistic: 'power', max: 1, surfaces: [] }]);
  const both = layoutOf([
    [8, spot],
    [21, panel],
  ]);
  expect(light(session, both).constraints[0]).toBeCloseTo(10 + 30, 6);
});

test('direct light is a part of all light, of candidates as of squares', () => {
  const onFloor = { statistic: 'mean', min: 1, surfaces: ['floor'] } as const;
  const constraints = [{ ...onFloor, quantity: 'direct' } as const, onFloor];
  const asked = sessionOf([spot], 1, {}, constraints);
  const [direct, all] = shownOf(light(asked, layoutOf([[8, spot]])), 0, scene.surfaces).constraints;
  expect(direct!.value).toBeGreaterThan(0);
  expect(direct!.value).toBeLessThan(all!.value);
  const squares = { count: 1, flux: 100, dimming: [1, 1], pinned: [], excluded: [], minDistance: 0 } as const;
  const wishes: Intentions = { quantity: 'direct', luminaires: squares, goals: [], constraints: [onFloor] };
  expect(room.setIntentions(coreIntentions(wishes, scene.surfaces))).toBe('');
  const shown = valid(room.show(Uint32Array.of(8), Float64Array.of(100), 1));
  expect(shown.illuminance).toEqual(shown.direct);
  expect(shown.constraints[0]).toBeCloseTo(shown.surfaces[0]!, 6);
});

test('which paint helps is told of glare, direct light and faces, for luminaires of types', () => {
  const constraints = [
    { statistic: 'mean', min: 1, surfaces: ['floor'] },
    { statistic: 'mean', min: 1, surfaces: ['floor'], quantity: 'direct' },
    { statistic: 'cylindrical', min: 1, surfaces: ['desk plane'] },
  ] as const;
  const observers = [{ name: 'me', position: [0.5, 1.2, 1], direction: [1, 0, 0] }] as const;
  const glare = { max: 10, observers };
  const session = sessionOf([panel], 2, {}, constraints, glare);
  const layout = layoutOf([
    [8, panel],
    [21, panel],
  ]);
  const asked = coreIntentions(
    {
      quantity: 'illuminance',
      luminaires: { count: 2, flux: 1, dimming: [1, 1], pinned: [], excluded: [], minDistance: 0 },
      goals: [],
      constraints,
      glare,
    },
    scene.surfaces,
  );
  const numbers = valid(session.paintGains(room, asked, new Float64Array(), ...session.take(layout)));
  const gains = gainsOf(numbers, asked);
  expect(gains.map(({ surface }) => surface)).toEqual([0, 1]); // the plane only measures
  for (const { constraints: gained } of gains) {
    const [mean, direct, faces, ugr] = gained;
    expect(mean).toBeGreaterThan(0);
    expect(direct).toBe(0);
    expect(faces).toBeGreaterThan(0);
    expect(ugr).toBeLessThan(-0.01); // against a brighter room it glares less
  }
  expect(
    session.paintGains(room, { ...asked, glare: null }, new Float64Array(), ...session.take(layout)),
  ).toMatch(/nobody looks|does not tell/);
});

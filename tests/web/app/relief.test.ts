/** Which bounds conflict and what would do instead, with a search that knows what its room can give. Covers round-steps. */
import { expect, test } from '@jest/globals';
import { findRelief } from '../../../web/app/relief.ts';
import { roundFlux, roundSteps } from '../../../web/app/words/round-steps.ts';
import type { Constraint, Intentions } from '../../../web/document/types.ts';

const layout = { sites: [1], flux: [1000], dimming: 1 };
const floor = (min: number): Constraint => ({ statistic: 'mean', surfaces: ['floor'], min });
const ceiling = (max: number): Constraint => ({ statistic: 'mean', surfaces: ['ceiling'], max });
const wall = (min: number): Constraint => ({ statistic: 'mean', surfaces: ['wall'], min });

const wish = (...constraints: Constraint[]): Intentions => ({
  luminaires: { count: 2, flux: 1000, dimming: [1, 1], pinned: [], excluded: [], minDistance: 0 },
  goals: [],
  constraints,
  quantity: 'illuminance',
});

/** A room whose floor gets at most 0.43 lx per lm, whose ceiling gets a quarter of the floor's, and whose wall gets anything. */
function tried(log: Intentions[] = []) {
  return async (asked: Intentions) => {
    log.push(asked);
    const of = (name: string) => asked.constraints.find(({ surfaces }) => surfaces[0] === name);
    const least = of('floor')?.min ?? 0;
    const met = least <= 0.43 * asked.luminaires.flux && least / 4 <= (of('ceiling')?.max ?? Infinity);
    return { layout, lumens: 1, met, violation: met ? 0 : 1 };
  };
}

const missed = (value: number, margin: number) => ({ value, met: margin >= 0, margin });

test('a bound that is beyond the room is named alone, with the round number that is met', async () => {
  const log: Intentions[] = [];
  const asked = wish(wall(50), floor(500));
  const relief = await findRelief(asked, [missed(80, 0.6), missed(430, -0.14)], tried(log));
  expect(relief.conflict).toEqual([1]);
  expect(relief.isEach).toBe(false);
  expect(relief.single).toEqual([{ change: { constraint: 1, bound: 430 }, layout }]);
  expect(relief.flux?.change).toBe(1200);
  expect(relief.together).toBeNull();
  expect(log.length).toBeLessThan(20);
});

test('of two that contradict each other both are named, also the one that is met', async () => {
  const asked = wish(wall(50), floor(400), ceiling(80));
  const relief = await findRelief(asked, [missed(80, 0.6), missed(320, -0.2), missed(80, 0)], tried());
  expect(relief.conflict).toEqual([1, 2]);
  expect(relief.isEach).toBe(false);
  expect(relief.single.map(({ change }) => change)).toEqual([
    { constraint: 1, bound: 320 },
    { constraint: 2, bound: 105 },
  ]);
  expect(relief.flux).toBeNull();
});

test('a least above the most of one figure is named with it, also where only the other is beyond the room', async () => {
  const room = async ({ constraints }: Intentions) => {
    const met = constraints.every(({ min = 0, max = Infinity }) => min <= 700 && max >= 570); // as bright as they are
    return { layout, lumens: 1, met, violation: met ? 0 : 1 };
  };
  const most: Constraint = { statistic: 'mean', surfaces: ['floor'], max: 300 };
  const relief = await findRelief(
    wish(wall(50), floor(500), most),
    [missed(80, 0.6), missed(570, 0.14), missed(570, -0.9)],
    room,
  );
  expect(relief.isCrossed).toBe(true);
  expect(relief.conflict).toEqual([2, 1]);
  expect(relief.isEach).toBe(false);
  expect(relief.single.map(({ change }) => change)).toEqual([{ constraint: 2, bound: 570 }]);
  const even = await findRelief(
    wish(floor(500), { ...most, surfaces: ['wall'] }),
    [missed(1, 1), missed(570, -1)],
    room,
  );
  expect(even.isCrossed).toBe(false);
});

test('where no single bound is in the way, those that are missed are eased together', async () => {
  const room = async (asked: Intentions) => {
    const isMet = asked.constraints.every(({ min = 0 }) => min <= 100);
    return { layout, lumens: 1, met: isMet, violation: isMet ? 0 : 1 };
  };
  const relief = await findRelief(wish(floor(200), wall(300)), [missed(100, -0.5), missed(100, -0.7)], room);
  expect(relief.conflict).toEqual([1, 0]); // the one that is missed by more first
  expect(relief.isEach).toBe(true);
  expect(relief.single).toEqual([]);
  expect(relief.together?.change).toEqual([
    { constraint: 0, bound: 100 },
    { constraint: 1, bound: 100 },
  ]);
});

test('a guarantee by statistics may do as one of every patch', async () => {
  const room = async ({ constraints }: Intentions) => {
    const met = constraints.every(({ statistic, min = 0 }) => statistic === 'minimum' || min < 20);
    return { layout, lumens: 1, met, violation: met ? 0 : 1 };
  };
  const guarantee: Constraint = { statistic: 'chebyshev', surfaces: ['floor'], alpha: 2, min: 50 };
  const relief = await findRelief(wish(guarantee), [missed(19, -0.6)], room);
  expect(relief.patches.map(({ change }) => change)).toEqual([0]);
});

test('rules about places that stand in the way are named with what would do', async () => {
  const room = async ({ luminaires }: Intentions) => {
    const met = luminaires.minDistance <= 1.3 || luminaires.excluded.length === 1;
    return { layout, lumens: 1, met, violation: met ? 0 : 1 };
  };
  const asked = wish(floor(200));
  const luminaires = { ...asked.luminaires, minDistance: 1.8, excluded: [4, 5, 6] };
  const { rules } = await findRelief({ ...asked, luminaires }, [missed(100, -0.5)], room, [5]);
  expect(rules).toEqual([
    { change: { rule: 'apart', least: 1.3 }, layout },
    { change: { rule: 'places', excluded: [5] }, layout },
  ]);
  expect((await findRelief(asked, [missed(100, -0.5)], room)).rules).toEqual([]);
});

test('steps are round, and each asks for less', () => {
  const down = roundSteps(500, 'min', false, 437);
  expect(down.slice(0, 3)).toEqual([490, 480, 475]);
  expect(down).toContain(435);
  expect([...down].sort((a, b) => b - a)).toEqual(down);
  expect(roundSteps(19, 'max', false, 25)[0]).toBeGreaterThan(19);
  expect(roundSteps(0.6, 'min', true, 0.41)).toEqual(expect.arrayContaining([0.59, 0.41]));
  expect(roundSteps(0, 'max', false, 3)).toEqual([]);
  expect(roundFlux(3400).slice(0, 2)).toEqual([3500, 3600]);
});

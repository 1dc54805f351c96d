import { describe, expect, test } from '@jest/globals';
import { folded } from '../../../web/app/rooms/families.ts';
import { bindingBounds, easedCards, fluxThatWouldDo, opposedCards } from '../../../web/app/words/explain.ts';
import {
  compact,
  duration,
  easedBound,
  niceCeiling,
  niceStep,
  percent,
  percentAtMost,
  spanText,
  tabular,
} from '../../../web/app/words/format.ts';
import { coreOrder, fromCore, toCore } from '../../../web/app/state/luminaire-order.ts';
import {
  histogram,
  patchesOf,
  promises,
  sampleOf,
  shareBelow,
  unionOf,
} from '../../../web/app/state/statistics.ts';
import { leavesOf } from '../../../web/document/surface-names.ts';
import { documentFrom } from '../../../web/app/rooms/opening-wish.ts';
import { intentionsOf } from '../../../web/document/intentions.ts';
import type { Card, Verb } from '../../../web/document/types.ts';
import { readNumber } from '../../../web/panel/controls/number-field.tsx';
import { stepped } from '../../../web/panel/controls/slider.tsx';
import { innerNodes } from '../../../web/panel/intentions/surface-picker.tsx';
import { precomputeLine } from '../../../web/panel/preview-note.tsx';
import { fakeScene } from '../fake-solver.ts';

test('a proved gap is never told smaller than it is', () => {
  expect([0, 0.0001, 0.0084, 0.05, 0.0992, 0.0996, 0.189].map(percentAtMost)).toEqual([
    '0.0 %',
    '0.1 %',
    '0.9 %',
    '5.0 %',
    '10.0 %',
    '10 %',
    '19 %',
  ]);
});

test('times in the unit that keeps them short', () => {
  expect([0.84, 42.4, 999.4, 2818].map(duration)).toEqual(['0.8 ms', '42 ms', '999 ms', '2.8 s']);
});

test('numbers as people write them', () => {
  expect([0, 0.0123, 1.234, 12.34, 123.4, 1234.5].map(compact)).toEqual([
    '0',
    '0.0123',
    '1.23',
    '12.3',
    '123',
    '1\u202f235',
  ]);
  expect([0, 0.0004, 0.0979, 0.996, 1.03, 606].map(tabular)).toEqual([
    '0',
    '< 0.01',
    '0.10',
    '1.00',
    '1.03',
    '606',
  ]);
  expect([0, 0.0004, 0.052, 0.5, 1].map(percent)).toEqual(['0.0 %', '< 0.1 %', '5.2 %', '50 %', '100 %']);
  expect([0.7, 1, 12, 130, 999].map(niceCeiling)).toEqual([0.8, 1, 15, 150, 1000]);
  expect([200, 1000, 30].map(niceStep)).toEqual([1, 5, 0.2]);
  expect(['1.250,5', '1,250.5', "1'250.5", '1.000.000,', '1,5.5'].map((text) => readNumber(text))).toEqual([
    1250.5,
    1250.5,
    1250.5,
    1e6,
    null,
  ]);
  expect(['300 lx', '300lx', '300 m', 'lx'].map((text) => readNumber(text, 'lx'))).toEqual([
    300,
    300,
    null,
    null,
  ]);
  expect(['1 250,5', '.5', '-3', '1e3', '', 'abc', '1.2.3'].map((text) => readNumber(text))).toEqual([
    1250.5,
    0.5,
    -3,
    null,
    null,
    null,
    null,
  ]);
});

test('an eased bound can be met by what is reached', () => {
  for (const value of [0.123456, 9.999, 285.3, 1234.5, 31.4159]) {
    expect(easedBound(value, 'min')).toBeLessThan(value);
    expect(easedBound(value, 'max')).toBeGreaterThan(value);
    expect(easedBound(value, 'min')).toBeGreaterThan(value * 0.985);
    expect(easedBound(value, 'max')).toBeLessThan(value * 1.015);
  }
});

test('arrows step, Shift ten times, Alt a tenth', () => {
  const key = (name: string, more = {}) => ({ key: name, shiftKey: false, altKey: false, ...more });
  expect(stepped(key('ArrowRight'), 100, 5)).toBe(105);
  expect(stepped(key('ArrowDown', { shiftKey: true }), 100, 5)).toBe(50);
  expect(stepped(key('ArrowUp', { altKey: true }), 100, 5)).toBe(100.5);
  expect(stepped(key('a'), 100, 5)).toBeNull();
});

describe('statistics of an area', () => {
  const scene = {
    ...fakeScene(),
    surfaceOfPatch: Uint32Array.of(0, 0, 1),
    patchArea: Float32Array.of(1, 3, 2),
    patchReflectance: Float32Array.of(0.8, 0.4, 0.25),
  };
  const light = Float32Array.of(2, 6, 8);
  const sample = sampleOf(scene, light, patchesOf(scene, [0]), 'illuminance')!;

  test('are population statistics weighted by area', () => {
    expect(sample.mean).toBeCloseTo(5);
    expect(sample.sigma).toBeCloseTo(1.7320508);
    expect([sample.least, sample.most]).toEqual([2, 6]);
  });

  test('exitance is what each patch reflects, not the mean of its surface', () => {
    const floor = sampleOf(scene, light, patchesOf(scene, [0]), 'exitance')!;
    expect(floor.mean).toBeCloseTo((1 * 2 * 0.8 + 3 * 6 * 0.4) / 4);
    expect([floor.least, floor.most].map((value) => value.toFixed(3))).toEqual(['1.600', '2.400']);
    expect(sampleOf(scene, light, patchesOf(scene, [1]), 'exitance')?.mean).toBeCloseTo(2);
    expect(sampleOf(scene, light, new Uint32Array(), 'exitance')).toBeNull();
  });

  test('shares are shares of the area', () => {
    expect(shareBelow(sample, 2)).toBe(0);
    expect(shareBelow(sample, 5)).toBeCloseTo(0.25);
    expect(shareBelow(sample, 7)).toBe(1);
    expect(histogram(sample, 8, 4)).toEqual([0, 0.25, 0, 0.75]);
  });

  test('the promises hold for the true share', () => {
    for (const alpha of [0.5, 1, 1.5, 2]) {
      const share = shareBelow(sample, sample.mean - alpha * sample.sigma);
      expect(share).toBeLessThanOrEqual(promises(alpha).cantelli + 1e-9);
      expect(promises(alpha).cantelli).toBeLessThanOrEqual(promises(alpha).chebyshev);
    }
    expect(promises(2)).toEqual({ chebyshev: 0.25, cantelli: 0.2 });
  });

  test('names resolve to leaves', () => {
    const leaf = (name: string, measuring = false) => ({
      name,
      measuring,
      area: 1,
      patches: 1,
      reflectance: 0,
      lost: 0,
    });
    const leaves = [leaf('desk/top'), leaf('desk/leg'), leaf('plane', true), leaf('desks')];
    expect(leavesOf(['desk'], leaves)).toEqual([0, 1]);
    expect(leavesOf(['all'], leaves)).toEqual([0, 1, 3]);
    expect(leavesOf(['plane', 'desk/top'], leaves)).toEqual([0, 2]);
  });
});

test('families of numbered surfaces fold into one line, where their first member stood', () => {
  const names = [
    'floor',
    'desk 2',
    'desk 10',
    'door',
    'desk 1',
    'desk 3',
    'chair 1',
    'room/wall 1',
    'room/wall 4',
  ];
  const lines = folded(names, (name) => name);
  expect(lines.map(({ title }) => title)).toEqual([
    'floor',
    'desk 1–3, 10',
    'door',
    'chair 1',
    'room/wall 1, 4',
  ]);
  expect(lines[1]?.items).toEqual(['desk 1', 'desk 2', 'desk 3', 'desk 10']);
  expect(folded(['a 1', 'a 3', 'a 5', 'a 7'], (name) => name)[0]?.title).toBe('a (4)');
  expect(innerNodes(['room/floor', 'room/wall 1', 'desk', 'box/lid'])).toEqual(['room']);
});

test('the readings of a family are those of all its patches together', () => {
  const row = (name: string, area: number, mean: number, sigma: number) => ({
    name,
    area,
    mean,
    sigma,
    min: mean - sigma,
    max: mean + sigma,
  });
  // Two values a surface, half of its area each: 1 m2 of 9 and 11, 3 m2 of 18 and 22.
  const union = unionOf([row('desk 1', 1, 10, 1), row('desk 2', 3, 20, 2)]);
  const values = [9, 11, 18, 22];
  const shares = [0.125, 0.125, 0.375, 0.375];
  const mean = values.reduce((sum, value, i) => sum + value * shares[i]!, 0);
  const variance = values.reduce((sum, value, i) => sum + (value - mean) ** 2 * shares[i]!, 0);
  expect(union).toMatchObject({ min: 9, max: 22 });
  expect(union.mean).toBeCloseTo(mean, 10);
  expect(union.sigma).toBeCloseTo(Math.sqrt(variance), 10);
  expect([spanText(487.2, 561.6), spanText(500.1, 500.2)]).toEqual(['487–\u200b562', '500']);
});

test('tags stay with their luminaires when pinned ones go first', () => {
  const layout = { sites: [10, 20, 30], flux: [1, 2, 3], dimming: 1 };
  const order = coreOrder(layout, [30]);
  expect(toCore(layout, order).sites).toEqual([30, 10, 20]);
  expect(fromCore(toCore(layout, order), order)).toEqual(layout);
  const moved = fromCore({ sites: [30, 11, 21], flux: [3, 1, 2], dimming: 1 }, order);
  expect(moved.sites).toEqual([11, 21, 30]);
  const fewer = fromCore({ sites: [30, 10], flux: [3, 1], dimming: 1 }, order);
  expect([...fewer.sites].sort()).toEqual([10, 30]);
  const more = fromCore({ sites: [30, 10, 20, 40], flux: [3, 1, 2, 4], dimming: 1 }, order);
  expect(more.sites).toEqual([10, 20, 30, 40]);
});

test('what cannot be met is named with the bound that could', () => {
  const card: Card = { id: 'c', surfaces: ['floor'], verb: 'keep', weight: 1, mean: { min: 300, max: 400 } };
  const asked = { cards: [card], saving: false, quantity: 'illuminance', seed: 1 } as const;
  const luminaires = {
    count: 2,
    flux: 1000,
    dimming: [1, 1],
    pinned: [],
    excluded: [],
    minDistance: 0,
  } as const;
  const document = documentFrom({ ...asked, luminaires }, '', 'box');
  const { origins } = intentionsOf(document);
  const results = [
    { value: 150, met: false, violation: 0.5, margin: -0.5 },
    { value: 150, met: true, violation: 0, margin: 0.6 },
  ];
  const bounds = bindingBounds(document, origins, results);
  expect(bounds).toMatchObject([{ field: 'mean.min', asked: 300, reached: 150, eased: 149 }]);
  expect(easedCards(document.cards, bounds)[0]?.mean).toEqual({ min: 149, max: 400 });
  expect(fluxThatWouldDo(document, bounds)).toBe(2010);
  expect(fluxThatWouldDo(document, [])).toBeNull();
});

test('the line that makes a room live survives any file name', () => {
  expect(precomputeLine('office.glb')).toBe('fiatlux precompute office.glb -o office.flux');
  expect(precomputeLine("my o'ffice.GLB")).toBe(
    "fiatlux precompute 'my o'\\''ffice.GLB' -o 'my o'\\''ffice.flux'",
  );
  expect(precomputeLine('-rf.glb')).toContain("'-rf.glb'");
});

test('goals that pull the same surfaces in opposite directions are named', () => {
  const card = (id: string, verb: Verb, surfaces: string[], weight = 1) => ({ id, verb, surfaces, weight });
  const pairs = (...cards: Card[]) => opposedCards(cards).map((pair) => pair.map(({ id }) => id));
  const up = card('up', 'illuminate', ['floor', 'wall']);
  expect(pairs(card('down', 'overshadow', ['wall', 'floor']), up)).toEqual([['up', 'down']]);
  expect(pairs(up, card('down', 'overshadow', ['wall']))).toEqual([]);
  expect(pairs(up, card('down', 'overshadow', ['wall', 'floor'], 0))).toEqual([]);
  expect(pairs(up, card('vary', 'vary', ['floor', 'wall']))).toEqual([]);
});

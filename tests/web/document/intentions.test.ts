import { describe, expect, test } from '@jest/globals';
import { documentFrom } from '../../../web/app/rooms/opening-wish.ts';
import {
  asksForDirect,
  boundOf,
  crossedEnds,
  intentionsOf,
  keepRange,
  typeLimits,
  upToOther,
  withBound,
  type BoundField,
} from '../../../web/document/intentions.ts';
import type { Card, FiatLuxDocument } from '../../../web/document/types.ts';
import { luminaireType, photometricText } from './luminaire-type.ts';

const wall: Card = { id: 'w', surfaces: ['wall'], verb: 'homogenize', weight: 1 };
const documentOf = (cards: readonly Card[], more: Partial<FiatLuxDocument> = {}): FiatLuxDocument => ({
  ...documentFrom(
    {
      cards,
      saving: false,
      luminaires: { count: 2, flux: 100, dimming: [1, 1], pinned: [], excluded: [], minDistance: 0 },
      quantity: 'illuminance',
      seed: 1,
    },
    '',
    'box',
  ),
  ...more,
});
const asked = (card: Partial<Card>) => intentionsOf(documentOf([{ ...wall, ...card }]));

describe('verbs become goals', () => {
  test.each([
    ['illuminate', 'mean', 'max'],
    ['overshadow', 'mean', 'min'],
    ['homogenize', 'sigma', 'min'],
    ['vary', 'sigma', 'max'],
  ] as const)('%s = %s %s', (verb, statistic, sense) => {
    expect(asked({ verb }).intentions.goals).toEqual([{ statistic, sense, weight: 1, surfaces: ['wall'] }]);
  });

  test('a mean that is aimed at takes the place of its extreme, and comes before the spread', () => {
    for (const verb of ['illuminate', 'overshadow'] as const)
      expect(asked({ verb, aim: 500 }).intentions.goals).toEqual([
        { statistic: 'mean', sense: 'near', target: 500, weight: 1, surfaces: ['wall'] },
      ]);
    const { intentions, goalCards } = asked({ verb: 'homogenize', aim: 500, weight: 2 });
    expect(intentions.goals).toEqual([
      { statistic: 'mean', sense: 'near', target: 500, weight: 20, surfaces: ['wall'] },
      { statistic: 'sigma', sense: 'min', weight: 2, surfaces: ['wall'] },
    ]);
    expect(goalCards).toEqual(['w', 'w']);
    expect(asked({ verb: 'keep', aim: 500 }).intentions.goals).toEqual([]);
  });
});

test('a card of direct light speaks of nothing else', () => {
  const { intentions } = asked({ verb: 'illuminate', direct: true, mean: { min: 1 } });
  expect(intentions.goals).toEqual([
    { statistic: 'mean', sense: 'max', weight: 1, surfaces: ['wall'], quantity: 'direct' },
  ]);
  expect(intentions.constraints).toEqual([
    { statistic: 'mean', min: 1, surfaces: ['wall'], quantity: 'direct' },
  ]);
  expect(asksForDirect(intentions)).toBe(true);
  expect(asksForDirect({ ...intentions, goals: [], constraints: [] })).toBe(false);
  expect(asksForDirect({ ...asked({}).intentions, quantity: 'direct' })).toBe(true);
});

describe('what else cards ask for becomes constraints', () => {
  test.each([231.3, 0.0537, 12.04, 999.6, 4712.8, 1])(
    'keep asks for round bounds that %f lx meets',
    (mean) => {
      const { min, max } = keepRange(mean);
      for (const bound of [min, max]) expect(bound).toBe(Number(bound.toPrecision(3)));
      expect(min).toBeGreaterThanOrEqual(0.9 * mean - 1e-9);
      expect(max).toBeLessThanOrEqual(1.1 * mean + 1e-9);
      expect(min).toBeLessThan(mean);
      expect(max).toBeGreaterThan(mean);
    },
  );

  test('keep is a range of +-10 % around the present mean and no goal', () => {
    const range = keepRange(200);
    expect(range.min).toBeCloseTo(180);
    expect(range.max).toBeCloseTo(220);
    const { intentions, origins } = asked({ verb: 'keep', mean: range });
    expect(intentions.goals).toEqual([]);
    expect(intentions.constraints).toEqual([
      { statistic: 'mean', min: range.min, surfaces: ['wall'] },
      { statistic: 'mean', max: range.max, surfaces: ['wall'] },
    ]);
    expect(origins.map((origin) => origin.field)).toEqual(['mean.min', 'mean.max']);
  });

  test('every bound is a constraint that knows where it came from', () => {
    const { intentions, origins } = asked({
      mean: { min: 1, max: 2 },
      spread: { min: 3, max: 4 },
      guarantee: { by: 'chebyshev', alpha: 2, min: 5, max: 6 },
      uniformity: 0.7,
      contrast: { over: ['floor'], min: 8 },
    });
    expect(intentions.constraints).toEqual([
      { statistic: 'mean', min: 1, surfaces: ['wall'] },
      { statistic: 'mean', max: 2, surfaces: ['wall'] },
      { statistic: 'sigma', min: 3, surfaces: ['wall'] },
      { statistic: 'sigma', max: 4, surfaces: ['wall'] },
      { statistic: 'chebyshev', alpha: 2, min: 5, surfaces: ['wall'] },
      { statistic: 'chebyshev', alpha: 2, max: 6, surfaces: ['wall'] },
      { statistic: 'uniformity', min: 0.7, surfaces: ['wall'] },
      { statistic: 'contrast', min: 8, over: ['floor'], surfaces: ['wall'] },
    ]);
    expect(origins).toHaveLength(intentions.constraints.length);
    expect(origins.every((origin) => origin.card === 'w')).toBe(true);
  });

  test('a guarantee by patches asks for the true minimum and maximum', () => {
    const { intentions } = asked({ guarantee: { by: 'patches', alpha: 2, min: 5, max: 6 } });
    expect(intentions.constraints.map((constraint) => constraint.statistic)).toEqual(['minimum', 'maximum']);
  });

  test('a bound of zero asks for nothing; a weight of zero is no goal', () => {
    expect(
      asked({ mean: { min: 0 }, guarantee: { by: 'patches', alpha: 1, min: 0 } }).intentions.constraints,
    ).toEqual([]);
    expect(asked({ weight: 0 }).intentions.goals).toEqual([]);
  });

  test('saving power of what cannot be dimmed means fewer, where their number is not free anyway', () => {
    const asked = (change: object) => {
      const document = documentOf([wall], { saving: true });
      const { luminaires } = document;
      return intentionsOf({ ...document, luminaires: { ...luminaires, ...change } }).intentions.luminaires;
    };
    expect(asked({ count: 6, dimming: [1, 1], pinned: [4, 5] })).toMatchObject({ count: 2, most: 6 });
    expect(asked({ count: 6, dimming: [0.1, 1] })).not.toHaveProperty('most');
    expect(asked({ count: 3, most: 8, dimming: [1, 1] })).toMatchObject({ count: 3, most: 8 });
  });

  test('saving power is a goal of its own', () => {
    const { intentions, goalCards } = intentionsOf(documentOf([wall], { saving: true }));
    expect(intentions.goals.at(-1)).toMatchObject({ statistic: 'power', sense: 'min' });
    expect(goalCards).toEqual(['w', null]);
  });
});

describe('bounds of a card', () => {
  test.each<[BoundField, number]>([
    ['mean.min', 3],
    ['mean.max', 4],
    ['spread.min', 1],
    ['spread.max', 2],
    ['guarantee.min', 5],
    ['guarantee.max', 6],
    ['uniformity', 0.5],
  ])('%s is set, read and taken away without a trace', (field, value) => {
    const set = withBound(wall, field, value);
    expect(boundOf(set, field)).toBe(value);
    expect(withBound(set, field, undefined)).toEqual(wall);
    expect(Object.values(withBound(set, field, undefined))).not.toContain(undefined);
  });

  test('an end that passes the other one leaves it as it is, and both are asked for', () => {
    const crossed = withBound(withBound(wall, 'mean.min', 5000), 'mean.max', 200);
    expect(crossed.mean).toEqual({ min: 5000, max: 200 });
    expect(crossedEnds(crossed, 'mean')).toEqual({ min: 5000, max: 200 });
    const { constraints } = intentionsOf(documentOf([crossed])).intentions;
    expect(constraints).toMatchObject([{ min: 5000 }, { max: 200 }]); // one each, as the core takes them
    expect(crossedEnds({ ...wall, mean: { min: 2, max: 2 } }, 'mean')).toBeNull();
    expect(crossedEnds({ ...wall, mean: { min: 2 } }, 'mean')).toBeNull();
    expect(crossedEnds({ ...wall, modelling: { min: 0.6, max: 0.3 } }, 'modelling')).not.toBeNull();
  });

  test('an end that is dragged stops at the other one', () => {
    const both = { ...wall, mean: { min: 1, max: 2 }, uniformity: 0.5 };
    expect(upToOther(both, 'mean.min', 5)).toBe(2);
    expect(upToOther(both, 'mean.max', 0.5)).toBe(1);
    expect(upToOther(both, 'mean.max', 3)).toBe(3);
    expect(upToOther(both, 'uniformity', 0.7)).toBe(0.7);
  });

  test('taking away one end leaves the other', () => {
    const both = withBound(withBound(wall, 'mean.min', 1), 'mean.max', 2);
    expect(withBound(both, 'mean.min', undefined).mean).toEqual({ max: 2 });
  });
});

test('types that may be used allow so many luminaires together', () => {
  const { luminaires } = documentOf([]);
  const type = (id: string, count: readonly [number, number], isAllowed = true) =>
    luminaireType(id, photometricText(), { count, isAllowed });
  const limits = (...types: ReturnType<typeof type>[]) => typeLimits({ ...luminaires, types });
  expect(limits(type('a', [9, 9]), type('b', [2, 2]))).toEqual([11, 11]);
  expect(limits(type('a', [1, 4]), type('b', [2, 2], false))).toEqual([1, 4]);
  expect(limits(type('b', [2, 2], false))).toBeNull(); // squares of light
  expect(typeLimits(luminaires)).toBeNull();
});

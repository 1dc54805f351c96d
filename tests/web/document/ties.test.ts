import { expect, test } from '@jest/globals';
import {
  axisAfter,
  easedAxes,
  heldTogether,
  movedSites,
  tieOf,
  typesRuleOut,
} from '../../../web/document/ties.ts';
import type { Luminaires } from '../../../web/document/types.ts';
import { sixLuminaires } from '../six-luminaires.ts';
import { luminaireType, photometricText } from './luminaire-type.ts';

// A line of five places, 0.6 m apart, and one of them 2 m beside it.
const positions = Float32Array.from([0, 1, 2, 3, 4].flatMap((i) => [0.6 * i, 3, 0]).concat([0, 3, 2]));
const rows = { sites: [0, 1, 5], ties: [0, 0, 1] };

test('a luminaire belongs to its tie, or to nobody', () => {
  expect(tieOf(rows, 0)).toEqual([0, 1]);
  expect(tieOf({ sites: [0, 1] }, 1)).toEqual([1]);
});

test('a row goes as it is, onto its own places too', () => {
  expect(movedSites(rows, 0, 1, 'rows', positions)).toEqual([1, 2, 5]);
  expect(movedSites(rows, 1, 4, 'field', positions)).toEqual([3, 4, 5]);
});

test('where one of a row finds no place, none goes', () => {
  expect(movedSites(rows, 0, 4, 'rows', positions)).toBeNull();
  expect(movedSites(rows, 0, 5, 'rows', positions)).toBeNull();
});

test('free luminaires and mirrored ones go alone, but not onto another', () => {
  expect(movedSites(rows, 0, 3, 'symmetric', positions)).toEqual([3, 1, 5]);
  expect(movedSites({ sites: [0, 1] }, 0, 1, 'free', positions)).toBeNull();
});

test('all that are selected go with the one in the hand, and none where one of them cannot', () => {
  const free = { sites: [0, 1, 5] };
  expect(movedSites(free, 0, 2, 'free', positions, [0, 1])).toEqual([2, 3, 5]);
  expect(movedSites(free, 2, 0, 'free', positions, [0, 1])).toBeNull(); // not in the hand: it goes alone
  expect(movedSites(free, 0, 4, 'free', positions, [1, 0])).toBeNull();
  expect(heldTogether(rows, [1, 2], 'rows')).toEqual([0, 1, 2]);
});

test('the image of a mirrored luminaire goes the mirrored way, and stays where there is no place', () => {
  const pair = { sites: [0, 4], ties: [0, 0] };
  expect(movedSites(pair, 0, 1, 'symmetric', positions)).toEqual([1, 3]);
  expect(movedSites(pair, 1, 3, 'symmetric', positions)).toEqual([1, 3]);
  expect(movedSites(pair, 0, 2, 'symmetric', positions)).toEqual([2, 4]); // both would hang there
  expect(movedSites(pair, 0, 5, 'symmetric', positions)).toEqual([5, 4]);
});

test('a field in the middle is in the middle still where it has not gone', () => {
  const [alongX, alongZ] = [
    [0.6, 0, 0],
    [0, 0, -0.6],
  ];
  expect(axisAfter('both', alongX)).toBe('x'); // mirrored about a line along x as before
  expect(axisAfter('both', alongZ)).toBe('z');
  expect(axisAfter('both', [0.6, 0, 0.6])).toBe('found');
  expect(axisAfter('z', alongX)).toBe('found');
  expect(axisAfter('z', alongZ)).toBe('z');
  expect(axisAfter('both', [0, 0, 0.001])).toBe('both');
});

test('less is asked of an axis: one of two, then none; of no axis there is nothing less', () => {
  expect(easedAxes({ rule: 'field', axis: 'both' })).toEqual([
    { rule: 'field', axis: 'x' },
    { rule: 'field', axis: 'z' },
    { rule: 'field' },
  ]);
  expect(easedAxes({ rule: 'rows', axis: 'x', leastInRow: 2 })).toEqual([{ rule: 'rows', leastInRow: 2 }]);
  expect(easedAxes({ rule: 'field' })).toEqual([]);
  expect(easedAxes(undefined)).toEqual([]);
});

test.each<[ruled: 'out' | 'in', counts: [number, number][], more: Partial<Luminaires>]>([
  ['in', [], { arrangement: { rule: 'field' } }], // squares
  ['in', [[0, 6], [0, 6]], { arrangement: { rule: 'field' } }], // prettier-ignore
  ['out', [[1, 6], [1, 6]], { arrangement: { rule: 'field' } }], // prettier-ignore
  ['out', [[0, 5], [0, 5]], { arrangement: { rule: 'field' } }], // prettier-ignore
  ['in', [[0, 5], [0, 5]], { arrangement: { rule: 'field' }, count: 4, most: 6 }], // prettier-ignore
  ['out', [[0, 6], [0, 6]], { arrangement: { rule: 'field' }, ofType: ['0', null, '1'] }], // prettier-ignore
  ['in', [[1, 6], [1, 6]], { arrangement: { rule: 'rows' } }], // prettier-ignore
  ['out', [[1, 2], [1, 6]], { arrangement: { rule: 'rows' } }], // prettier-ignore
  ['in', [[1, 2], [1, 6]], { arrangement: { rule: 'rows', leastInRow: 2 } }], // prettier-ignore
  ['out', [[1, 6], [1, 6]], { arrangement: { rule: 'rows' }, count: 7 }], // prettier-ignore
  ['in', [[1, 6], [1, 6]], { arrangement: { rule: 'symmetric' }, count: 7 }], // prettier-ignore
  ['out', [[0, 2], [0, 3]], {}], // prettier-ignore
])('numbers of types rule a layout %s: %j, %j', (ruled, counts, more) => {
  const types = counts.map((count, i) => luminaireType(`${i}`, photometricText(), { count }));
  expect(typesRuleOut({ ...sixLuminaires, types, ...more })).toBe(ruled === 'out');
});

/** Room for a field in the middle of a ceiling. */
import { expect, test } from '@jest/globals';
import { hasRoomInMiddle } from '../../../web/document/middle.ts';
import { ceilingOf } from '../ceiling.ts';
import { sixLuminaires as luminaires } from '../six-luminaires.ts';

const sites = ceilingOf(20, 13);

test('an odd number of columns has no middle among an even number of places', () => {
  const counts = Array.from({ length: 30 }, (_, i) => i + 1);
  const found = counts.filter((count) => hasRoomInMiddle(sites, { ...luminaires, count }));
  expect(found).toEqual([2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30]);
  expect(hasRoomInMiddle(sites, { ...luminaires, count: 9, most: 10 })).toBe(true);
  expect(hasRoomInMiddle(ceilingOf(13, 13), { ...luminaires, count: 9 })).toBe(true);
});

test('places that stay free and the least distance are kept', () => {
  const middle = [0, 1, 2].flatMap((rows) => [0, 1].map((column) => (5 + rows) * 20 + 9 + column));
  const asked = { ...luminaires, count: 6 };
  expect(hasRoomInMiddle(ceilingOf(2, 3), { ...asked, minDistance: 0.6 })).toBe(true);
  expect(hasRoomInMiddle(ceilingOf(2, 3), { ...asked, minDistance: 0.61 })).toBe(false);
  expect(hasRoomInMiddle(sites, { ...asked, excluded: middle })).toBe(true);
  expect(hasRoomInMiddle(ceilingOf(2, 3), { ...asked, excluded: [0] })).toBe(false);
});

test('where one direction has no middle for a number the other may have', () => {
  const has = (count: number, axis: 'x' | 'z') => hasRoomInMiddle(sites, { ...luminaires, count }, axis);
  expect([9, 25].map((count) => [has(count, 'x'), has(count, 'z')])).toEqual([
    [true, false],
    [true, false],
  ]);
  expect(hasRoomInMiddle(ceilingOf(13, 20), { ...luminaires, count: 9 }, 'z')).toBe(true);
  expect(hasRoomInMiddle(ceilingOf(3, 3), { ...luminaires, count: 12 }, 'x')).toBe(false);
});

// The more work a room is, the longer are the patches of its draft.
import { expect, test } from '@jest/globals';
import { draftCoarseness } from '../../../../web/app/lighting/draft.ts';

test('patches of a draft are longer in a room of much work, within reason', () => {
  const coarseness = [0.1, 14, 60, 150, 2000].map((work) => draftCoarseness({ work }));
  expect(coarseness.slice(0, 2)).toEqual([2.5, 2.5]);
  expect(coarseness[2]).toBeCloseTo(2.5, 1);
  expect(coarseness[3]).toBeGreaterThan(4);
  expect(coarseness[3]).toBeLessThan(5);
  expect(coarseness[4]).toBe(6);
});

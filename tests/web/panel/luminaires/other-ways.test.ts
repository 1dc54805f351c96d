import { expect, test } from '@jest/globals';
import { numbersOf } from '../../../../web/panel/luminaires/other-ways.tsx';

test('a rule that fails for a range of numbers is said to fail for all of them', () => {
  expect(numbersOf({ count: 15, most: 30 })).toBe('15–30');
  expect(numbersOf({ count: 6 })).toBe('6');
  expect(numbersOf({ count: 6, most: 6 })).toBe('6');
});

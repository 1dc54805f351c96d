import { expect, test } from '@jest/globals';
import { restingHeight } from '../../../web/panel/use-sheet.ts';

const heights = { low: 94, half: 388, full: 706 };

test('a sheet that is let go rests at the nearest height, or one further where it was flicked', () => {
  expect(restingHeight(200, 0, heights, 'half')).toBe('low');
  expect(restingHeight(300, 0.1, heights, 'half')).toBe('half');
  expect(restingHeight(600, -0.1, heights, 'half')).toBe('full');
  expect(restingHeight(370, -1, heights, 'half')).toBe('low');
  expect(restingHeight(410, 1, heights, 'half')).toBe('full');
  expect(restingHeight(700, 2, heights, 'full')).toBe('full');
  expect(restingHeight(100, -2, heights, 'low')).toBe('low');
});

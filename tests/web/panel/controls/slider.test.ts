/** Steps of the arrow keys. */
import { expect, test } from '@jest/globals';
import { stepped } from '../../../../web/panel/controls/slider.tsx';

test('arrows step, Shift ten times, Alt a tenth', () => {
  const key = (name: string, more = {}) => ({ key: name, shiftKey: false, altKey: false, ...more });
  expect(stepped(key('ArrowRight'), 100, 5)).toBe(105);
  expect(stepped(key('ArrowDown', { shiftKey: true }), 100, 5)).toBe(50);
  expect(stepped(key('ArrowUp', { altKey: true }), 100, 5)).toBe(100.5);
  expect(stepped(key('a'), 100, 5)).toBeNull();
});

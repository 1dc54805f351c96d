import { expect, test } from '@jest/globals';
import { provedOf } from '../../../../web/app/words/proved.ts';

test('a layout is the best possible, near to it, or bounded loosely', () => {
  expect(provedOf(0)).toEqual({ text: 'best possible, proved', isNear: true });
  expect(provedOf(0.00099).text).toBe('best possible, proved');
  expect(provedOf(0.001)).toEqual({ text: 'within 0.1 % of the best', isNear: true });
  expect(provedOf(0.042)).toEqual({ text: 'within 4.2 % of the best', isNear: true });
  expect(provedOf(0.12)).toEqual({ text: 'within 12 % of the best', isNear: false });
});

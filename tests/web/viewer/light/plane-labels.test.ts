/** Numbers on planes beside the tags of luminaires. */
import { expect, test } from '@jest/globals';
import { isAtTag } from '../../../../web/viewer/light/plane-labels.ts';

test('a number keeps some air to a tag: "L14 664" would read as one', () => {
  const tags = [{ x: 100, y: 50, wide: 32, high: 18 }];
  const number = 22; // px, of three digits
  expect(isAtTag(tags, { x: 100 + 16 + number / 2 + 2, y: 50 })).toBe(true);
  expect(isAtTag(tags, { x: 100 + 16 + number / 2 + 10, y: 50 })).toBe(false);
  expect(isAtTag(tags, { x: 100, y: 80 })).toBe(false);
});

/** What a card says of its mean: the aim beside it where that is not reached. */
import { afterEach, expect, test } from '@jest/globals';
import { speak } from '../../../../web/language/language.ts';
import { reachedText } from '../../../../web/panel/intentions/intention-card.tsx';

afterEach(() => speak('en'));

test('a card that misses its aim says what it aims at, one that is within a hundredth does not', async () => {
  expect(reachedText(268.2, 400, 'lx')).toBe('268 of 400 lx');
  expect(reachedText(397, 400, 'lx')).toBe('397 lx');
  expect(reachedText(405, 400, 'lx')).toBe('405 of 400 lx');
  expect(reachedText(405, undefined, 'lx')).toBe('405 lx');
  await speak('de');
  expect(reachedText(268.2, 400, 'lx')).toBe('268 von 400 lx');
});

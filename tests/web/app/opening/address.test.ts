/** What the address and the browser's history say about the room on the screen. */
import { expect, test } from '@jest/globals';
import { isShownAgain } from '../../../../web/app/opening/address.ts';

test('work is shown again by a reload, and not where the tab went on to the page of another room', () => {
  expect(isShownAgain('box', 'museum', null)).toBe(false);
  expect(isShownAgain('box', 'museum', { fiatlux: 'box' })).toBe(true); // chosen after the page had opened
  expect(isShownAgain('box', 'box', null)).toBe(true);
  expect(isShownAgain('box', null, null)).toBe(true);
});

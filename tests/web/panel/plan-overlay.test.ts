/** Where points of the plan lie on the page, whichever way the plan is turned. */
import { expect, test } from '@jest/globals';
import { onPage } from '../../../web/panel/plan-overlay.tsx';

test('a point of the plan is found on the page, of a plan that is turned, too', () => {
  // 50 px a metre, (300, 200) px is x 1, z 2; east is up on the page.
  const turned = (left: number, top: number) => [1 - (top - 200) / 50, 2 + (left - 300) / 50] as const;
  expect(onPage(turned, [1, 2])).toEqual([expect.closeTo(300), expect.closeTo(200)]);
  expect(onPage(turned, [3, -1])).toEqual([expect.closeTo(150), expect.closeTo(100)]);
  expect(onPage(() => null, [0, 0])).toBeNull();
});

// What a plan is framed between: all that lies over the picture, as long as a plan is left.
import { expect, test } from '@jest/globals';
import { coveredBy } from '../../../../web/viewer/stage/stage.ts';

test('a plan keeps clear of legend and selection bar on a phone, the other views of a share', () => {
  const phone = coveredBy({ top: 80, planTop: 58, bottom: 84, planBottom: 152 }, 408);
  expect(phone).toEqual({ top: 80, planTop: 80, bottom: 84, planBottom: 152 }); // 30 % each hid its last row
});

test('of a low picture something is left for the plan', () => {
  const { top, planTop, bottom, planBottom } = coveredBy(
    { top: 80, planTop: 108, bottom: 84, planBottom: 152 },
    260,
  );
  expect([top, bottom]).toEqual([0.27 * 260, 0.27 * 260]);
  expect(planTop).toBeGreaterThanOrEqual(top);
  expect(planBottom).toBeGreaterThanOrEqual(bottom);
  expect(260 - planTop - planBottom).toBeCloseTo(0.42 * 260);
});

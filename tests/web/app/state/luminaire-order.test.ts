/** The permutation between the page and the core. */
import { expect, test } from '@jest/globals';
import { coreOrder, fromCore, toCore } from '../../../../web/app/state/luminaire-order.ts';

test('tags stay with their luminaires when pinned ones go first', () => {
  const layout = { sites: [10, 20, 30], flux: [1, 2, 3], dimming: 1 };
  const order = coreOrder(layout, [30]);
  expect(toCore(layout, order).sites).toEqual([30, 10, 20]);
  expect(fromCore(toCore(layout, order), order)).toEqual(layout);
  const moved = fromCore({ sites: [30, 11, 21], flux: [3, 1, 2], dimming: 1 }, order);
  expect(moved.sites).toEqual([11, 21, 30]);
  const fewer = fromCore({ sites: [30, 10], flux: [3, 1], dimming: 1 }, order);
  expect([...fewer.sites].sort()).toEqual([10, 30]);
  const more = fromCore({ sites: [30, 10, 20, 40], flux: [3, 1, 2, 4], dimming: 1 }, order);
  expect(more.sites).toEqual([10, 20, 30, 40]);
});

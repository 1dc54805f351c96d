/** Tags as a plan is read. */
import { expect, test } from '@jest/globals';
import { isInOrder, readingOrder, renumbered } from '../../../web/document/reading-order.ts';

// Two rows of two, the southern one with one luminaire a little aside (x, y, z; z runs south).
const places = [
  [6, 3, 5],
  [1, 3, 1],
  [6, 3, 1],
  [1, 3, 5.1],
];
const sites = {
  position: Float32Array.from(places.flat()),
  normal: new Float32Array(12),
  axis: new Float32Array(12),
  size: new Float32Array(4),
};
const frame = { west: 0, south: 8, floor: 0, size: [8, 8, 3] } as const;
const layout = { sites: [0, 1, 2, 3], flux: [10, 20, 30, 40], dimming: 1, ties: [0, 1, 1, 0] };

test('from the north-west to the south-east, row by row', () => {
  const order = readingOrder(layout, sites, frame);
  expect(order).toEqual([1, 2, 3, 0]);
  expect(isInOrder(order)).toBe(false);
  const read = renumbered(layout, order);
  expect(read).toEqual({ sites: [1, 2, 3, 0], flux: [20, 30, 40, 10], dimming: 1, ties: [1, 1, 0, 0] });
  expect(isInOrder(readingOrder(read, sites, frame))).toBe(true);
});

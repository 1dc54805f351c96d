/** The rows of each leaf, of those that count. */
import { expect, test } from '@jest/globals';
import { countedRows } from '../../../web/document/counted-rows.ts';

const surfaceOfPatch = Uint32Array.from([1, 0, 1, 3, 1]);
const rowsOf = (patchCovered: Uint8Array) => (leaf: number) => [
  ...countedRows({ surfaceOfPatch, patchCovered } as never, leaf),
];

test('a leaf has the rows of its patches, ascending, but those that something covers', () => {
  const rows = rowsOf(Uint8Array.from([0, 0, 1, 0, 0]));
  expect([0, 1, 2, 3, 4].map(rows)).toEqual([[1], [0, 4], [], [3], []]);
});

test('nothing is covered where no mask tells of it; another mask of the same patches is another answer', () => {
  expect(rowsOf(Uint8Array.from([1, 0, 0, 0, 0]))(1)).toEqual([2, 4]);
  expect(rowsOf(new Uint8Array())(1)).toEqual([0, 2, 4]);
});

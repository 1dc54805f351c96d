/** Lists one after the other. */
import { expect, test } from '@jest/globals';
import { joined } from '../../../web/document/joined.ts';

test('holds the numbers of all lists in their order, and none where there is no list', () => {
  const parts = [Uint32Array.of(3, 1), new Uint32Array(), Uint32Array.of(2)];
  expect(joined(parts, Uint32Array)).toEqual(Uint32Array.of(3, 1, 2));
  expect(joined([], Float64Array)).toEqual(new Float64Array());
});

/** Numbers of attributes are those that three reads one by one, however they are stored. */
import { describe, expect, test } from '@jest/globals';
import { BufferAttribute, InterleavedBuffer, InterleavedBufferAttribute } from 'three';
import { floatsOf } from '../../../../web/viewer/room/attribute-numbers.ts';

const six = [0, 1, 127, 64, 3, 99];
const stored = {
  floats: new BufferAttribute(
    Float32Array.from(six, (value) => value / 7),
    3,
  ),
  'whole numbers': new BufferAttribute(Uint16Array.from(six), 3),
  'unsigned shares': new BufferAttribute(Uint8Array.from(six), 3, true),
  'signed shares': new BufferAttribute(
    Int8Array.from(six, (value) => -value),
    3,
    true,
  ),
  'interleaved floats': new InterleavedBufferAttribute(
    new InterleavedBuffer(Float32Array.from([9, ...six, 9]), 4),
    3,
    1,
  ),
};

describe('all numbers of an attribute', () => {
  for (const [name, attribute] of Object.entries(stored))
    test(name, () => {
      const read = (i: number) => attribute.getComponent(Math.floor(i / 2), i % 2);
      const floats = floatsOf(attribute, 2);
      expect(floats).toHaveLength(4);
      floats.forEach((value, i) => expect(value).toBeCloseTo(read(i), 6));
    });
});

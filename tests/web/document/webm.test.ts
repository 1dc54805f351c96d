/** The elements of a film's file, read back. */
import { expect, test } from '@jest/globals';
import { webmOf } from '../../../web/document/webm.ts';

const masters = [
  0x1a45dfa3, 0x18538067, 0x1549a966, 0x1654ae6b, 0xae, 0xe0, 0x55b0, 0x1c53bb6b, 0xbb, 0xb7, 0x1f43b675,
];

interface Read {
  readonly id: number;
  readonly at: number; // of the element
  readonly content: Uint8Array;
}

function elementsOf(bytes: Uint8Array, from = 0, to = bytes.length): Read[] {
  const found: Read[] = [];
  for (let at = from; at < to;) {
    const idLength = Math.clz32(bytes[at]!) - 23;
    const id = bytes.slice(at, at + idLength).reduce((sum, byte) => 256 * sum + byte, 0);
    const first = at + idLength;
    const size = bytes.slice(first, first + 4).reduce((sum, byte) => 256 * sum + byte, 0) - 0x10000000;
    found.push({ id, at, content: bytes.subarray(first + 4, first + 4 + size) });
    if (masters.includes(id)) found.push(...elementsOf(bytes, first + 4, first + 4 + size));
    at = first + 4 + size;
  }
  return found;
}

const valueOf = (content: Uint8Array) => content.reduce((sum, byte) => 256 * sum + byte, 0);

test('pictures stand in their order and time; jumps lead to clusters', () => {
  const pictures = [0, 1, 2, 3, 4].map((i) => ({ bytes: Uint8Array.of(7, i), isWhole: i % 2 === 0 }));
  const file = webmOf(pictures, {
    width: 640,
    height: 360,
    perSecond: 2,
    space: { matrix: 'smpte170m', fullRange: false },
  });
  const all = elementsOf(file);
  const each = (id: number) => all.filter((one) => one.id === id);
  expect(all.reduce((end, { content }) => Math.max(end, content.byteOffset + content.length), 0)).toBe(
    file.length,
  );
  expect(new TextDecoder().decode(each(0x86)[0]!.content)).toBe('V_VP8');
  expect([valueOf(each(0xb0)[0]!.content), valueOf(each(0xba)[0]!.content)]).toEqual([640, 360]);
  expect(new DataView(file.buffer, each(0x4489)[0]!.content.byteOffset).getFloat64(0)).toBe(2500);
  expect(each(0xe7).map(({ content }) => valueOf(content))).toEqual([0, 1000, 2000]);
  expect(each(0xa3).map(({ content }) => [...content])).toEqual([
    [0x81, 0, 0, 0x80, 7, 0],
    [0x81, 500 >> 8, 500 & 255, 0, 7, 1],
    [0x81, 0, 0, 0x80, 7, 2],
    [0x81, 500 >> 8, 500 & 255, 0, 7, 3],
    [0x81, 0, 0, 0x80, 7, 4],
  ]);
  expect([0x55b1, 0x55b9, 0x55ba].flatMap(each).map(({ content }) => valueOf(content))).toEqual([6, 1]);
  const content = each(0x18538067)[0]!.content.byteOffset;
  expect(each(0xf1).map((cue) => valueOf(cue.content) + content)).toEqual(
    each(0x1f43b675).map(({ at }) => at),
  );
});

/** Numbers of a mesh's attributes without a call for each: a room has millions of them. */
import { InterleavedBufferAttribute, type BufferAttribute } from 'three';

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** Number `of` of vertex v is array[v * stride + offset + of] * scale; of normalized numbers unsigned ones alone. */
export function numbersOf(attribute: Attribute) {
  const { array, normalized, itemSize } = attribute;
  const isWhole = !(array instanceof Float32Array);
  const scale = normalized && isWhole ? 1 / (2 ** (8 * array.BYTES_PER_ELEMENT) - 1) : 1;
  if (attribute instanceof InterleavedBufferAttribute)
    return { array, stride: attribute.data.stride, offset: attribute.offset, scale };
  return { array, stride: itemSize, offset: 0, scale };
}

/** The first `size` numbers of every vertex, as a shader reads them; a copy. */
export function floatsOf(attribute: Attribute, size: number): Float32Array<ArrayBuffer> {
  const { count, normalized } = attribute;
  const { array, stride, offset, scale } = numbersOf(attribute);
  const isSigned = normalized && (array instanceof Int8Array || array instanceof Int16Array);
  const floats = new Float32Array(size * count);
  if (array instanceof Float32Array && stride === size)
    floats.set(array.subarray(offset, offset + size * count));
  else
    for (let vertex = 0, to = 0; vertex < count; vertex++)
      for (let of = 0; of < size; of++, to++)
        floats[to] = isSigned
          ? attribute.getComponent(vertex, of)
          : array[vertex * stride + offset + of]! * scale;
  return floats;
}

/** The two forms of a glTF file, as far as they must be told apart and written here: JSON alone, or JSON and bytes as .glb. */

const [magic, version, jsonChunk, binaryChunk] = [0x46546c67, 2, 0x4e4f534a, 0x004e4942];
const [headerBytes, chunkBytes] = [12, 8];

export interface Container {
  readonly text: string; // the JSON
  readonly bin: Uint8Array<ArrayBuffer> | null;
}

/** Throws where a .glb is cut off. */
export function readContainer(bytes: Uint8Array<ArrayBuffer>): Container {
  const decoder = new TextDecoder('utf-8');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < headerBytes + chunkBytes || view.getUint32(0, true) !== magic)
    return { text: decoder.decode(bytes), bin: null };
  const size = view.getUint32(headerBytes, true);
  const begin = headerBytes + chunkBytes;
  const text = decoder.decode(bytes.subarray(begin, begin + size));
  const next = begin + size;
  if (next + chunkBytes > bytes.length) return { text, bin: null };
  const binSize = view.getUint32(next, true);
  return { text, bin: bytes.subarray(next + chunkBytes, next + chunkBytes + binSize) };
}

const padded = (size: number) => Math.ceil(size / 4) * 4;

/** A .glb of these parts; its JSON says how long the bytes are. */
export function writeGlb(json: unknown, bin: Uint8Array | null): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const textEnd = headerBytes + chunkBytes + padded(text.length);
  const glb = new Uint8Array(textEnd + (bin ? chunkBytes + padded(bin.length) : 0));
  const view = new DataView(glb.buffer);
  const words = (at: number, values: readonly number[]) =>
    values.forEach((value, index) => view.setUint32(at + 4 * index, value, true));
  words(0, [magic, version, glb.length, padded(text.length), jsonChunk]);
  glb.fill(0x20, headerBytes + chunkBytes, textEnd);
  glb.set(text, headerBytes + chunkBytes);
  if (!bin) return glb;
  words(textEnd, [padded(bin.length), binaryChunk]);
  glb.set(bin, textEnd + chunkBytes);
  return glb;
}

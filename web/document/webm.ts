/**
 * A WebM file (a subset of Matroska, RFC 9559) of one VP8 track: each second a cluster that begins with a whole picture, and
 * the places of these, so that a player can jump to them.
 */

export interface EncodedPicture {
  readonly bytes: Uint8Array;
  readonly isWhole: boolean; // needs no picture before it
}

export interface Shape {
  readonly width: number; // px
  readonly height: number;
  readonly perSecond: number;
  readonly space: VideoColorSpaceInit; // as the encoder tells it; what it leaves out is left out
}

/** ITU-T H.273 */
const matrices: Readonly<Record<string, number>> = { rgb: 0, bt709: 1, bt470bg: 5, smpte170m: 6 };
const primaries: Readonly<Record<string, number>> = { bt709: 1, bt470bg: 5, smpte170m: 6 };
const transfers: Readonly<Record<string, number>> = { bt709: 1, smpte170m: 6, 'iec61966-2-1': 13 };

type Bytes = Uint8Array;

const text = (letters: string): Bytes => new TextEncoder().encode(letters);

/** Big endian. */
function number(value: number, length: number): Bytes {
  return Uint8Array.from({ length }, (_, i) => Math.floor(value / 256 ** (length - 1 - i)) % 256);
}

function float(value: number): Bytes {
  const bytes = new Uint8Array(8);
  new DataView(bytes.buffer).setFloat64(0, value);
  return bytes;
}

const lengthOf = (parts: readonly Bytes[]): number => parts.reduce((sum, { length }) => sum + length, 0);

function joined(parts: readonly Bytes[]): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(lengthOf(parts));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/** An element of EBML (RFC 8794); its size takes four bytes. */
function element(id: number, ...parts: Bytes[]): Bytes {
  const idLength = Math.ceil(Math.log2(id + 1) / 8);
  return joined([number(id, idLength), number(0x10000000 + lengthOf(parts), 4), ...parts]);
}

const header = (): Bytes =>
  element(
    0x1a45dfa3,
    element(0x4286, number(1, 1)), // EBMLVersion
    element(0x42f7, number(1, 1)), // EBMLReadVersion
    element(0x42f2, number(4, 1)), // EBMLMaxIDLength
    element(0x42f3, number(8, 1)), // EBMLMaxSizeLength
    element(0x4282, text('webm')), // DocType
    element(0x4287, number(2, 1)), // DocTypeVersion
    element(0x4285, number(2, 1)), // DocTypeReadVersion
  );

const info = (milliseconds: number): Bytes =>
  element(
    0x1549a966,
    element(0x2ad7b1, number(1e6, 4)), // TimestampScale: ms
    element(0x4489, float(milliseconds)), // Duration
    element(0x4d80, text('Fiat Lux')), // MuxingApp
    element(0x5741, text('Fiat Lux')), // WritingApp
  );

/** Without it a player guesses, and the colours are others. */
function colour({ matrix, primaries: primary, transfer, fullRange }: VideoColorSpaceInit): Bytes {
  const known = (id: number, value: number | undefined) =>
    value === undefined ? [] : [element(id, number(value, 1))];
  return element(
    0x55b0,
    ...known(0x55b1, matrices[matrix ?? '']),
    ...known(0x55b9, fullRange == null ? undefined : fullRange ? 2 : 1),
    ...known(0x55ba, transfers[transfer ?? '']),
    ...known(0x55bb, primaries[primary ?? '']),
  );
}

const tracks = ({ width, height, perSecond, space }: Shape): Bytes =>
  element(
    0x1654ae6b,
    element(
      0xae,
      element(0xd7, number(1, 1)), // TrackNumber
      element(0x73c5, number(1, 1)), // TrackUID
      element(0x83, number(1, 1)), // TrackType: video
      element(0x9c, number(0, 1)), // FlagLacing
      element(0x86, text('V_VP8')), // CodecID
      element(0x23e383, number(Math.round(1e9 / perSecond), 4)), // DefaultDuration, ns
      element(0xe0, element(0xb0, number(width, 2)), element(0xba, number(height, 2)), colour(space)), // Video
    ),
  );

/** Where clusters begin, bytes from the beginning of the segment's content. */
const cues = (clusters: readonly { readonly time: number; readonly at: number }[]): Bytes =>
  element(
    0x1c53bb6b,
    ...clusters.map(({ time, at }) =>
      element(
        0xbb, // CuePoint
        element(0xb3, number(time, 4)),
        element(0xb7, element(0xf7, number(1, 1)), element(0xf1, number(at, 4))),
      ),
    ),
  );

export function webmOf(pictures: readonly EncodedPicture[], shape: Shape): Uint8Array<ArrayBuffer> {
  const timeOf = (index: number) => Math.round((1000 * index) / shape.perSecond);
  const begins = [...pictures.keys()].filter((i) => pictures[i]!.isWhole);
  const clusters = begins.map((first, i) => {
    const blocks = pictures.slice(first, begins[i + 1]).map(({ bytes, isWhole }, j) => {
      const after = timeOf(first + j) - timeOf(first);
      return element(0xa3, number(0x81, 1), number(after, 2), number(isWhole ? 0x80 : 0, 1), bytes); // SimpleBlock
    });
    return element(0x1f43b675, element(0xe7, number(timeOf(first), 4)), ...blocks);
  });
  const before = [info(timeOf(pictures.length)), tracks(shape)];
  const placed = (at: number) =>
    begins.map((first, i) => ({ time: timeOf(first), at: at + lengthOf(clusters.slice(0, i)) }));
  const start = lengthOf(before) + cues(placed(0)).length;
  return joined([header(), element(0x18538067, ...before, cues(placed(start)), ...clusters)]);
}

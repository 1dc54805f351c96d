/**
 * Inflates the sections of a scene file by the browser's own DecompressionStream. A section is stopped as soon as it
 * yields more than its table announces, so that a few bytes cannot fill the memory.
 */
import type { Section } from './core.ts';

/** Inflates zlib bytes that must yield exactly `size` bytes. Rejects with one readable line that begins with `name`. */
export async function inflateExactly(
  stored: Uint8Array<ArrayBuffer>,
  size: number,
  name: string,
): Promise<Uint8Array<ArrayBuffer>> {
  const inflated = new Uint8Array(size);
  let filled = 0;
  const reader = new Blob([stored]).stream().pipeThrough(new DecompressionStream('deflate')).getReader();
  try {
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      if (filled + value.length > size)
        throw new SectionError(`${name}: more than its ${size} bytes come out`);
      inflated.set(value, filled);
      filled += value.length;
    }
  } catch (error) {
    void reader.cancel().catch(() => undefined);
    if (error instanceof SectionError) throw error;
    throw new SectionError(`${name}: cannot be inflated`);
  }
  if (filled < size) throw new SectionError(`${name}: only ${filled} of its ${size} bytes come out`);
  return inflated;
}

/** The inflated bytes of one section of a file. */
export function sectionBytes(
  file: Uint8Array<ArrayBuffer>,
  section: Section,
): Promise<Uint8Array<ArrayBuffer>> {
  const stored = file.subarray(section.offset, section.offset + section.storedBytes);
  return section.deflated
    ? inflateExactly(stored, section.inflatedBytes, section.name)
    : Promise.resolve(stored.slice());
}

export class SectionError extends Error {
  override name = 'SectionError';
  constructor(message: string) {
    super(`${message}; the file is damaged: make it again with fiatlux precompute`);
  }
}

/**
 * Photometric files as they arrive: by themselves, in a zip (GLDF, or what a maker sends), or as XML (TM-33, ATLA S001).
 * What is inside is only taken out here; whether it is photometry the core's reader says.
 */
import { strFromU8, unzipSync, type UnzipFileInfo } from 'fflate';
import { largestPhotometricFile } from './photometric-files.ts';
import { iesOfTm33 } from './tm33.ts';
import { words } from '../language/language.ts';

export interface PhotometricPart {
  readonly name: string; // of the file, without folders
  readonly bytes: Uint8Array<ArrayBuffer>;
}

const mostParts = 40; // of a container
const largestContainer = 64 << 20; // bytes
const largestName = 200; // characters

/** Whether a file of this name can be nothing but photometry. */
export const isPhotometricName = (name: string): boolean =>
  /\.(ies|ldt|eul|gldf|zip|xml|uld|rolfz?)$/i.test(name);

const baseName = (path: string): string => path.replace(/^.*[\\/]/, '').slice(0, largestName);
const startsWith = (bytes: Uint8Array, ...magic: number[]) => magic.every((byte, i) => bytes[i] === byte);

/** At least one part. Throws one readable clause. `parse`: text of XML into a document. */
export function partsOf(
  name: string,
  bytes: Uint8Array<ArrayBuffer>,
  parse: (xml: string) => Document,
): PhotometricPart[] {
  if (startsWith(bytes, 0x50, 0x4b)) return zipParts(bytes);
  if (/\.xml$/i.test(name) && bytes.length <= largestPhotometricFile)
    return [{ name: baseName(name), bytes: bytesOf(iesOfTm33(parse(strFromU8(bytes)))) }];
  return [{ name: baseName(name), bytes }];
}

const bytesOf = (text: string) => new Uint8Array(new TextEncoder().encode(text));

function zipParts(bytes: Uint8Array): PhotometricPart[] {
  if (bytes.length > largestContainer) throw new Error(words.value.files.photometric.tooLarge);
  let isGldf = false;
  let tooLarge: string | null = null;
  let count = 0;
  const isWanted = ({ name, originalSize }: UnzipFileInfo) => {
    isGldf ||= name === 'product.xml';
    if (!/\.(ies|ldt|eul)$/i.test(name)) return false;
    // Nothing is inflated beyond the size that the table of contents says: a bomb is refused by it or cut there.
    if (originalSize > largestPhotometricFile) tooLarge = baseName(name);
    return tooLarge === null && ++count <= mostParts;
  };
  let inside: Record<string, Uint8Array>;
  try {
    inside = unzipSync(bytes, { filter: isWanted });
  } catch {
    throw new Error(words.value.files.photometric.zipDamaged);
  }
  const kind = isGldf ? words.value.files.photometric.gldf : words.value.files.photometric.zip;
  if (tooLarge !== null) throw new Error(words.value.files.photometric.partTooLarge(kind, tooLarge));
  if (count > mostParts) throw new Error(words.value.files.photometric.tooManyParts(kind, mostParts));
  const parts = Object.entries(inside).map(([name, part]) => ({
    name: baseName(name),
    bytes: new Uint8Array(part),
  }));
  if (parts.length === 0) throw new Error(words.value.files.photometric.noParts(kind));
  return parts;
}

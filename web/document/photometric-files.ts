/**
 * Photometric files beside the document: texts of a character a byte (whatever their code page), by a hash of the bytes.
 * The document and each step of its history name files by their hashes only.
 */
import * as v from 'valibot';
import { hashSchema } from './schema.ts';
import type { FiatLuxDocument } from './types.ts';

/** By hash; read only, a change makes another. */
export type PhotometricFiles = Readonly<Record<string, string>>;

export const largestPhotometricFile = 4 << 20; // bytes
const mostFiles = 64;

export const filesSchema = v.pipe(
  v.record(hashSchema, v.pipe(v.string(), v.maxLength(largestPhotometricFile))),
  v.check((files) => Object.keys(files).length <= mostFiles, 'it has too many photometric files'),
  v.check(
    (files) => Object.entries(files).every(([hash, text]) => hashOf(bytesOfText(text)) === hash),
    'a photometric file is not the one that it is said to be',
  ),
);

/** Two rounds of FNV-1a, 32 bits each: an identity, no secret. */
export function hashOf(bytes: Uint8Array): string {
  const round = (start: number) => {
    let hash = start;
    for (const byte of bytes) hash = Math.imul(hash ^ byte, 0x01000193);
    return (hash >>> 0).toString(16).padStart(8, '0');
  };
  return round(0x811c9dc5) + round(0x9e3779b9 ^ bytes.length);
}

export function textOfBytes(bytes: Uint8Array): string {
  let text = '';
  for (let at = 0; at < bytes.length; at += 8192)
    text += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return text;
}

/** Characters beyond a byte are none of a file's: they become question marks. */
export function bytesOfText(text: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(text, (character) => (character.charCodeAt(0) < 256 ? character.charCodeAt(0) : 63));
}

export function withFile(
  files: PhotometricFiles,
  bytes: Uint8Array,
): { files: PhotometricFiles; hash: string } {
  const hash = hashOf(bytes);
  return { hash, files: hash in files ? files : { ...files, [hash]: textOfBytes(bytes) } };
}

/** The files that a document names. `beside`: text that may name more of them, as the JSON of a history. */
export function filesOf(files: PhotometricFiles, document: FiatLuxDocument, beside = ''): PhotometricFiles {
  const types = [document, document.kept].flatMap((each) => each?.luminaires.types ?? []);
  const hashes = new Set(types.map(({ hash }) => hash));
  return Object.fromEntries(
    Object.entries(files).filter(([hash]) => hashes.has(hash) || beside.includes(`"${hash}"`)),
  );
}

/** A luminaire type and its file, as a document has them. */
import { hashOf, textOfBytes } from '../../../web/document/photometric-files.ts';
import type { LuminaireType } from '../../../web/document/types.ts';

/** A file of `rows` lines of angles; the last letter is not ASCII, as in makers' files of code page 1252. */
export function photometricText(rows = 20): string {
  const lines = Array.from({ length: rows }, (_, i) => `${i * 5} ${1000 - ((i * 37) % 211)}`);
  return ['IESNA:LM-63-2002', '[LUMINAIRE] Spot \u00e9', ...lines].join('\r\n');
}

const bytesOf = (text: string) => Uint8Array.from(text, (character) => character.charCodeAt(0));

export function luminaireType(id: string, text: string, more: Partial<LuminaireType> = {}): LuminaireType {
  const bytes = bytesOf(text);
  if (textOfBytes(bytes) !== text) throw new Error('the text is not of a character a byte');
  return {
    id,
    name: `Spot ${id}`,
    maker: 'Fiat Lux',
    file: `spot-${id}.ies`,
    hash: hashOf(bytes),
    flux: 900,
    watts: 9,
    isAllowed: true,
    count: [0, 6],
    turns: [0],
    tilt: 0,
    aims: [],
    ...more,
  };
}

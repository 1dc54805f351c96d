/** Photometric files beside the document. */
import { expect, test } from '@jest/globals';
import * as v from 'valibot';
import {
  bytesOfText,
  filesOf,
  filesSchema,
  hashOf,
  textOfBytes,
  withFile,
} from '../../../web/document/photometric-files.ts';
import { sampleDocument } from '../sample-rooms.ts';
import { luminaireType, photometricText } from './luminaire-type.ts';

test('every byte survives as a character', () => {
  const bytes = Uint8Array.from({ length: 70_000 }, (_, i) => (i * 31) % 256);
  expect(bytesOfText(textOfBytes(bytes))).toEqual(bytes);
});

test('one byte more, less or other is another file', () => {
  const bytes = Uint8Array.of(1, 2, 3, 4);
  const others = [
    [1, 2, 3],
    [1, 2, 3, 4, 0],
    [1, 2, 4, 3],
    [1, 2, 3, 5],
  ];
  const hashes = [bytes, ...others.map((list) => Uint8Array.from(list))].map(hashOf);
  expect(new Set(hashes).size).toBe(5);
  for (const hash of hashes) expect(hash).toMatch(/^[0-9a-f]{16}$/);
});

test('a file is kept once, and with whoever names it', () => {
  const [one, other] = [photometricText(3), photometricText(4)].map((text) => bytesOfText(text));
  const first = withFile({}, one!);
  const both = withFile(first.files, other!);
  expect(withFile(both.files, one!).files).toBe(both.files);
  const type = luminaireType('a', photometricText(3));
  const asked = sampleDocument('0'.repeat(16), 'box');
  const document = { ...asked, luminaires: { ...asked.luminaires, types: [type] } };
  expect(Object.keys(filesOf(both.files, document))).toEqual([first.hash]);
  expect(Object.keys(filesOf(both.files, document, JSON.stringify({ hash: both.hash }))).sort()).toEqual(
    [first.hash, both.hash].sort(),
  );
});

test('a file under the hash of another is refused', () => {
  const { files, hash } = withFile({}, bytesOfText('abc'));
  expect(v.safeParse(filesSchema, files).success).toBe(true);
  expect(v.safeParse(filesSchema, { [hash]: 'abd' }).success).toBe(false);
});

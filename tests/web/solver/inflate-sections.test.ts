/** Inflating to exactly the announced size. */
import { deflateSync } from 'node:zlib';
import { expect, test } from '@jest/globals';
import { inflateExactly } from '../../../web/solver/inflate-sections.ts';

const plain = Uint8Array.from({ length: 100_000 }, (_, i) => (i * i) % 251);
const stored = new Uint8Array(deflateSync(plain));

test('exact sizes come back whole', async () => {
  expect(await inflateExactly(stored, plain.length, 'a')).toEqual(plain);
  expect(await inflateExactly(new Uint8Array(deflateSync(new Uint8Array())), 0, 'a')).toHaveLength(0);
});

test('one byte more or less than announced is an error that names the section', async () => {
  await expect(inflateExactly(stored, plain.length - 1, 'sites')).rejects.toThrow(
    /^sites: more than its 99999 bytes/,
  );
  await expect(inflateExactly(stored, plain.length + 1, 'sites')).rejects.toThrow(
    /^sites: only 100000 of its 100001/,
  );
});

test('bytes that are not deflated, or cut, are an error', async () => {
  await expect(inflateExactly(plain.slice(), plain.length, 'sites')).rejects.toThrow(
    /^sites: cannot be inflated/,
  );
  await expect(inflateExactly(stored.slice(0, 100), plain.length, 'sites')).rejects.toThrow(/^sites: /);
});

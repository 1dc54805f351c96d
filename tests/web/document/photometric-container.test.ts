/** What is taken out of containers, and what is refused. Of XML what needs no parser; tests/e2e/luminaires.spec.ts has the rest. */
import { expect, test } from '@jest/globals';
import { strFromU8, strToU8, zipSync } from 'fflate';
import { isPhotometricName, partsOf } from '../../../web/document/photometric-container.ts';

const noParser = (): Document => {
  throw new Error('this is no XML');
};
const parts = (name: string, bytes: Uint8Array) => partsOf(name, new Uint8Array(bytes), noParser);
const table = strToU8('IESNA91 ...');

test('a file by itself stays as it is', () => {
  const [part, ...others] = parts('C:\\luminaires\\spot.IES', table);
  expect(others).toEqual([]);
  expect(part?.name).toBe('spot.IES');
  expect(strFromU8(part!.bytes)).toBe('IESNA91 ...');
});

test('a GLDF gives its photometric files and nothing else', () => {
  const gldf = zipSync({
    'product.xml': strToU8('<Root/>'),
    'ldc/wide.ldt': strToU8('wide'),
    'ldc/narrow.IES': strToU8('narrow'),
    'geo/body.l3d': strToU8('body'),
    'image/picture.png': strToU8('picture'),
  });
  expect(parts('lamp.gldf', gldf).map(({ name, bytes }) => [name, strFromU8(bytes)])).toEqual([
    ['wide.ldt', 'wide'],
    ['narrow.IES', 'narrow'],
  ]);
});

test.each([
  [
    'without photometry',
    zipSync({ 'product.xml': strToU8('<Root/>') }),
    /GLDF container has no \.ldt or \.ies/,
  ],
  ['without anything', zipSync({}), /zip file has no/],
  [
    'that is a bomb',
    zipSync({ 'product.xml': table, 'big.ldt': new Uint8Array(5 << 20) }),
    /more than 4 MB \(big\.ldt\)/,
  ],
  [
    'of too many files',
    zipSync(Object.fromEntries(Array.from({ length: 41 }, (_, i) => [`${i}.ldt`, table]))),
    /more than 40/,
  ],
  ['that is cut off', zipSync({ 'a.ldt': table }).subarray(0, 60), /damaged zip/],
])('a container %s is refused', (_, bytes, message) => {
  expect(() => parts('lamp.gldf', bytes)).toThrow(message);
});

test('a bomb that says it is small is cut at what it says', () => {
  const bytes = zipSync({ 'a.ldt': new Uint8Array(3 << 20) });
  const size = Uint8Array.of(0, 0, 0x30, 0); // 3 MB, as both directories say
  for (let at = 0; at + 4 <= bytes.length; at++)
    if (size.every((byte, i) => bytes[at + i] === byte)) bytes.set([16, 0, 0, 0], at);
  expect(parts('lamp.zip', bytes).map((part) => part.bytes.length)).toEqual([16]);
});

test('what is XML by its name is parsed, photometric names are known', () => {
  expect(() => parts('lamp.xml', table)).toThrow('this is no XML');
  expect(['a.ies', 'b.LDT', 'c.gldf', 'd.uld', 'e.xml', 'f.zip'].every(isPhotometricName)).toBe(true);
  expect(['a.flux', 'b.glb', 'c.json', 'ies', 'd.ies.txt'].some(isPhotometricName)).toBe(false);
});

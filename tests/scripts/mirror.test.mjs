// tests/ mirrors the C++: what has more than 60 lines has a test of its name at its path, or is named in the first lines
// of the test that covers it.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { librariesOf, sourcesOf } from '../../scripts/libraries.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const MOST_LINES = 60;

const read = (file) => readFileSync(path.join(root, file), 'utf8');

/** The comment that opens a file. */
const bannerOf = (text) => /^(?:\/\/[^\n]*\n)*/.exec(text)[0];

/** Words of the banners of all tests. */
const covered = new Set(
  readdirSync(path.join(root, 'tests'), { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('_test.cpp'))
    .flatMap((name) => bannerOf(read(path.join('tests', name))).match(/\w+/g) ?? []),
);

/** Units of a folder (a source, or a header without one) that want a test. */
const unitsOf = (folder) =>
  sourcesOf(root, folder)
    .filter((file) => file.endsWith('.cpp') || !existsSync(path.join(root, file.replace(/\.h$/, '.cpp'))))
    .filter((file) => read(file).split('\n').length - 1 > MOST_LINES);

test('the comment that opens a file ends at its first other line', () => {
  expect(bannerOf('// one\n// two\n#include "x"\n// three\n')).toBe('// one\n// two\n');
  expect(bannerOf('#include "x"\n')).toBe('');
});

test.each([...librariesOf(root).keys()])('%s', (folder) => {
  const missing = unitsOf(folder).filter((file) => {
    const unit = file.replace(/\.(cpp|h)$/, '');
    return !existsSync(path.join(root, `tests/${unit}_test.cpp`)) && !covered.has(path.basename(unit));
  });
  expect(missing).toEqual([]);
});

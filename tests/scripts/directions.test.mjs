// Who may include whom in the C++: what the linker holds for calls (the *_stands targets), held for headers too.
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { closureOf, librariesIn, librariesOf, sourcesOf } from '../../scripts/libraries.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const libraries = librariesOf(root);

/** Includes of `text`, a source in `folder`, that the folder may not use. */
function upwardIncludes(folder, text, table = libraries) {
  const allowed = new Set(closureOf(table, folder));
  return [...text.matchAll(/^#include "([^"]+)"/gm)]
    .map(([, file]) => file)
    .filter((file) => !allowed.has(path.posix.dirname(file)));
}

test('the table of libraries is read as it is written', () => {
  const table = librariesIn(
    'fiatlux_library(a)\nfiatlux_library(b USES a LINKS zlib)\n fiatlux_library(c USES b\n  LINKS x::y)',
  );
  expect([...table]).toEqual([
    ['a', []],
    ['b', ['a']],
    ['c', ['b']],
  ]);
  expect(closureOf(table, 'c')).toEqual(['a', 'b', 'c']);
  expect(() => closureOf(table, 'd')).toThrow('d is no library');
});

test('an upward include is found', () => {
  expect(upwardIncludes('core/scene', '#include "core/search/intentions.h"\n')).toEqual([
    'core/search/intentions.h',
  ]);
  expect(upwardIncludes('core/scene', '#include "core/base/vec3.h"\n#include <vector>\n')).toEqual([]);
});

test('every folder with sources is a library', () => {
  for (const top of ['core', 'precompute'])
    for (const entry of readdirSync(path.join(root, top), { withFileTypes: true }))
      if (entry.isDirectory()) expect([...libraries.keys()]).toContain(`${top}/${entry.name}`);
});

test.each([...libraries.keys()])('%s includes only what it may use', (folder) => {
  const sources = sourcesOf(root, folder);
  expect(sources.length).toBeGreaterThan(0);
  for (const file of sources)
    expect({ file, upward: upwardIncludes(folder, readFileSync(path.join(root, file), 'utf8')) }).toEqual({
      file,
      upward: [],
    });
});

/**
 * Who may import whom in the page. A floor imports itself and the floors named beside it, never one above; the oldest
 * dependency of all is a type, so imports of types count like any other.
 */
import { expect, test } from '@jest/globals';
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const web = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../web');

/** The first floor whose path begins a file's path is the file's; what it may import besides itself. */
const floors: readonly (readonly [floor: string, below: readonly string[]])[] = [
  ['language/', []],
  ['document/', ['language/']],
  ['offline/', []],
  ['solver/', ['document/', 'language/']],
  ['builder/', ['document/']],
  ['viewer/types.ts', ['document/']],
  ['viewer/stage/', ['viewer/types.ts', 'document/', 'language/']],
  ['viewer/light/', ['viewer/eye/', 'viewer/stage/', 'viewer/types.ts', 'document/', 'language/']],
  ['viewer/eye/', ['viewer/stage/', 'viewer/types.ts', 'document/', 'language/']],
  [
    'viewer/room/',
    ['viewer/eye/', 'viewer/light/', 'viewer/stage/', 'viewer/types.ts', 'document/', 'language/'],
  ],
  ['viewer/luminaires/', ['viewer/stage/', 'viewer/types.ts', 'document/', 'language/']],
  ['viewer/', ['document/', 'language/']],
  ['room-maker/', ['document/']],
  ['app/', ['room-maker/', 'viewer/', 'solver/', 'builder/', 'document/', 'language/']],
  ['panel/controls/', ['app/', 'document/', 'language/']],
  ['report/', ['app/', 'viewer/', 'solver/', 'document/', 'language/']],
  ['panel/', ['report/', 'app/', 'room-maker/', 'viewer/', 'solver/', 'document/', 'language/']],
];

const floorOf = (file: string) => floors.find(([floor]) => file.startsWith(floor))?.[0];

/** Paths below web/ of the modules that a module names, in `import`, `export ... from`, `import()` or `new URL()`. */
function importsOf(file: string, text: string): string[] {
  const named = text.matchAll(/(?:\bfrom|\bimport|\bimport\(|new URL\()\s*'(\.[^']+)'/g);
  return [...named].map(([, name = '']) => path.posix.join(path.posix.dirname(file), name));
}

/** The imports of a module that go up, as "a imports b". */
function upward(file: string, text: string): string[] {
  const own = floorOf(file);
  const below = floors.find(([floor]) => floor === own)?.[1] ?? [];
  return importsOf(file, text)
    .filter((name) => own && ![own, ...below].some((floor) => name.startsWith(floor)))
    .map((name) => `${file} imports ${name}`);
}

const modules = readdirSync(web, { recursive: true, encoding: 'utf8' })
  .map((file) => file.split(path.sep).join('/'))
  .filter((file) => /\.tsx?$/.test(file))
  .map((file) => ({ file, text: readFileSync(path.join(web, file), 'utf8') }));

test('no module of the page imports from a floor above its own', () => {
  expect(modules.flatMap(({ file, text }) => upward(file, text))).toEqual([]);
});

test('every module but the two entries lies on a floor, and most of them import something', () => {
  const homeless = modules.filter(({ file }) => !floorOf(file)).map(({ file }) => file);
  expect(homeless.sort()).toEqual(['main.ts', 'start.tsx']);
  const importing = modules.filter(({ file, text }) => importsOf(file, text).length > 0);
  expect(importing.length).toBeGreaterThan(modules.length / 2);
});

test.each([
  ['document/types.ts', "import type { Shown } from '../solver/protocol.ts';"],
  ['solver/protocol.ts', "export { firstRoom } from '../app/opening/first-scene.ts';"],
  ['viewer/room/room-mesh.ts', "import { pick } from '../hand/picking.ts';"],
  ['viewer/viewer.ts', "import {\n  useApp,\n} from '../app/app.ts';"],
  ['app/keeping.ts', "const shell = await import('../panel/shell.tsx');"],
  ['panel/controls/menu.tsx', "import '../shell.tsx';"],
])('an import that goes up from %s is found', (file, text) => {
  expect(upward(file, text)).toHaveLength(1);
});

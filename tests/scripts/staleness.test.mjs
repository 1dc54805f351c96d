// Which edits make which sample rooms stale: one byte changed in a file, the keys asked again, nothing computed.
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { closureOf, librariesOf } from '../../scripts/libraries.mjs';
import { generatorOf, moduleFiles, pageKey, roomKeys } from '../../scripts/staleness.mjs';
import { catalog } from '../../rooms/catalog.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const files = ['core', 'precompute', 'rooms', 'wasm', 'web', 'scripts'].flatMap((top) =>
  readdirSync(path.join(root, top), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => path.relative(root, path.join(entry.parentPath ?? entry.path, entry.name))),
);
const ids = catalog.map(({ id }) => id);
const texts = new Map(files.map((file) => [file, readFileSync(path.join(root, file), 'utf8')]));
const read = (file) => texts.get(file);
const keys = roomKeys({ files, read, catalog });

/** The rooms whose key is another one; `part`: 'scene' or 'model'. */
function changedRooms(input, part = 'scene') {
  const others = roomKeys({ files, read, catalog, ...input });
  return ids.filter((id) => keys.get(id)[part] !== others.get(id)[part]);
}

/** The same project with the last byte of one file another one. */
const edited = (file) => ({
  read: (name) => (name === file ? `${read(name).slice(0, -1)} ` : read(name)),
});

const linked = new Set(closureOf(librariesOf(root), 'precompute/pipeline'));
const folders = [...librariesOf(root).keys()];
const sourcesIn = (folder) =>
  files.filter((file) => path.posix.dirname(file) === folder && /\.(cpp|h)$/.test(file));

test('the same project has the same keys, and no two rooms share one', () => {
  expect(changedRooms({})).toEqual([]);
  expect(changedRooms({ files: files.toReversed() })).toEqual([]);
  expect(new Set([...keys.values()].flatMap(({ model, scene }) => [model, scene])).size).toBe(2 * ids.length);
});

test('the pipeline links some folders and not all', () => {
  expect(linked).toContain('precompute/room');
  expect(linked.size).toBeLessThan(folders.length);
});

test.each(folders)(
  'an edit in %s makes all rooms stale or none, as the pipeline links it or not',
  (folder) => {
    const sources = sourcesIn(folder);
    expect(sources.length).toBeGreaterThan(0);
    for (const file of sources)
      expect({ file, stale: changedRooms(edited(file)) }).toEqual({
        file,
        stale: linked.has(folder) ? ids : [],
      });
  },
);

test('an edit of the bounding boxes makes all rooms stale', () => {
  expect(changedRooms(edited('precompute/room/bounds.h'))).toEqual(ids);
});

test('a file that comes or goes in a folder of the pipeline makes all rooms stale', () => {
  const none = files.filter((file) => file !== 'precompute/room/bounds.h');
  expect(changedRooms({ files: none })).toEqual(ids);
});

test.each(ids)('an edit of the generator of %s makes that room stale', (id) => {
  expect(changedRooms(edited(generatorOf(id)))).toEqual([id]);
  expect(changedRooms(edited(generatorOf(id)), 'model')).toEqual([id]);
});

test.each(ids)('other options of %s make its scene stale and not its model', (id) => {
  const other = catalog.map((room) =>
    room.id === id ? { ...room, precompute: [...room.precompute, '--rays', '2048'] } : room,
  );
  expect(changedRooms({ catalog: other })).toEqual([id]);
  expect(changedRooms({ catalog: other }, 'model')).toEqual([]);
});

test('another title changes no key', () => {
  expect(changedRooms({ catalog: catalog.map((room) => ({ ...room, title: 'Cellar' })) })).toEqual([]);
});

test('an edit of what generators share makes the rooms stale that use it, however far away', () => {
  expect(changedRooms(edited('rooms/room.mjs'))).toEqual(ids);
  expect(changedRooms(edited('rooms/materials.mjs'))).toEqual(ids); // by way of room.mjs
  expect(changedRooms(edited('rooms/sculptures.mjs'))).toEqual(['gallery', 'museum']);
  expect(changedRooms(edited('web/room-maker/furniture.mjs'))).toEqual(
    ids.filter((id) => !['e-corridor', 'box'].includes(id)),
  );
});

test('an edit elsewhere makes no room stale', () => {
  const elsewhere = files.filter(
    (file) =>
      !/^(core|precompute)\/.*\.(cpp|h)$/.test(file) &&
      !/^(rooms\/|web\/room-maker\/|web\/document\/linear-colour)/.test(file),
  );
  const others = [...elsewhere, 'rooms/make.mjs', 'rooms/catalog.mjs', 'precompute/main.cpp'].filter(
    (file) => !file.endsWith('CMakeLists.txt'), // which say what the pipeline links
  );
  expect(others.length).toBeGreaterThan(100);
  const all = new Set(others);
  expect(changedRooms({ read: (name) => (all.has(name) ? 'edited' : read(name)) })).toEqual([]);
});

test('imports are followed in all their forms, once each', () => {
  const modules = {
    'rooms/a.mjs': "import { b } from './b.mjs';\nimport './c.mjs';\nimport path from 'node:path';",
    'rooms/b.mjs': "export { x } from '../common/d.mjs';\nimport './a.mjs';",
    'rooms/c.mjs': "const e = await import('./e.mjs');",
    'rooms/e.mjs': '',
    'common/d.mjs': '',
  };
  expect(moduleFiles('rooms/a.mjs', (file) => modules[file])).toEqual(Object.keys(modules).sort());
});

test('an edit in web/, or of what bundles it, makes the page stale, and no other edit', () => {
  const bundling = ['package-lock.json', 'tsconfig.json', 'vite.config.js'];
  for (const file of bundling) texts.set(file, readFileSync(path.join(root, file), 'utf8'));
  const key = pageKey({ files, read });
  const isStale = (file) => pageKey({ files, ...edited(file) }) !== key;
  const oneOfEachFolder = new Map(files.map((file) => [path.posix.dirname(file), file])).values();
  for (const file of [...oneOfEachFolder, ...bundling])
    expect({ file, stale: isStale(file) }).toEqual({
      file,
      stale: file.startsWith('web/') || bundling.includes(file),
    });
  expect(pageKey({ files: [...files, 'web/new.ts'], read: (file) => read(file) ?? '' })).not.toBe(key);
});

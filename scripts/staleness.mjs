// What a sample room's scene file comes from, as one key: the room's generator with the modules that it imports, its
// options, and the folders of C++ that the pipeline links. Nothing else makes a room stale. And the key of the page.
import { createHash } from 'node:crypto';
import path from 'node:path';
import { closureOf, librariesIn } from './libraries.mjs';

/** The library that turns the bytes of a model into the bytes of a scene. */
const pipeline = 'precompute/pipeline';

export function hashOf(...parts) {
  const hash = createHash('sha256');
  for (const part of parts) hash.update(`${part.length}:`).update(part);
  return hash.digest('hex');
}

/** The C++ of the pipeline and of every folder that it may use, among `files`. */
function methodFiles(files, read) {
  const lines = ['core', 'precompute'].map((top) => read(`${top}/CMakeLists.txt`)).join('\n');
  const folders = new Set(closureOf(librariesIn(lines), pipeline));
  return files.filter((file) => /\.(cpp|h)$/.test(file) && folders.has(path.posix.dirname(file))).sort();
}

/** A module and, through its relative imports, those that it needs. */
export function moduleFiles(file, read, seen = new Set()) {
  seen.add(file);
  for (const [, name] of read(file).matchAll(/\b(?:from|import)\s*\(?\s*['"](\.[^'"]+)['"]/g)) {
    const imported = path.posix.join(path.posix.dirname(file), name);
    if (!seen.has(imported)) moduleFiles(imported, read, seen);
  }
  return [...seen].sort();
}

/** A room's generator. */
export const generatorOf = (id) => `rooms/${id}.mjs`;

/**
 * By room: `model`, the key of its .glb, and `scene`, that of its .flux. `files`: paths of the project from its root;
 * `read`: the text of one; `catalog`: the rooms, each with its id and its options for `fiatlux precompute`.
 */
export function roomKeys({ files, read, catalog }) {
  const hashFiles = (names) => hashOf(...names.flatMap((name) => [name, read(name)]));
  const method = hashFiles(methodFiles(files, read));
  return new Map(
    catalog.map(({ id, precompute }) => {
      const model = hashFiles(moduleFiles(generatorOf(id), read));
      return [id, { model, scene: hashOf(model, precompute.join(' '), method) }];
    }),
  );
}

/** The key of the page: its folder, the solver's module in it, and what bundles them. */
export function pageKey({ files, read }) {
  const names = files.filter((file) => file.startsWith('web/')).sort();
  const bundling = ['package-lock.json', 'tsconfig.json', 'vite.config.js'];
  return hashOf(...[...names, ...bundling].flatMap((name) => [name, read(name)]));
}

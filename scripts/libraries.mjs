// The folders of core/ and precompute/ and which may use which, read off the lines that build them:
// fiatlux_library(precompute/rays USES precompute/room ...).
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';

/** Folder -> the folders named after USES, from the text of a CMakeLists.txt. */
export function librariesIn(cmake) {
  const libraries = new Map();
  for (const [, words] of cmake.matchAll(/^\s*fiatlux_library\(([^)]*)\)/gm)) {
    const [folder, ...rest] = words.trim().split(/\s+/);
    const from = rest.indexOf('USES');
    const to = rest.indexOf('LINKS');
    libraries.set(folder, from < 0 ? [] : rest.slice(from + 1, to < 0 ? undefined : to));
  }
  return libraries;
}

/** All folders of the project's C++ libraries. */
export function librariesOf(root) {
  const text = ['core', 'precompute'].map((top) =>
    readFileSync(path.join(root, top, 'CMakeLists.txt'), 'utf8'),
  );
  return librariesIn(text.join('\n'));
}

/** `folder` and everything that it may use, directly or through others, in a fixed order. */
export function closureOf(libraries, folder, seen = new Set()) {
  if (!libraries.has(folder)) throw new Error(`${folder} is no library: name it in a fiatlux_library() line`);
  seen.add(folder);
  for (const used of libraries.get(folder)) if (!seen.has(used)) closureOf(libraries, used, seen);
  return [...seen].sort();
}

/** Sources of a library, sorted. */
export function sourcesOf(root, folder) {
  return readdirSync(path.join(root, folder))
    .filter((name) => /\.(cpp|h)$/.test(name))
    .sort()
    .map((name) => `${folder}/${name}`);
}

// Files that others read meanwhile: all of one is there, or none of it.
import { copyFile, rename, writeFile } from 'node:fs/promises';

export async function copyWhole(from, to) {
  await copyFile(from, `${to}.tmp`);
  await rename(`${to}.tmp`, to);
}

export async function writeWhole(file, content) {
  await writeFile(`${file}.tmp`, content);
  await rename(`${file}.tmp`, file);
}

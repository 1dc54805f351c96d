// The static site, dist/: the page, made where its sources are others than last time, and what public/ holds.
import { cp, mkdir, readdir, rm, writeFile } from 'node:fs/promises';
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import path from 'node:path';
import { root, runBeside, say } from './processes.mjs';
import { writeRoomPages } from './room-pages.mjs';
import { hashOf, pageKey } from './staleness.mjs';

const dist = path.join(root, 'dist');
const index = path.join(dist, 'index.html');
const mark = path.join(root, 'build', 'stamps', 'page');

/** Of the sources and of what was made of them: index.html names every script by its contents. */
function stampOfPage() {
  const files = readdirSync(path.join(root, 'web'), { recursive: true })
    .map((name) => path.posix.join('web', name))
    .filter((file) => statSync(path.join(root, file)).isFile());
  const sources = pageKey({ files, read: (file) => readFileSync(path.join(root, file)) });
  return hashOf(sources, readFileSync(index));
}

/** Rooms, modules and luminaires change without the page: dist/ has those of public/ and no others. */
async function copyPublic() {
  const from = path.join(root, 'public');
  for (const name of await readdir(from)) {
    await rm(path.join(dist, name), { recursive: true, force: true });
    await cp(path.join(from, name), path.join(dist, name), { recursive: true });
  }
}

/** `origin`: the site's address where it is known; then there is a page a room, too. */
export async function site(origin = null) {
  const isMade = existsSync(index) && existsSync(mark) && readFileSync(mark, 'utf8') === stampOfPage();
  if (isMade && !origin) return copyPublic();
  say('Building the site');
  await runBeside('site', 'npx', ['vite', 'build', '--logLevel', 'warn']);
  if (origin) return writeRoomPages(dist, origin); // which writes in the page: it is made anew next time
  await mkdir(path.dirname(mark), { recursive: true });
  await writeFile(mark, stampOfPage());
}

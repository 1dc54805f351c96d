// Writes the sample rooms as binary glTF: node rooms/make.mjs [id ...] -> public/scenes/<id>.glb
import { mkdir, rename, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { catalog } from './catalog.mjs';
import { makeRoom } from './index.mjs';

const folder = fileURLToPath(new URL('../public/scenes/', import.meta.url));
const known = catalog.map((room) => room.id);
const wanted = process.argv.length > 2 ? process.argv.slice(2) : known;
const unknown = wanted.filter((id) => !known.includes(id));
if (unknown.length > 0) {
  console.error(`make.mjs: no sample room is called "${unknown[0]}"; the rooms are ${known.join(', ')}`);
  process.exit(2);
}

await mkdir(folder, { recursive: true });
for (const id of wanted) {
  const bytes = await makeRoom(id).bytes();
  await writeFile(`${folder}${id}.glb.tmp`, bytes);
  await rename(`${folder}${id}.glb.tmp`, `${folder}${id}.glb`);
  console.error(`${id}.glb  ${(bytes.length / 1024).toFixed(0)} KiB`);
}

// Writes the sample rooms as binary glTF and the list of them: node rooms/make.mjs [--folder FOLDER] [id ...]
// The generator of a room is the module of its id, which exports makeRoom.
// Without ids all that the gallery shows, without a folder into public/scenes.
import { mkdir } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { writeCatalog } from './catalog-file.mjs';
import { catalog } from './catalog.mjs';
import { writeWhole } from './whole-files.mjs';

const known = catalog.map((room) => room.id);
const others = ['hall']; // that the gallery does not show: made where they are named

function wishes() {
  try {
    const { values, positionals } = parseArgs({
      options: { folder: { type: 'string' } },
      allowPositionals: true,
    });
    const stranger = positionals.find((id) => ![...known, ...others].includes(id));
    if (stranger !== undefined)
      throw new Error(
        `no sample room is called "${stranger}"; there are ${[...known, ...others].join(', ')}`,
      );
    const folder = values.folder ?? fileURLToPath(new URL('../public/scenes/', import.meta.url));
    return { folder, ids: positionals.length > 0 ? positionals : known };
  } catch (error) {
    console.error(`rooms/make.mjs: ${error.message}`);
    process.exit(2);
  }
}

const { folder, ids } = wishes();
await mkdir(folder, { recursive: true });
await writeCatalog(folder);
for (const id of ids) {
  const { makeRoom } = await import(`./${id}.mjs`);
  const bytes = await makeRoom().bytes();
  await writeWhole(path.join(folder, `${id}.glb`), bytes);
  console.error(`${id}.glb  ${(bytes.length / 1024).toFixed(0)} KiB`);
}

// Writes the generic luminaires as photometric files: node rooms/luminaires.mjs [--folder FOLDER]
// Without a folder into public/luminaires; catalog.json beside them says what they are.
import { mkdir, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { luminaires } from './luminaire-catalog.mjs';
import { iesFile, ldtFile } from './photometric-file.mjs';

function wantedFolder() {
  try {
    const { values } = parseArgs({ options: { folder: { type: 'string' } } });
    return values.folder ?? fileURLToPath(new URL('../public/luminaires/', import.meta.url));
  } catch (error) {
    console.error(`rooms/luminaires.mjs: ${error.message}`);
    process.exit(2);
  }
}

const folder = wantedFolder();
await mkdir(folder, { recursive: true });
const entries = luminaires.map(({ id, title, description, format, flux, watts, cct }) => ({
  id,
  title,
  description,
  file: `${id}.${format}`,
  flux,
  watts,
  cct,
}));
for (const [i, luminaire] of luminaires.entries()) {
  const file = luminaire.format === 'ies' ? iesFile(luminaire) : ldtFile(luminaire);
  await writeFile(path.join(folder, entries[i].file), file);
}
await writeFile(path.join(folder, 'catalog.json'), `${JSON.stringify(entries, null, 2)}\n`);
console.error(`${entries.length} luminaires in ${folder}`);

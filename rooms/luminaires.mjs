// Writes the generic luminaires as photometric files: node rooms/luminaires.mjs [--folder FOLDER]
// Without a folder into public/luminaires.
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { writeLuminaires } from './luminaire-files.mjs';

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
console.error(`${(await writeLuminaires(folder)).length} luminaires in ${folder}`);

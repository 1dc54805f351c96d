// The generic luminaires as files: one photometric file each, and luminaires/catalog.json, the list that the page reads.
import { mkdir, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { luminaires } from './luminaire-catalog.mjs';
import { iesFile, ldtFile } from './photometric-file.mjs';

/** Writes them into a folder; resolves to the list. */
export async function writeLuminaires(folder) {
  await mkdir(folder, { recursive: true });
  const list = luminaires.map(({ id, title, description, translations, format, flux, watts, cct }) => ({
    id,
    title,
    description,
    translations,
    file: `${id}.${format}`,
    flux,
    watts,
    cct,
  }));
  for (const [i, luminaire] of luminaires.entries()) {
    const file = luminaire.format === 'ies' ? iesFile(luminaire) : ldtFile(luminaire);
    await writeFile(path.join(folder, list[i].file), file);
  }
  await writeFile(path.join(folder, 'catalog.json'), `${JSON.stringify(list, null, 2)}\n`);
  return list;
}

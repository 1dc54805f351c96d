/** The models in a .zip, with what they name; nothing is inflated that is not wanted or is too large. */
import { unzipSync } from 'fflate';
import { cureOf, isModel, modelEndings } from './model-files.ts';
import { words } from '../../language/language.ts';

const mostBytes = 256 << 20; // inflated, all together
const mostFiles = 2000;
const rooms = /\.(gltf|glb|stf|flux)$/i;
const parts = /\.(bin|mtl|png|jpe?g|webp|tga|bmp|gif)$/i; // of models
const luminaires = /\.(ies|ldt|eul)$|^product\.xml$/i; // of a maker's zip or a GLDF
// What macOS packs beside each file has the file's extension and nothing of it.
const isJunk = (name: string): boolean => /(^|\/)(__MACOSX\/|\._)/.test(name);
const isRoom = (name: string): boolean => !isJunk(name) && (rooms.test(name) || isModel(name));
const isWanted = (name: string): boolean => isRoom(name) || (parts.test(name) && !isJunk(name));

/** null where the zip holds luminaires and no model. Throws one sentence where it is damaged, or holds neither or too much. */
export async function unzippedModel(file: File): Promise<File[] | null> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  let [total, count, hasModel] = [0, 0, false];
  const names: string[] = [];
  const look = ({ name, originalSize }: { name: string; originalSize: number }) => {
    if (!isJunk(name) && names.length < mostFiles) names.push(name);
    if (!isWanted(name)) return false;
    total += originalSize;
    count += 1;
    hasModel ||= isRoom(name);
    return false;
  };
  try {
    unzipSync(bytes, { filter: look });
  } catch {
    throw new Error(words.value.opening.import.zipDamaged(file.name));
  }
  if (!hasModel && names.some((name) => luminaires.test(name))) return null;
  if (!hasModel) throw new Error(withoutModel(file.name, names));
  if (total > mostBytes || count > mostFiles)
    throw new Error(words.value.opening.import.zipTooLarge(file.name, Math.round(total / 1e6), count));
  const inside = unzipSync(bytes, { filter: ({ name }) => isWanted(name) });
  return Object.entries(inside).map(
    ([name, content]) => new File([new Uint8Array(content)], name.replace(/^.*[\\/]/, '')),
  );
}

/** What is said of a zip with nothing to open: the way for what is in it, or else what a zip may hold. */
function withoutModel(zip: string, names: readonly string[]): string {
  const { comesFrom, zipInZip, zipWithoutModel } = words.value.opening.import;
  const [known] = names.filter((name) => cureOf(name) !== null);
  if (known !== undefined) return comesFrom(known.replace(/^.*[\\/]/, ''), cureOf(known) ?? '');
  return names.some((name) => /\.zip$/i.test(name)) ? zipInZip(zip) : zipWithoutModel(zip, modelEndings);
}

/** The models in a .zip, with what they name; nothing is inflated that is not wanted or is too large. */
import { unzipSync } from 'fflate';
import { isModel } from './model-files.ts';
import { words } from '../../language/language.ts';

const mostBytes = 256 << 20; // inflated, all together
const mostFiles = 2000;
const rooms = /\.(gltf|glb|stf)$/i;
const parts = /\.(bin|mtl|png|jpe?g|webp|tga|bmp|gif)$/i; // of models
const isRoom = (name: string): boolean => rooms.test(name) || isModel(name);
const isWanted = (name: string): boolean => isRoom(name) || parts.test(name);

/** null where the zip holds no model: photometry, or something else. Throws one sentence where it is damaged or holds too much. */
export async function unzippedModel(file: File): Promise<File[] | null> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  let [total, count, hasModel] = [0, 0, false];
  const look = ({ name, originalSize }: { name: string; originalSize: number }) => {
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
  if (!hasModel) return null;
  if (total > mostBytes || count > mostFiles)
    throw new Error(words.value.opening.import.zipTooLarge(file.name, Math.round(total / 1e6), count));
  const inside = unzipSync(bytes, { filter: ({ name }) => isWanted(name) });
  return Object.entries(inside).map(
    ([name, content]) => new File([new Uint8Array(content)], name.replace(/^.*[\\/]/, '')),
  );
}

/** The models in a .zip, with what they name; nothing is inflated that is not wanted or is too large. */
import { unzipSync } from 'fflate';
import { words } from '../../language/language.ts';

const mostBytes = 256 << 20; // inflated, all together
const mostFiles = 2000;
const wanted = /\.(gltf|glb|bin|obj|mtl|stl|dae|fbx|3ds|ifc|stf|png|jpe?g|webp|tga|bmp|gif)$/i;
const model = /\.(gltf|glb|obj|stl|dae|fbx|3ds|ifc|stf)$/i;

/** null where the zip holds no model: photometry, or something else. Throws one sentence where it is damaged or holds too much. */
export async function unzippedModel(file: File): Promise<File[] | null> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  let [total, count, hasModel] = [0, 0, false];
  const look = ({ name, originalSize }: { name: string; originalSize: number }) => {
    if (!wanted.test(name)) return false;
    total += originalSize;
    count += 1;
    hasModel ||= model.test(name);
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
  const inside = unzipSync(bytes, { filter: ({ name }) => wanted.test(name) });
  return Object.entries(inside).map(
    ([name, content]) => new File([new Uint8Array(content)], name.replace(/^.*[\\/]/, '')),
  );
}

/**
 * The models in a .zip, with what they name; nothing is inflated that is not wanted or is too large, and the page goes on
 * meanwhile: what says less of its size than it holds takes long.
 */
import { unzipSync } from 'fflate';
import type { Inflated, Zipped } from './inflate.ts';
import { cureOf, isModel, modelEndings } from './model-files.ts';
import { words } from '../../language/language.ts';

const mostBytes = 256 << 20; // inflated, all together
const untold = 0xffffffff; // bytes: a size that does not fit into its field
const mostFiles = 2000;
const mostTime = 30_000; // ms of inflating
const rooms = /\.(gltf|glb|stf|flux)$/i;
const parts = /\.(bin|mtl|png|jpe?g|webp|tga|bmp|gif)$/i; // of models
const luminaires = /\.(ies|ldt|eul)$|^product\.xml$/i; // of a maker's zip or a GLDF
// What macOS packs beside each file has the file's extension and nothing of it.
const isJunk = (name: string): boolean => /(^|\/)(__MACOSX\/|\._)/.test(name);
const isRoom = (name: string): boolean => !isJunk(name) && (rooms.test(name) || isModel(name));
const isWanted = (name: string): boolean => isRoom(name) || (parts.test(name) && !isJunk(name));

/** In a worker; what takes too long is damaged. */
async function inflated(zipped: Zipped): Promise<Inflated> {
  const worker = new Worker(new URL('./unzip-worker.ts', import.meta.url), { type: 'module', name: 'unzip' });
  let late: ReturnType<typeof setTimeout> | undefined;
  return new Promise<Inflated>((resolve) => {
    worker.onmessage = ({ data }: MessageEvent<Inflated>) => resolve(data);
    worker.onerror = () => resolve(null);
    late = setTimeout(() => resolve(null), mostTime);
    worker.postMessage(zipped);
  }).finally(() => {
    clearTimeout(late);
    worker.terminate();
  });
}

/** null where the zip holds luminaires and no model. Throws one sentence where it is damaged, or holds neither or too much. */
export async function unzippedModel(file: File, inflate = inflated): Promise<File[] | null> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const names: string[] = [];
  const wanted: string[] = [];
  let total = 0;
  let isLying = false;
  let isUntold = false;
  const look = ({ name, size, originalSize }: { name: string; size: number; originalSize: number }) => {
    if (!isJunk(name) && names.length < mostFiles) names.push(name);
    if (!isWanted(name)) return false;
    wanted.push(name);
    total += originalSize;
    isUntold ||= originalSize === untold;
    isLying ||= size > longestDeflated(originalSize);
    return false;
  };
  try {
    unzipSync(bytes, { filter: look });
  } catch {
    isLying = true;
  }
  if (isLying) throw new Error(words.value.opening.import.zipDamaged(file.name));
  const hasModel = wanted.some(isRoom);
  if (!hasModel && names.some((name) => luminaires.test(name))) return null;
  if (!hasModel) throw new Error(withoutModel(file.name, names));
  if (total > mostBytes || wanted.length > mostFiles)
    throw new Error(
      words.value.opening.import.zipTooLarge(file.name, sizeText(total, isUntold), wanted.length),
    );
  const inside = await inflate({ bytes, wanted });
  if (!inside) throw new Error(words.value.opening.import.zipDamaged(file.name));
  return Object.entries(inside).map(([name, content]) => new File([content], name.replace(/^.*[\\/]/, '')));
}

/** Bytes that so many never take more of: what cannot be made smaller is stored, with some bytes for every block. */
const longestDeflated = (size: number): number => size + 1000 + Math.ceil(size / 1000);

/** "1000 MB"; of what does not tell its size, what is certain. */
function sizeText(bytes: number, isUntold: boolean): string {
  if (isUntold) return words.value.opening.import.zipMoreThan(`${mostBytes >> 20} MB`);
  return `${Math.round(bytes / 1e6)} MB`;
}

/** What is said of a zip with nothing to open: the way for what is in it, or else what a zip may hold. */
function withoutModel(zip: string, names: readonly string[]): string {
  const { comesFrom, zipInZip, zipWithoutModel } = words.value.opening.import;
  const [known] = names.filter((name) => cureOf(name) !== null);
  if (known !== undefined) return comesFrom(known.replace(/^.*[\\/]/, ''), cureOf(known) ?? '');
  return names.some((name) => /\.zip$/i.test(name)) ? zipInZip(zip) : zipWithoutModel(zip, modelEndings);
}

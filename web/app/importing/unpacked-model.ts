/** Models made plain, out of the way of the page: the decoders are fetched when a model needs them. */
import { words } from '../../language/language.ts';
import type { Packed, Unpacked } from './unpack-worker.ts';

/** One plain .glb; null where the model is broken, which the builder tells better. Throws one clause where its meshes are. */
export async function unpackedModel(model: Packed): Promise<Uint8Array<ArrayBuffer> | null> {
  const worker = new Worker(new URL('./unpack-worker.ts', import.meta.url), {
    type: 'module',
    name: 'unpack',
  });
  const answer = await new Promise<Unpacked>((resolve) => {
    worker.onmessage = ({ data }: MessageEvent<Unpacked>) => resolve(data);
    worker.onerror = () => resolve(null);
    worker.postMessage(model);
  }).finally(() => worker.terminate());
  if (answer === 'damaged') throw new Error(words.value.opening.damagedMesh);
  return answer;
}

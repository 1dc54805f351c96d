/** Models made plain, out of the way of the page: the decoders are fetched when a model needs them. */
import type { Packed } from './unpack-worker.ts';

/** One plain .glb; null where the model is broken, which the builder tells better. */
export function unpackedModel(model: Packed): Promise<Uint8Array<ArrayBuffer> | null> {
  const worker = new Worker(new URL('./unpack-worker.ts', import.meta.url), {
    type: 'module',
    name: 'unpack',
  });
  return new Promise<Uint8Array<ArrayBuffer> | null>((resolve) => {
    worker.onmessage = ({ data }: MessageEvent<Uint8Array<ArrayBuffer> | null>) => resolve(data);
    worker.onerror = () => resolve(null);
    worker.postMessage(model);
  }).finally(() => worker.terminate());
}

/** The worker that makes models plain: one question, one answer, and it is gone. */
import dracoAddress from 'draco3dgltf/draco_decoder_gltf.wasm?url';
import { DamagedMesh, plainGlb, type Codecs } from './plain-glb.ts';

export interface Packed {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly siblings: ReadonlyMap<string, Uint8Array<ArrayBuffer>>;
}

/** The plain .glb; null where the file is broken otherwise than in what is compressed. */
export type Unpacked = Uint8Array<ArrayBuffer> | 'damaged' | null;

declare const self: DedicatedWorkerGlobalScope;

const codecs: Codecs = {
  async draco() {
    const { default: createDecoder } = await import('draco3dgltf/draco_decoder_gltf_nodejs.js');
    const wasm = await fetch(dracoAddress);
    return createDecoder({ wasmBinary: await wasm.arrayBuffer() });
  },
  async meshopt() {
    const { MeshoptDecoder } = await import('meshoptimizer/decoder');
    await MeshoptDecoder.ready;
    return MeshoptDecoder;
  },
  async png(picture, type) {
    try {
      const bitmap = await createImageBitmap(new Blob([picture], { type }));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      canvas.getContext('2d')?.drawImage(bitmap, 0, 0);
      const png = await canvas.convertToBlob({ type: 'image/png' });
      return new Uint8Array(await png.arrayBuffer());
    } catch {
      return null; // the builder names it
    }
  },
};

self.onmessage = async ({ data }: MessageEvent<Packed>) => {
  const answer = await plainGlb(data.bytes, data.siblings, codecs).catch((error: unknown) =>
    error instanceof DamagedMesh ? ('damaged' as const) : null,
  );
  self.postMessage(answer satisfies Unpacked, answer instanceof Uint8Array ? [answer.buffer] : []);
};

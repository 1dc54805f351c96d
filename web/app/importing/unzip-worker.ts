/** The worker that inflates a zip: one question, one answer, and it is gone. */
import { inflate, type Zipped } from './inflate.ts';

declare const self: DedicatedWorkerGlobalScope;

self.onmessage = ({ data }: MessageEvent<Zipped>) => {
  const inside = inflate(data);
  const buffers = new Set(Object.values(inside ?? {}).map(({ buffer }) => buffer));
  self.postMessage(inside, [...buffers]);
};

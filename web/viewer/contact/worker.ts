/** Works out how open a room is while the page goes on; one room, one answer. */
import { openness, type Solid } from './openness.ts';

declare const self: DedicatedWorkerGlobalScope;

self.onmessage = ({ data }: MessageEvent<Solid>) => {
  const found = openness(data);
  self.postMessage(
    found,
    [...found.tiles, found.values, found.means].map(({ buffer }) => buffer),
  );
};

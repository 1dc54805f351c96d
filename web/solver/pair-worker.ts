/** Goes through the pairs of a bound, step by step, and tells what is proved whenever that has become more. */
import { loadCore } from './load-core.ts';
import type { Proved } from './pair-proof.ts';

declare const self: DedicatedWorkerGlobalScope;

const tell = (proved: Proved) => self.postMessage(proved);

async function prove(pairs: Float64Array): Promise<void> {
  const core = await loadCore(new URL('./core.wasm', import.meta.url));
  const proof = new core.PairProof();
  if (!proof.begin(pairs)) throw new Error('these are no pairs');
  // A turn for each step: a worker is ended at once only between two turns.
  const turn = new MessageChannel();
  let told = -Infinity;
  turn.port1.onmessage = () => {
    const done = proof.advance();
    const goal = proof.goal();
    if (done || goal > told) tell({ goal, done });
    told = goal;
    if (!done) turn.port2.postMessage(null);
  };
  turn.port2.postMessage(null);
}

self.onmessage = ({ data }: MessageEvent<Float64Array>) =>
  void prove(data).catch(() => tell({ goal: -Infinity, done: true }));

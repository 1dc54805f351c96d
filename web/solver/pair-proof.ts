/**
 * The last stage of a bound in a worker of its own: a step of it may take longer than an answer. It ends with the worker,
 * whatever it is at.
 */

export interface Proved {
  readonly goal: number; // no layout has a goal below this; -Infinity: nothing is proved
  readonly done: boolean;
}

/** `pairs`: Session.takePairs(). `tell` hears of all that is proved. Returns what ends it; nothing is told after that. */
export type Proving = (pairs: Float64Array, tell: (proved: Proved) => void) => () => void;

const nothing: Proved = { goal: -Infinity, done: true };

export const proveAside: Proving = (pairs, tell) => {
  const worker = new Worker(new URL('./pair-worker.ts', import.meta.url), { type: 'module', name: 'proof' });
  const end = () => worker.terminate();
  worker.onmessage = ({ data }: MessageEvent<Proved>) => {
    if (data.done) end();
    tell(data);
  };
  worker.onerror = (event) => {
    event.preventDefault(); // else the page holds it for the end of the worker that started this one
    end();
    tell(nothing);
  };
  worker.postMessage(pairs, [pairs.buffer]);
  return end;
};

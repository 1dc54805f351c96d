/** The real worker of the app; the first one may be started before anybody asks for it. */
import type { WorkerLike } from './solver-client.ts';

let early: Worker | null = null;

function start(): Worker {
  return new Worker(new URL('./solver.worker.ts', import.meta.url), { type: 'module', name: 'solver' });
}

/** One that dies before it is taken is forgotten: whoever asks gets a new one, and hears of its death. */
export function startWorkerEarly(): void {
  early = start();
  early.onerror = () => (early = null);
}

export function createSolverWorker(): WorkerLike {
  const taken = early;
  early = null;
  return taken ?? start();
}

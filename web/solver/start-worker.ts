/** The real worker of the app; the first one may be started, and open a file, before anybody asks for it. */
import { AheadWorker } from './ahead-worker.ts';
import type { WorkerLike } from './solver-client.ts';

let early: WorkerLike | null = null;

function start(): Worker {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module', name: 'solver' });
}

/**
 * `address`: of the scene file that will be opened, where that is known. One that dies before it is taken is forgotten:
 * whoever asks gets a new one, and hears of its death.
 */
export function startWorkerEarly(address: string | null): AheadWorker | null {
  const forget = () => void (early = null);
  const worker = start();
  if (address !== null) {
    const ahead = new AheadWorker(worker, address, forget);
    early = ahead;
    return ahead;
  }
  worker.onerror = forget;
  early = worker;
  return null;
}

export function createSolverWorker(): WorkerLike {
  const taken = early;
  early = null;
  return taken ?? start();
}

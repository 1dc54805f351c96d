/** The alpha-search (paper, section 4) in slices: tells each iteration when it ends, the verdict when all have. */
import type { AlphaProgress, Session } from './core.ts';
import type { AlphaStep } from './protocol.ts';
import { pace, type Clock } from './search-job.ts';

export interface AlphaReport {
  readonly steps: readonly AlphaStep[];
  readonly end: AlphaProgress | null; // null while it runs
}

export class AlphaJob {
  readonly #session: Session;
  readonly #clock: Clock;
  #slice: number = pace.probe;
  #told = 0;

  /** The session's alpha-search has just been started. */
  constructor(session: Session, clock: Clock) {
    this.#session = session;
    this.#clock = clock;
  }

  /** One slice. Throws one readable line. */
  step(): AlphaReport {
    const start = this.#clock();
    const progress = this.#session.advanceAlpha(this.#slice, this.#told);
    if (typeof progress === 'string') throw new Error(progress);
    const spent = Math.max(this.#clock() - start, 0.05);
    this.#slice = Math.round(
      Math.min(200_000, Math.max(100, (this.#slice * pace.sliceMilliseconds) / spent)),
    );
    const steps = progress.steps.map(({ low, high, phi, ...step }, i) => ({
      ...step,
      iteration: this.#told + i + 1,
      interval: [low, high] as const,
      goal: phi,
    }));
    this.#told += steps.length;
    return { steps, end: progress.done ? progress : null };
  }
}

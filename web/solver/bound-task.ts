/** A provable bound on the goal of the search before it: tells each time the gap has become clearly smaller. */
import type { BoundProgress, OrError } from './core.ts';
import type { Searching } from './hung-session.ts';
import { Slicer, type Clock } from './pacing.ts';
import type { Proved } from './pair-proof.ts';
import { noTransfer, type Answer, type Task } from './task.ts';

const clearly = 0.005; // of the goal
const first = 20; // steps of the first slice

export class BoundTask implements Task {
  readonly #session: Searching;
  readonly #slicer: Slicer;
  readonly revision: number;
  #told = Infinity; // gap
  #isProvedAside = false; // its last stage is gone through elsewhere, and not at its end
  done = false;

  /** The session's bound has just been started. */
  constructor(session: Searching, clock: Clock, revision: number) {
    this.#session = session;
    this.#slicer = new Slicer(clock, first);
    this.revision = revision;
  }

  /** Hands the last stage on, where there is one, with what answers to each thing proved of it; returns what ends that. */
  handOn(prove: (pairs: Float64Array, tell: (proved: Proved) => Answer[]) => () => void): () => void {
    const pairs = this.#session.takePairs();
    if (pairs.length === 0) return () => {};
    this.#isProvedAside = true;
    return prove(pairs, ({ goal, done }) => {
      this.#isProvedAside = !done;
      this.#session.provedByPairs(goal);
      return this.#answers(this.#session.advanceBound(0));
    });
  }

  step(): Answer[] {
    return this.#answers(this.#slicer.run((steps) => this.#session.advanceBound(steps)));
  }

  stop(): Answer[] {
    return [];
  }

  /** Says nothing where nothing can be proved. */
  #answers(progress: OrError<BoundProgress>): Answer[] {
    if (typeof progress === 'string') throw new Error(progress);
    const { goal, gap } = progress;
    this.done = progress.done;
    const done = progress.done && !this.#isProvedAside;
    if (gap === null || !(done || gap < this.#told - clearly)) return [];
    this.#told = gap;
    return [
      noTransfer({ type: 'bounded', revision: this.revision, bound: goal, gap: Math.max(0, gap), done }),
    ];
  }
}

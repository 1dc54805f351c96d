/** A provable bound on the goal of the search before it: tells each time the gap has become clearly smaller. */
import type { Searching } from './hung-session.ts';
import { Slicer, type Clock } from './pacing.ts';
import { noTransfer, type Answer, type Task } from './task.ts';

const clearly = 0.005; // of the goal
const first = 20; // steps of the first slice

export class BoundTask implements Task {
  readonly #session: Searching;
  readonly #slicer: Slicer;
  readonly revision: number;
  #told = Infinity; // gap
  done = false;

  /** The session's bound has just been started. */
  constructor(session: Searching, clock: Clock, revision: number) {
    this.#session = session;
    this.#slicer = new Slicer(clock, first);
    this.revision = revision;
  }

  /** Says nothing where nothing can be proved. */
  step(): Answer[] {
    const progress = this.#slicer.run((steps) => this.#session.advanceBound(steps));
    if (typeof progress === 'string') throw new Error(progress);
    const { done, goal, gap } = progress;
    this.done = done;
    if (gap === null || !(done || gap < this.#told - clearly)) return [];
    this.#told = gap;
    return [
      noTransfer({ type: 'bounded', revision: this.revision, bound: goal, gap: Math.max(0, gap), done }),
    ];
  }

  stop(): Answer[] {
    return [];
  }
}

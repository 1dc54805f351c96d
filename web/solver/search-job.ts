/**
 * One search in slices. The first answer comes after some milliseconds, then every better one of the same frame, then
 * one a frame at most; the search settles when it has tried long in vain.
 */
import { metUpTo } from './core-intentions.ts';
import type { Progress } from './core.ts';
import type { Searching } from './hung-session.ts';
import { pace, Slicer, type Clock } from './pacing.ts';

export type Report = 'nothing' | 'improved' | 'settled';

export class SearchJob {
  readonly #session: Searching;
  readonly #clock: Clock;
  readonly #slicer: Slicer;
  readonly #begun: number;
  readonly #hasGoals: boolean;
  readonly #settling: Slicer;
  #answeredAt = -Infinity;
  #answeredFoundAt = -1; // foundAt of the layout that was answered last
  #improvedAt: number;
  #isOver = false; // nothing better has been found for long
  #settled = 0; // evaluations for the goals since
  #progress: Progress = { evaluations: 0, foundAt: 0, violation: 0, goal: 0, proved: false };

  /** The session's search has just been started. */
  constructor(session: Searching, clock: Clock, hasGoals: boolean) {
    this.#session = session;
    this.#hasGoals = hasGoals;
    this.#settling = new Slicer(clock, pace.probe);
    this.#clock = clock;
    this.#slicer = new Slicer(clock, pace.probe);
    this.#begun = this.#improvedAt = clock();
  }

  get progress(): Progress {
    return this.#progress;
  }

  /** Time spent searching, ms. */
  get milliseconds(): number {
    return this.#slicer.milliseconds + this.#settling.milliseconds;
  }

  /** One slice; says what is to be told. The caller tells it at once: the next step takes it as told. */
  step(): Report {
    if (this.#answeredFoundAt < 0) return this.#first();
    if (this.#isOver) return this.#settle();
    this.#advance();
    const now = this.#clock();
    const { evaluations, foundAt, proved } = this.#progress;
    const idle = proved || evaluations - foundAt >= pace.fruitlessEvaluations;
    this.#isOver = idle || now - this.#improvedAt >= pace.fruitlessMilliseconds;
    if (this.#isOver) return this.#mayServeGoals ? 'nothing' : 'settled';
    const isEarly = now - this.#begun < pace.answerGap;
    const isTooSoon = !isEarly && now - this.#answeredAt < pace.answerGap;
    if (foundAt === this.#answeredFoundAt || isTooSoon) return 'nothing';
    return this.#answer(now);
  }

  get #mayServeGoals(): boolean {
    return this.#hasGoals && this.#progress.violation > metUpTo;
  }

  /** What cannot be met has been searched for: now for the goals, as far as the bounds are hardly missed by more. */
  #settle(): Report {
    const spent = this.#settling.run((amount) => {
      this.#settled += amount;
      return this.#session.settle(amount);
    });
    const isDone = spent.proved || this.#settled >= pace.settlingEvaluations;
    return isDone || this.#settling.milliseconds >= pace.settlingMilliseconds ? 'settled' : 'nothing';
  }

  #first(): Report {
    do this.#advance(pace.firstMilliseconds / 2, pace.firstEvaluations - this.#progress.evaluations);
    while (
      !this.#progress.proved &&
      this.#progress.evaluations < pace.firstEvaluations &&
      this.#clock() - this.#begun < pace.firstMilliseconds
    );
    return this.#answer(this.#clock());
  }

  #answer(now: number): Report {
    this.#answeredAt = now;
    this.#answeredFoundAt = this.#progress.foundAt;
    return 'improved';
  }

  #advance(milliseconds?: number, left?: number): void {
    const { foundAt } = this.#progress;
    this.#progress = this.#slicer.run((amount) => this.#session.advance(amount), milliseconds, left);
    if (this.#progress.foundAt !== foundAt) this.#improvedAt = this.#clock();
  }
}

/**
 * One search in slices. The first answer comes after some milliseconds, then every better one of the same frame, then
 * one a frame at most; the search settles when it has tried long in vain.
 */
import type { Progress } from './core.ts';
import type { Searching } from './mounted-session.ts';
import { pace, Slicer, type Clock } from './pacing.ts';

export type Report = 'nothing' | 'improved' | 'settled';

export class SearchJob {
  readonly #session: Searching;
  readonly #clock: Clock;
  readonly #slicer: Slicer;
  readonly #begun: number;
  #answeredAt = -Infinity;
  #answeredFoundAt = -1; // foundAt of the layout that was answered last
  #improvedAt: number;
  #progress: Progress = { evaluations: 0, foundAt: 0, violation: 0, goal: 0, proved: false };

  /** The session's search has just been started. */
  constructor(session: Searching, clock: Clock) {
    this.#session = session;
    this.#clock = clock;
    this.#slicer = new Slicer(clock, pace.probe);
    this.#begun = this.#improvedAt = clock();
  }

  get progress(): Progress {
    return this.#progress;
  }

  /** Time spent searching, ms. */
  get milliseconds(): number {
    return this.#slicer.milliseconds;
  }

  /** One slice; says what is to be told. The caller tells it at once: the next step takes it as told. */
  step(): Report {
    if (this.#answeredFoundAt < 0) return this.#first();
    this.#advance();
    const now = this.#clock();
    const { evaluations, foundAt, proved } = this.#progress;
    const idle = proved || evaluations - foundAt >= pace.fruitlessEvaluations;
    if (idle || now - this.#improvedAt >= pace.fruitlessMilliseconds) return 'settled';
    const isEarly = now - this.#begun < pace.answerGap;
    const isTooSoon = !isEarly && now - this.#answeredAt < pace.answerGap;
    if (foundAt === this.#answeredFoundAt || isTooSoon) return 'nothing';
    return this.#answer(now);
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

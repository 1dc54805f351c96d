/**
 * One search in slices short enough that a new slider value never waits. The first answer comes after some
 * milliseconds, then every better one of the same frame, then one a frame at most; the search settles when it has
 * tried long in vain.
 */
import type { Progress, Session } from './core.ts';

/** Milliseconds on any steady clock. */
export type Clock = () => number;

export const pace = {
  firstEvaluations: 30_000, // before the first answer, unless they take longer than
  firstMilliseconds: 4,
  probe: 1_000, // evaluations of a slice whose speed is not known yet
  sliceMilliseconds: 3,
  answerGap: 16, // ms between answers, but for the first so many, in which each slice may answer
  fruitlessEvaluations: 2_000_000, // without improvement: settled
  fruitlessMilliseconds: 2_000,
} as const;

export type Report = 'nothing' | 'improved' | 'settled';

export class SearchJob {
  readonly #session: Session;
  readonly #clock: Clock;
  readonly #begun: number;
  #spent = 0; // ms inside the search
  #perEvaluation = 0; // ms, of the latest slice
  #answeredAt = -Infinity;
  #answeredFoundAt = -1; // foundAt of the layout that was answered last
  #improvedAt: number;
  #progress: Progress = { evaluations: 0, foundAt: 0, violation: 0, goal: 0 };

  /** The session's search has just been started. */
  constructor(session: Session, clock: Clock) {
    this.#session = session;
    this.#clock = clock;
    this.#begun = this.#improvedAt = clock();
  }

  get progress(): Progress {
    return this.#progress;
  }

  /** Time spent searching, ms. */
  get milliseconds(): number {
    return this.#spent;
  }

  /** One slice; says what is to be told. The caller tells it at once: the next step takes it as told. */
  step(): Report {
    if (this.#answeredFoundAt < 0) return this.#first();
    this.#advance(this.#sliceOf(pace.sliceMilliseconds));
    const now = this.#clock();
    const { evaluations, foundAt } = this.#progress;
    const idle = evaluations - foundAt >= pace.fruitlessEvaluations;
    if (idle || now - this.#improvedAt >= pace.fruitlessMilliseconds) return 'settled';
    const isEarly = now - this.#begun < pace.answerGap;
    const isTooSoon = !isEarly && now - this.#answeredAt < pace.answerGap;
    if (foundAt === this.#answeredFoundAt || isTooSoon) return 'nothing';
    return this.#answer(now);
  }

  #first(): Report {
    do {
      const left = pace.firstEvaluations - this.#progress.evaluations;
      const slice = this.#perEvaluation > 0 ? this.#sliceOf(pace.firstMilliseconds / 2) : pace.probe;
      this.#advance(Math.min(left, slice));
    } while (
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

  #advance(evaluations: number): void {
    const before = this.#progress;
    const start = this.#clock();
    this.#progress = this.#session.advance(evaluations);
    const now = this.#clock();
    this.#spent += now - start;
    // note: browsers step their clock by up to 0.1 ms.
    this.#perEvaluation = Math.max(now - start, 0.05) / evaluations;
    if (this.#progress.foundAt !== before.foundAt) this.#improvedAt = now;
  }

  #sliceOf(milliseconds: number): number {
    return Math.round(Math.min(200_000, Math.max(100, milliseconds / this.#perEvaluation)));
  }
}

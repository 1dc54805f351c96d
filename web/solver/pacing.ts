/** How long the solver works at a stretch: slices short enough that a new slider value never waits. */

/** Milliseconds on any steady clock. */
export type Clock = () => number;

export const pace = {
  firstEvaluations: 20_000, // before the first answer, unless they take longer than
  firstMilliseconds: 4,
  probe: 1_000, // evaluations of a slice whose speed is not known yet
  sliceMilliseconds: 2,
  asideMilliseconds: 1.5, // of what nobody waits for
  answerGap: 16, // ms between answers, but for the first so many, in which each slice may answer
  fruitlessEvaluations: 2_000_000, // without improvement: settled
  fruitlessMilliseconds: 2_000,
  settlingEvaluations: 100_000, // for the goals, where the bounds cannot be met
  settlingMilliseconds: 400,
} as const;

const least = 10; // units of work in a slice
const most = 200_000;
const growth = 4; // at most so many times the slice before

/** Does work in amounts that take about as long as wished, by the speed of the slice before. */
export class Slicer {
  readonly #clock: Clock;
  #amount: number; // of the latest slice, before it was cut to `left`
  #perUnit = 0; // ms, in the latest slice; 0 = there was none
  #spent = 0;

  /** `first`: units of work of a slice whose speed is not known yet. */
  constructor(clock: Clock, first: number) {
    this.#clock = clock;
    this.#amount = first;
  }

  /** Time spent in slices so far, ms. */
  get milliseconds(): number {
    return this.#spent;
  }

  /** One slice, of at most `left` units. */
  run<T>(
    work: (amount: number) => T,
    milliseconds: number = pace.sliceMilliseconds,
    left: number = Infinity,
  ): T {
    if (this.#perUnit > 0) {
      const wished = Math.max(least, milliseconds / this.#perUnit);
      this.#amount = Math.round(Math.min(most, growth * this.#amount, wished));
    }
    const amount = Math.min(this.#amount, left);
    const begin = this.#clock();
    const result = work(amount);
    const spent = this.#clock() - begin;
    this.#spent += spent;
    // note: browsers step their clock by up to 0.1 ms.
    this.#perUnit = Math.max(spent, 0.05) / amount;
    return result;
  }
}

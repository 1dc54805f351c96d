/** Something that runs in slices until it is done, and what it has to say after each. */
import type { FromWorker } from './protocol.ts';

export interface Answer {
  readonly message: FromWorker;
  readonly transfer: Transferable[];
}

export interface Task {
  readonly revision: number;
  readonly done: boolean;
  /** One slice. Throws one readable line. */
  step(): Answer[];
  /** What is still to be said when it is stopped. */
  stop(): Answer[];
}

export const noTransfer = (message: FromWorker): Answer => ({ message, transfer: [] });

/** Calls with amounts of work that take about `milliseconds` each. */
export class Slicer {
  #amount: number;
  constructor(
    readonly clock: () => number,
    readonly milliseconds: number,
    first: number,
  ) {
    this.#amount = first;
  }

  run<T>(work: (amount: number) => T): T {
    const begin = this.clock();
    const result = work(this.#amount);
    // note: browsers step their clock by up to 0.1 ms.
    const spent = Math.max(this.clock() - begin, 0.05);
    const next = (this.#amount * this.milliseconds) / spent;
    this.#amount = Math.round(Math.min(200_000, 4 * this.#amount, Math.max(10, next)));
    return result;
  }
}

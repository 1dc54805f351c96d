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

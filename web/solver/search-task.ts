/** A search whose answers carry everything that is shown. */
import type { SceneInfo } from '../document/types.ts';
import { shownOf } from './core-intentions.ts';
import type { Searching } from './hung-session.ts';
import type { ToWorker } from './protocol.ts';
import type { Clock } from './pacing.ts';
import { SearchJob } from './search-job.ts';
import type { Answer, Task } from './task.ts';

export class SearchTask implements Task {
  readonly #session: Searching;
  readonly #clock: Clock;
  readonly #request: Extract<ToWorker, { readonly type: 'solve' }>;
  readonly #leaves: SceneInfo['surfaces'];
  readonly #job: SearchJob;
  done = false;

  /** The session's search has just been started. */
  constructor(
    session: Searching,
    clock: Clock,
    request: Extract<ToWorker, { readonly type: 'solve' }>,
    leaves: SceneInfo['surfaces'],
  ) {
    this.#session = session;
    this.#clock = clock;
    this.#request = request;
    this.#leaves = leaves;
    this.#job = new SearchJob(session, clock, request.intentions.goals.length > 0);
  }

  get revision(): number {
    return this.#request.revision;
  }

  step(): Answer[] {
    const report = this.#job.step();
    this.done = report === 'settled';
    return report === 'nothing' ? [] : [this.#answer(report)];
  }

  stop(): Answer[] {
    return [this.#answer('settled')];
  }

  #answer(type: 'improved' | 'settled'): Answer {
    const core = this.#session.incumbent();
    if (typeof core === 'string') throw new Error(core);
    const { progress, milliseconds } = this.#job;
    const shown = shownOf(core, progress.goal, this.#leaves);
    const { revision, askedAt } = this.#request;
    const evaluations = Math.max(progress.evaluations, this.done ? 1 : 0); // the only layout there is was looked at, too
    const cost = { evaluations, milliseconds, askedAt, postedAt: this.#clock() };
    return { message: { type, revision, shown, ...cost }, transfer: [shown.illuminance.buffer] };
  }
}

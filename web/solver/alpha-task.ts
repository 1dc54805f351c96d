/** The alpha-search (paper, section 4): tells each iteration when it ends, the verdict when all have. */
import { shownOf } from './core-intentions.ts';
import type { AlphaProgress } from './core.ts';
import type { Searching } from './hung-session.ts';
import type { SceneInfo } from '../document/types.ts';
import { pace, Slicer, type Clock } from './pacing.ts';
import { noTransfer, type Answer, type Task } from './task.ts';

export class AlphaTask implements Task {
  readonly #session: Searching;
  readonly #slicer: Slicer;
  readonly #leaves: SceneInfo['surfaces'];
  readonly revision: number;
  #told = 0; // iterations
  done = false;

  /** The session's alpha-search has just been started. */
  constructor(session: Searching, clock: Clock, revision: number, leaves: SceneInfo['surfaces']) {
    this.#session = session;
    this.#slicer = new Slicer(clock, pace.probe);
    this.#leaves = leaves;
    this.revision = revision;
  }

  step(): Answer[] {
    const progress = this.#slicer.run((evaluations) => this.#session.advanceAlpha(evaluations, this.#told));
    if (typeof progress === 'string') throw new Error(progress);
    const answers = progress.steps.map(({ low, high, phi, ...rest }) => {
      const step = { ...rest, iteration: ++this.#told, interval: [low, high] as const, goal: phi };
      return noTransfer({ type: 'alphaStep', revision: this.revision, step });
    });
    this.done = progress.done;
    return progress.done ? [...answers, this.#conclusion(progress)] : answers;
  }

  stop(): Answer[] {
    return [];
  }

  #conclusion({ alpha, verdict, feasibleBound, layout }: AlphaProgress): Answer {
    const core = layout && this.#session.show(layout.sites, layout.flux, layout.dimming);
    if (typeof core === 'string') throw new Error(core);
    const shown = core && shownOf(core, 0, this.#leaves);
    return {
      message: { type: 'alphaDone', revision: this.revision, alpha, verdict, shown, feasibleBound },
      transfer: shown ? [shown.illuminance.buffer] : [],
    };
  }
}

/**
 * Other wishes, each tried shortly beside what runs: one counted further, or arranged otherwise. They are tried in turn,
 * from the layout of the one before where their numbers of luminaires are near.
 */
import { isOfPatches, metWithin } from '../document/intentions.ts';
import type { Intentions, SceneInfo } from '../document/types.ts';
import { coreIntentions, layoutOf, metUpTo } from './core-intentions.ts';
import type { Searching } from './hung-session.ts';
import type { CoreTrial } from './core.ts';
import { pace, Slicer, type Clock } from './pacing.ts';
import type { Outcome, ToWorker } from './protocol.ts';
import { noTransfer, type Answer } from './task.ts';

type Request = Extract<ToWorker, { readonly type: 'compare' }>;

export class CompareTask {
  readonly request: Request;
  readonly #leaves: SceneInfo['surfaces'];
  readonly #clock: Clock;
  #next = 0;
  #from: Uint32Array;
  /** The trial that has begun, and who makes it. */
  #begun: { readonly by: Searching; readonly slicer: Slicer } | null = null;

  constructor(request: Request, leaves: SceneInfo['surfaces'], clock: Clock) {
    this.request = request;
    this.#leaves = leaves;
    this.#clock = clock;
    this.#from = Uint32Array.from(request.start?.sites ?? []);
  }

  get revision(): number {
    return this.request.revision;
  }

  get done(): boolean {
    return this.#next >= this.request.variants.length;
  }

  /** One slice. `session`: one that has all that may be tried. */
  stepIn(session: Searching): Answer[] {
    const variant = this.#next;
    const asked = this.request.variants[variant];
    if (!asked) return [];
    const outcome = this.#begin(session, asked) ? this.#advance(session, asked) : null;
    if (outcome === 'unfinished') return [];
    this.#next += 1;
    return [noTransfer({ type: 'compared', revision: this.revision, variant, outcome, done: this.done })];
  }

  /** False where the rules leave no layout at all. */
  #begin(session: Searching, asked: Intentions): boolean {
    if (this.#begun?.by === session) return true;
    const { seed, evaluations } = this.request;
    const wish = coreIntentions(asked, this.#leaves);
    if (session.startAside(wish, seed, this.#from, evaluations)) return false;
    this.#begun = { by: session, slicer: new Slicer(this.#clock, pace.probe) };
    return true;
  }

  #advance(session: Searching, asked: Intentions): Outcome | 'unfinished' {
    // note: what takes no evaluations says nothing of how long they take.
    if (!session.enterAside()) return 'unfinished';
    const found = this.#begun!.slicer.run(
      (evaluations) => session.advanceAside(evaluations),
      pace.asideMilliseconds,
    );
    if (found === null) return 'unfinished';
    this.#begun = null;
    // What was asked of the session in between has ended it: it is tried again.
    return typeof found === 'string' ? 'unfinished' : this.#outcome(found, asked);
  }

  #outcome(found: CoreTrial, asked: Intentions): Outcome {
    this.#from = found.layout.sites;
    const layout = layoutOf(found.layout);
    const lumens = layout.flux.reduce((sum, flux) => sum + flux, 0) * layout.dimming;
    const closely = asked.constraints.some(isOfPatches) ? metUpTo : metWithin;
    const { violation, limit } = found;
    return { layout, lumens, met: violation <= closely, violation, ...(limit !== null && { limit }) };
  }
}

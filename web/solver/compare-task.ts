/**
 * Other wishes, each tried shortly beside what runs: one counted further, or arranged otherwise. A step tries one of
 * them, from the layout of the one before where their numbers of luminaires are near.
 */
import { isOfPatches, metWithin } from '../document/intentions.ts';
import type { Intentions, SceneInfo } from '../document/types.ts';
import { coreIntentions, layoutOf, metUpTo } from './core-intentions.ts';
import type { Searching } from './hung-session.ts';
import type { Outcome, ToWorker } from './protocol.ts';
import { noTransfer, type Answer } from './task.ts';

type Request = Extract<ToWorker, { readonly type: 'compare' }>;

export class CompareTask {
  readonly request: Request;
  readonly #leaves: SceneInfo['surfaces'];
  #next = 0;
  #from: Uint32Array;

  constructor(request: Request, leaves: SceneInfo['surfaces']) {
    this.request = request;
    this.#leaves = leaves;
    this.#from = Uint32Array.from(request.start?.sites ?? []);
  }

  get revision(): number {
    return this.request.revision;
  }

  get done(): boolean {
    return this.#next >= this.request.variants.length;
  }

  /** `session`: one that has all that may be tried. */
  stepIn(session: Searching): Answer[] {
    const variant = this.#next++;
    const asked = this.request.variants[variant];
    if (!asked) return [];
    const outcome = this.#outcome(session, asked);
    return [noTransfer({ type: 'compared', revision: this.revision, variant, outcome, done: this.done })];
  }

  /** null where the rules leave no layout at all. */
  #outcome(session: Searching, asked: Intentions): Outcome | null {
    const { seed, evaluations } = this.request;
    const wish = coreIntentions(asked, this.#leaves);
    const found = session.tryAside(wish, seed, this.#from, evaluations);
    if (typeof found === 'string') return null;
    this.#from = found.layout.sites;
    const layout = layoutOf(found.layout);
    const lumens = layout.flux.reduce((sum, flux) => sum + flux, 0) * layout.dimming;
    const closely = asked.constraints.some(isOfPatches) ? metUpTo : metWithin;
    const { violation, limit } = found;
    return { layout, lumens, met: violation <= closely, violation, ...(limit !== null && { limit }) };
  }
}

/**
 * Other wishes, each tried shortly beside what runs: one counted further, or arranged otherwise. A step tries one of
 * them, from the layout of the one before where their numbers of luminaires are near.
 */
import { isOfPatches, metWithin } from '../document/intentions.ts';
import type { Intentions, SceneInfo } from '../document/types.ts';
import { coreIntentions, layoutOf, metUpTo } from './core-intentions.ts';
import type { Searching } from './hung-session.ts';
import type { Outcome, ToWorker } from './protocol.ts';
import { noTransfer, type Answer, type Task } from './task.ts';

type Request = Extract<ToWorker, { readonly type: 'compare' }>;

export class CompareTask implements Task {
  readonly #session: () => Searching;
  readonly #request: Request;
  readonly #leaves: SceneInfo['surfaces'];
  #next = 0;
  #from: Uint32Array;

  /** `session`: the one that the search before it was in. */
  constructor(session: () => Searching, request: Request, leaves: SceneInfo['surfaces']) {
    this.#session = session;
    this.#request = request;
    this.#leaves = leaves;
    this.#from = Uint32Array.from(request.start?.sites ?? []);
  }

  get revision(): number {
    return this.#request.revision;
  }

  get done(): boolean {
    return this.#next >= this.#request.variants.length;
  }

  step(): Answer[] {
    const variant = this.#next++;
    const asked = this.#request.variants[variant];
    if (!asked) return [];
    const outcome = this.#outcome(asked);
    return [noTransfer({ type: 'compared', revision: this.revision, variant, outcome, done: this.done })];
  }

  stop(): Answer[] {
    return [];
  }

  /** null where the rules leave no layout at all. */
  #outcome(asked: Intentions): Outcome | null {
    const { seed, evaluations } = this.#request;
    const wish = coreIntentions(asked, this.#leaves);
    const found = this.#session().tryAside(wish, seed, this.#from, evaluations);
    if (typeof found === 'string') return null;
    this.#from = found.layout.sites;
    const layout = layoutOf(found.layout);
    const lumens = layout.flux.reduce((sum, flux) => sum + flux, 0) * layout.dimming;
    const closely = asked.constraints.some(isOfPatches) ? metUpTo : metWithin;
    const { violation, limit } = found;
    return { layout, lumens, met: violation <= closely, violation, ...(limit !== null && { limit }) };
  }
}

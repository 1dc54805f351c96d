/**
 * A session whose luminaires are squares in a room of another paint. Beneath, the core searches a scene that has the light
 * of some sites in the painted room; above, layouts are of the sites of the room.
 */
import type { Layout } from '../document/types.ts';
import {
  codes,
  type CoreIntentions,
  type CoreLayout,
  type CoreShown,
  type OrError,
  type Session,
} from './core.ts';
import type { HungSession, LayoutArguments } from './mounted-session.ts';

export class PaintedSession implements HungSession {
  readonly #session: Session;
  readonly #sites: readonly number[]; // of the room, in the order of the scene beneath
  readonly #bySite: ReadonlyMap<number, number>;
  readonly #isShownOnly: boolean;

  /** `session` has the scene of these sites. `isShownOnly`: of one layout, and rules of a search mean nothing to it. */
  constructor(session: Session, sites: readonly number[], isShownOnly: boolean) {
    this.#session = session;
    this.#sites = sites;
    this.#isShownOnly = isShownOnly;
    this.#bySite = new Map(sites.map((site, index) => [site, index]));
  }

  has({ sites }: Layout): boolean {
    return sites.every((site) => this.#bySite.has(site));
  }

  take({ sites, flux, dimming }: Layout): LayoutArguments {
    const held = [...sites.keys()].filter((i) => this.#bySite.has(sites[i]!));
    return [
      Uint32Array.from(held, (i) => this.#bySite.get(sites[i]!)!),
      Float64Array.from(held, (i) => flux[i] ?? 0),
      dimming,
    ];
  }

  ask(): void {}

  setIntentions = (asked: CoreIntentions) => this.#session.setIntentions(this.#beneath(asked));
  start = (seed: number) => this.#session.start(seed);
  startFrom = (seed: number, ...layout: LayoutArguments) => this.#session.startFrom(seed, ...layout);
  startNear = (seed: number, sites: Uint32Array, flux: Float64Array, dimming: number, moved: Uint32Array) =>
    this.#session.startNear(seed, sites, flux, dimming, moved);
  advance = (evaluations: number) => this.#session.advance(evaluations);
  settle = (evaluations: number) => this.#session.settle(evaluations);
  /** `sites`: of the room. */
  tryAside(asked: CoreIntentions, seed: number, sites: Uint32Array, evaluations: number) {
    const found = this.#session.tryAside(this.#beneath(asked), seed, this.#indices(sites), evaluations);
    return typeof found === 'string' ? found : { ...found, layout: this.#above(found.layout) };
  }
  incumbent = () => this.#shown(this.#session.incumbent());
  show = (...layout: LayoutArguments) => this.#shown(this.#session.show(...layout));
  check = (...layout: LayoutArguments) => this.#session.check(...layout);
  startAlpha = (seed: number, held: Uint32Array) => this.#session.startAlpha(seed, held);
  advanceAlpha = (evaluations: number, from: number) => this.#session.advanceAlpha(evaluations, from);
  startBound = () => this.#session.startBound();
  advanceBound = (steps: number) => this.#session.advanceBound(steps);

  /** Frees the session beneath. */
  delete(): void {
    this.#session.delete();
  }

  #beneath(asked: CoreIntentions): CoreIntentions {
    const { luminaires } = asked;
    const none = new Uint32Array();
    const anyhow = { count: this.#sites.length, countHigh: 0, pinned: none, excluded: none, minDistance: 0 };
    const searched = {
      pinned: this.#indices(luminaires.pinned),
      excluded: this.#indices(luminaires.excluded),
    };
    const free = { rule: codes.rule.free, axis: codes.axis.found };
    return {
      ...asked,
      luminaires: { ...luminaires, ...(this.#isShownOnly ? { ...anyhow, ...free } : searched) },
    };
  }

  #indices(sites: Uint32Array): Uint32Array {
    return Uint32Array.from([...sites].flatMap((site) => this.#bySite.get(site) ?? []));
  }

  #above(layout: CoreLayout): CoreLayout {
    return { ...layout, sites: layout.sites.map((index) => this.#sites[index]!) };
  }

  #shown(shown: OrError<CoreShown>): OrError<CoreShown> {
    return typeof shown === 'string' ? shown : { ...shown, layout: this.#above(shown.layout) };
  }
}

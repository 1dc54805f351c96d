/**
 * A session whose luminaires are squares in a room of another paint. Beneath, the core searches a scene that has the light
 * of some sites in the painted room; above, layouts are of the sites of the room.
 */
import type { Layout } from '../document/types.ts';
import type { CoreIntentions, CoreLayout, Session } from './core.ts';
import { HungSession, ruledByNothing, type LayoutArguments } from './hung-session.ts';

export class PaintedSession extends HungSession {
  readonly #sites: readonly number[]; // of the room, in the order of the scene beneath
  readonly #bySite: ReadonlyMap<number, number>;
  readonly #isShownOnly: boolean;

  /** `session` has the scene of these sites. `isShownOnly`: of one layout, and rules of a search mean nothing to it. */
  constructor(session: Session, sites: readonly number[], isShownOnly: boolean) {
    super(session);
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

  protected beneath(asked: CoreIntentions): CoreIntentions {
    const { luminaires } = asked;
    if (this.#isShownOnly) return { ...asked, luminaires: ruledByNothing(luminaires, this.#sites.length) };
    const searched = {
      pinned: this.#indices(luminaires.pinned),
      excluded: this.#indices(luminaires.excluded),
    };
    return { ...asked, luminaires: { ...luminaires, ...searched } };
  }

  #indices(sites: Uint32Array): Uint32Array {
    return Uint32Array.from([...sites].flatMap((site) => this.#bySite.get(site) ?? []));
  }

  protected above(layout: CoreLayout): CoreLayout {
    return { ...layout, sites: layout.sites.map((index) => this.#sites[index]!) };
  }
}

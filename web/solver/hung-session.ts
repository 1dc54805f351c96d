/** A session of another scene beneath: its layouts are taken and told in sites of the room. */
import type { Layout, Luminaires } from '../document/types.ts';
import {
  codes,
  type CoreIntentions,
  type CoreLayout,
  type CoreShown,
  type OrError,
  type Session,
} from './core.ts';

/** What asks and answers of a session, for those whom it does not concern what is beneath. */
export type Searching = Pick<
  Session,
  | 'setIntentions'
  | 'prepareSearch'
  | 'start'
  | 'startFrom'
  | 'startNear'
  | 'advance'
  | 'settle'
  | 'startAside'
  | 'enterAside'
  | 'advanceAside'
  | 'incumbent'
  | 'show'
  | 'paintGains'
  | 'check'
  | 'startAlpha'
  | 'advanceAlpha'
  | 'startBound'
  | 'advanceBound'
  | 'takePairs'
  | 'provedByPairs'
>;

/** The arguments by which a session takes a layout. */
export type LayoutArguments = [sites: Uint32Array, flux: Float64Array, dimming: number];

type CoreLuminaires = CoreIntentions['luminaires'];

/** Of a scene that has the `places` of one layout alone: rules of where others might hang, and how many, say nothing of it. */
export function ruledByNothing(luminaires: CoreLuminaires, places: number): CoreLuminaires {
  const none = new Uint32Array();
  const free = { rule: codes.rule.free, axis: codes.axis.found };
  const anyhow = { count: places, countHigh: 0, pinned: none, excluded: none, minDistance: 0 };
  return { ...luminaires, ...free, ...anyhow, types: [], ofType: none };
}

/**
 * Asks a session; returns what it refuses. Where the rules leave no layout it has the observers, areas and planes of what
 * was asked all the same, so that what other rules leave can be tried there.
 */
export function askAnyhow(session: Pick<Session, 'setIntentions'>, asked: CoreIntentions): string {
  const refused = session.setIntentions(asked);
  if (refused) session.setIntentions({ ...asked, luminaires: ruledByNothing(asked.luminaires, 1) });
  return refused;
}

/** Hands on what is asked, translated by those who know what the sites beneath are. */
export abstract class HungSession implements Searching {
  protected readonly session: Session;

  constructor(session: Session) {
    this.session = session;
  }

  /** Whether every luminaire of a layout may hang here as it does. */
  abstract has(layout: Layout): boolean;
  /** A layout as the session takes it; what may not hang here is left out. */
  abstract take(layout: Layout): LayoutArguments;
  /** What is asked of the luminaires from now on; `hasAll`: it has everything that a search may try. */
  abstract ask(luminaires: Luminaires, hasAll: boolean): void;

  protected abstract beneath(asked: CoreIntentions): CoreIntentions;
  protected abstract above(layout: CoreLayout): CoreLayout;

  setIntentions = (asked: CoreIntentions) => askAnyhow(this.session, this.beneath(asked));
  prepareSearch = (rows: number) => this.session.prepareSearch(rows);
  start = (seed: number) => this.session.start(seed);
  startFrom = (seed: number, ...layout: LayoutArguments) => this.session.startFrom(seed, ...layout);
  startNear = (seed: number, sites: Uint32Array, flux: Float64Array, dimming: number, moved: Uint32Array) =>
    this.session.startNear(seed, sites, flux, dimming, moved);
  advance = (evaluations: number) => this.session.advance(evaluations);
  settle = (evaluations: number) => this.session.settle(evaluations);
  /** `sites`: of the room. */
  startAside(asked: CoreIntentions, seed: number, sites: Uint32Array, evaluations: number) {
    const [start] = this.take({ sites: [...sites], flux: [], dimming: 1 });
    return this.session.startAside(this.beneath(asked), seed, start, evaluations);
  }
  enterAside = () => this.session.enterAside();
  advanceAside(evaluations: number) {
    const found = this.session.advanceAside(evaluations);
    return typeof found === 'string' || !found ? found : { ...found, layout: this.above(found.layout) };
  }
  incumbent = () => this.#shown(this.session.incumbent());
  show = (...layout: LayoutArguments) => this.#shown(this.session.show(...layout));
  /** `room`: the one that the scene beneath is of. */
  paintGains = (room: Session, asked: CoreIntentions, paint: Float64Array, ...layout: LayoutArguments) =>
    this.session.paintGains(room, asked, paint, ...layout);
  check = (...layout: LayoutArguments) => this.session.check(...layout);
  startAlpha = (seed: number, held: Uint32Array) => this.session.startAlpha(seed, held);
  advanceAlpha = (evaluations: number, from: number) => this.session.advanceAlpha(evaluations, from);
  startBound = () => this.session.startBound();
  advanceBound = (steps: number) => this.session.advanceBound(steps);
  takePairs = () => this.session.takePairs();
  provedByPairs = (goal: number) => this.session.provedByPairs(goal);

  /** Frees the session beneath. */
  delete(): void {
    this.session.delete();
  }

  #shown(shown: OrError<CoreShown>): OrError<CoreShown> {
    return typeof shown === 'string' ? shown : { ...shown, layout: this.above(shown.layout) };
  }
}

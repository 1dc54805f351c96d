/**
 * A session whose luminaires are of photometric types. Beneath, the core searches a scene whose sites are candidates (a
 * site, a type on it, its turn and aim); above, layouts are of sites and mountings again.
 */
import { candidateOf, type Candidate } from '../document/candidates.ts';
import type { Layout, LuminaireType, Mounting, SceneInfo } from '../document/types.ts';
import type {
  Candidates as CoreCandidates,
  CoreIntentions,
  CoreLayout,
  CoreShown,
  OrError,
  Session,
} from './core.ts';

/** What asks and answers of a session, for those whom it does not concern what is beneath. */
export type Searching = Pick<
  Session,
  | 'setIntentions'
  | 'start'
  | 'startFrom'
  | 'advance'
  | 'settle'
  | 'tryAside'
  | 'incumbent'
  | 'show'
  | 'check'
  | 'startAlpha'
  | 'advanceAlpha'
  | 'startBound'
  | 'advanceBound'
>;

const apart = 1e-3; // m: two luminaires do not hang on one site

const keyOf = (site: number, { type, turn, aim }: Mounting) =>
  `${site} ${type} ${turn} ${aim?.join(' ') ?? ''}`;

/** lm that stand for one unit of light beneath: of the strongest type. */
const strongest = (candidates: readonly Candidate[]): number =>
  Math.max(...candidates.map(({ type }) => type.flux));

/** Begins the light of candidates. Throws one readable line. `fileOf` has the file of every type. */
export function beginCandidates(
  scene: CoreCandidates,
  room: Session,
  candidates: readonly Candidate[],
  fileOf: (type: LuminaireType) => Uint8Array,
): void {
  const types = [...new Set(candidates.map(({ type }) => type))];
  const numbers = candidates.flatMap(({ site, type, mounting, aim }) => [
    site,
    types.indexOf(type),
    mounting.turn,
    ...(aim ?? [Number.NaN, 0, 0]),
  ]);
  const flux = Float64Array.from(types, (type) => type.flux / strongest(candidates));
  const error = scene.begin(room, types.map(fileOf), flux, Float64Array.from(numbers));
  if (error) throw new Error(error);
}

/** The arguments by which a session takes a layout. */
export type LayoutArguments = [sites: Uint32Array, flux: Float64Array, dimming: number];

export class MountedSession implements Searching {
  readonly #session: Session;
  readonly #candidates: readonly Candidate[];
  readonly #bySite = new Map<number, number[]>(); // candidates of each site
  readonly #byKey = new Map<string, number>();
  readonly #flux: number; // lm that stand for 1 in the core: of the strongest type
  #held: readonly number[] = []; // candidates of the layout that a search starts from

  /** `session` has the scene of these candidates,. */
  constructor(session: Session, candidates: readonly Candidate[]) {
    this.#session = session;
    this.#candidates = candidates;
    this.#flux = strongest(candidates);
    candidates.forEach(({ site, mounting }, index) => {
      this.#bySite.set(site, [...(this.#bySite.get(site) ?? []), index]);
      this.#byKey.set(keyOf(site, mounting), index);
    });
  }

  /** Whether every luminaire of a layout hangs as one of the candidates does. */
  has({ sites, mountings }: Layout): boolean {
    return sites.every((site, i) => mountings?.[i] && this.#byKey.has(keyOf(site, mountings[i])));
  }

  /** A layout in candidates: each luminaire as it hangs, or as one may hang there; else it is left out. */
  take(layout: Layout): LayoutArguments {
    this.#held = layout.sites.flatMap((site, i) => this.#candidateAt(site, layout.mountings?.[i]) ?? []);
    return [
      Uint32Array.from(this.#held),
      new Float64Array(this.#held.length).fill(this.#flux),
      layout.dimming,
    ];
  }

  setIntentions = (asked: CoreIntentions) => this.#session.setIntentions(this.#beneath(asked));

  start = (seed: number) => this.#session.start(seed);
  startFrom = (seed: number, ...layout: LayoutArguments) => this.#session.startFrom(seed, ...layout);
  advance = (evaluations: number) => this.#session.advance(evaluations);
  settle = (evaluations: number) => this.#session.settle(evaluations);
  /** `sites`: of the room. */
  tryAside(asked: CoreIntentions, seed: number, sites: Uint32Array, evaluations: number) {
    const [start] = this.take({ sites: [...sites], flux: [], dimming: 1 });
    const found = this.#session.tryAside(this.#beneath(asked), seed, start, evaluations);
    return typeof found === 'string' ? found : { ...found, layout: this.#mounted(found.layout) };
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

  /** Pinned are the luminaires of the layout that was taken, at their sites. */
  #beneath(asked: CoreIntentions): CoreIntentions {
    const { luminaires } = asked;
    const heldAt = (site: number) => this.#held.find((index) => this.#candidates[index]?.site === site);
    const pinned = [...luminaires.pinned].flatMap(
      (site) => heldAt(site) ?? this.#bySite.get(site)?.[0] ?? [],
    );
    const excluded = [...luminaires.excluded].flatMap((site) => this.#bySite.get(site) ?? []);
    return {
      ...asked,
      luminaires: {
        ...luminaires,
        flux: Float64Array.of(this.#flux),
        pinned: Uint32Array.from(pinned),
        excluded: Uint32Array.from(excluded),
        minDistance: Math.max(apart, luminaires.minDistance),
      },
    };
  }

  /** From candidates back to sites and mountings. */
  #mounted({ sites, dimming, ties }: CoreLayout): CoreLayout {
    const hung = Array.from(sites, (index) => this.#candidates[index]!);
    return {
      sites: Uint32Array.from(hung, ({ site }) => site),
      flux: Float64Array.from(hung, ({ type }) => type.flux),
      dimming,
      ties,
      mountings: hung.map(({ mounting }) => mounting),
    };
  }

  #shown(shown: OrError<CoreShown>): OrError<CoreShown> {
    return typeof shown === 'string' ? shown : { ...shown, layout: this.#mounted(shown.layout) };
  }

  #candidateAt(site: number, mounting: Mounting | undefined): number | undefined {
    const there = this.#bySite.get(site) ?? [];
    return there[
      chosenAt(
        there.map((index) => this.#candidates[index]!),
        mounting,
      )
    ];
  }
}

/**
 * Which of the candidates of one site a luminaire takes: the one that it is, else the first of its type, else the first of
 * the latest type. -1 where there are none.
 */
export function chosenAt(there: readonly Candidate[], mounting: Mounting | undefined): number {
  const key = mounting && keyOf(0, mounting);
  const same = there.findIndex((candidate) => keyOf(0, candidate.mounting) === key);
  if (same >= 0) return same;
  const ofType = there.findIndex(({ type }) => type.id === mounting?.type);
  const latest = there.at(-1)?.type.id;
  return ofType >= 0 ? ofType : there.findIndex(({ type }) => type.id === latest);
}

/** The candidates that a layout is made of, as `candidatesOf` would make them. Those of unknown types are left out. */
export function candidatesIn(
  { sites, mountings = [] }: Layout,
  types: readonly LuminaireType[],
  scene: SceneInfo,
): Candidate[] {
  return sites.flatMap((site, i) => {
    const mounting = mountings[i];
    const type = types.find(({ id }) => id === mounting?.type);
    return type && mounting ? candidateOf(scene.sites, site, type, mounting) : [];
  });
}

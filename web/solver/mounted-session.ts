/**
 * A session whose luminaires are of photometric types. Beneath, the core searches a scene whose sites are candidates (a
 * site, a type on it, its turn and aim); above, layouts are of sites and mountings again.
 */
import type { Candidate } from '../document/candidates.ts';
import { usualEfficacy } from '../document/photometry.ts';
import type { Layout, Luminaires, LuminaireType, Mounting } from '../document/types.ts';
import {
  anyType,
  type Candidates as CoreCandidates,
  type CoreIntentions,
  type CoreLayout,
  type Session,
} from './core.ts';
import { HungSession, ruledByNothing, type LayoutArguments } from './hung-session.ts';

const apart = 1e-3; // m: two luminaires do not hang on one site

const keyOf = (site: number, { type, turn, aim }: Mounting) =>
  `${site} ${type} ${turn} ${aim?.join(' ') ?? ''}`;

/** The types of candidates, in the order of their numbers beneath. */
const typesOf = (candidates: readonly Candidate[]): LuminaireType[] => [
  ...new Set(candidates.map(({ type }) => type)),
];

/** Begins the light of candidates. Throws one readable line. `fileOf` has the file of every type, `paint` is of the room. */
export function beginCandidates(
  scene: CoreCandidates,
  room: Session,
  candidates: readonly Candidate[],
  fileOf: (type: LuminaireType) => Uint8Array,
  paint: Float64Array = new Float64Array(),
): void {
  const types = typesOf(candidates);
  const ways = new Map<string, number>();
  const numbers = candidates.flatMap(({ site, type, mounting, aim }) => [
    site,
    types.indexOf(type),
    wayOf(mounting, ways),
    mounting.turn,
    ...(aim ?? [Number.NaN, 0, 0]),
  ]);
  const flux = Float64Array.from(types, (type) => type.flux);
  const error = scene.begin(room, types.map(fileOf), flux, Float64Array.from(numbers), paint);
  if (error) throw new Error(error);
}

/** Its number in `ways`, a new one where it is not there yet. */
function wayOf(mounting: Mounting, ways: Map<string, number>): number {
  const key = keyOf(0, mounting);
  const way = ways.get(key) ?? ways.size;
  ways.set(key, way);
  return way;
}

export class MountedSession extends HungSession {
  readonly #candidates: readonly Candidate[];
  readonly #dark: ReadonlySet<number>;
  readonly #bySite = new Map<number, number[]>(); // candidates of each site
  readonly #byKey = new Map<string, number>();
  readonly #types: readonly LuminaireType[];
  #allowed: Pick<CoreIntentions['luminaires'], 'types' | 'ofType'> = { types: [], ofType: new Uint32Array() };
  #hasAll = false; // everything that a search may try
  #held: readonly number[] = []; // candidates of the layout that a search starts from

  /** `session` has the scene of these candidates, but for the light of those on `dark` sites, which stay free. */
  constructor(session: Session, candidates: readonly Candidate[], dark: ReadonlySet<number> = new Set()) {
    super(session);
    this.#candidates = candidates;
    this.#dark = dark;
    this.#types = typesOf(candidates);
    candidates.forEach(({ site, mounting }, index) => {
      this.#bySite.set(site, [...(this.#bySite.get(site) ?? []), index]);
      this.#byKey.set(keyOf(site, mounting), index);
    });
  }

  /** Whether every luminaire of a layout hangs as one of the candidates does. */
  has({ sites, mountings }: Layout): boolean {
    return sites.every(
      (site, i) => mountings?.[i] && !this.#dark.has(site) && this.#byKey.has(keyOf(site, mountings[i])),
    );
  }

  /** A layout in candidates: each luminaire as it hangs, or as one may hang there; else it is left out. */
  take(layout: Layout): LayoutArguments {
    this.#held = layout.sites.flatMap((site, i) => this.#candidateAt(site, layout.mountings?.[i]) ?? []);
    return [Uint32Array.from(this.#held), new Float64Array(this.#held.length).fill(1), layout.dimming];
  }

  /**
   * What is asked of the types from now on: what they draw and, of a session that has all that a search may try, how many
   * there may be of each, and which luminaire must be of which.
   */
  ask({ types = [], ofType = [], count, most = count }: Luminaires, hasAll: boolean): void {
    this.#hasAll = hasAll;
    const latest = this.#types.map((type) => types.find(({ id }) => id === type.id) ?? type);
    this.session.setPowers(
      Float64Array.from(latest, ({ watts, flux }) => (watts > 0 ? watts : flux / usualEfficacy)),
    );
    const numberOf = (id: string | null) => latest.findIndex((type) => type.id === id);
    this.#allowed = {
      types: hasAll ? latest.map(({ name, count: [least, atMost] }) => ({ name, least, most: atMost })) : [],
      ofType: Uint32Array.from(hasAll ? ofType.slice(0, most) : [], (id) =>
        numberOf(id) < 0 ? anyType : numberOf(id),
      ),
    };
  }

  /**
   * Pinned are the luminaires of the layout that was taken, at their sites. Rules are for those who have all candidates: on
   * the places of one layout there may be no room for a field, and some of them may be excluded now.
   */
  protected beneath(asked: CoreIntentions): CoreIntentions {
    const luminaires = { ...asked.luminaires, ...this.#allowed, flux: Float64Array.of(1) };
    if (!this.#hasAll) return { ...asked, luminaires: ruledByNothing(luminaires, this.#candidates.length) };
    const pinned = [...luminaires.pinned].flatMap((site) => this.#pinnedAt(site) ?? []);
    const excluded = [...luminaires.excluded].flatMap((site) => this.#bySite.get(site) ?? []);
    return {
      ...asked,
      luminaires: {
        ...luminaires,
        pinned: Uint32Array.from(pinned),
        excluded: Uint32Array.from(excluded),
        minDistance: Math.max(apart, luminaires.minDistance),
      },
    };
  }

  /** How a luminaire hangs that is pinned to a site: as it does, unless it must be of another type. */
  #pinnedAt(site: number): number | undefined {
    const there = this.#bySite.get(site) ?? [];
    const luminaire = this.#held.findIndex((index) => there.includes(index));
    const type = this.#allowed.ofType[luminaire] ?? anyType;
    const isOf = (index: number) => this.#candidates[index]?.type === this.#types[type];
    const held = this.#held[luminaire] ?? there[0];
    if (type === anyType || held === undefined || isOf(held)) return held;
    return there.find(isOf) ?? held;
  }

  /** From candidates back to sites and mountings. */
  protected above({ sites, dimming, ties }: CoreLayout): CoreLayout {
    const hung = Array.from(sites, (index) => this.#candidates[index]!);
    return {
      sites: Uint32Array.from(hung, ({ site }) => site),
      flux: Float64Array.from(hung, ({ type }) => type.flux),
      dimming,
      ties,
      mountings: hung.map(({ mounting }) => mounting),
    };
  }

  #candidateAt(site: number, mounting: Mounting | undefined): number | undefined {
    if (this.#dark.has(site)) return undefined;
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

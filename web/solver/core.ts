/**
 * The TypeScript face of the Wasm module (wasm/bindings.cpp). One class, `Session`: a scene, the intentions, a search.
 * Typed arrays are copied in and come back as fresh copies; nothing here is a view of the module's memory.
 * Errors are one readable line, '' where all is well. tests/wasm checks every declared method against the built module.
 */
import type { PhotometricDescription } from '../document/photometry.ts';
import { statistics, type Statistic } from '../document/statistics.ts';
import type { Mounting, SceneInfo } from '../document/types.ts';

/** A line of the scene file's table that somebody has to inflate. */
export interface Section {
  readonly index: number;
  readonly name: string;
  readonly offset: number; // in the file, bytes
  readonly storedBytes: number;
  readonly inflatedBytes: number;
  readonly deflated: boolean; // zlib format; otherwise the stored bytes are the bytes
  readonly needed: boolean; // by finish(); the others may be verified
  readonly early: boolean; // by outline()
  readonly ofOperator: boolean; // for the light of candidates: all of these or none
  readonly ofStatistics: boolean; // needed by finish(), but not by finishLight()
}

/** What is in the scene that is open; m = sites. */
export interface CoreInfo extends Omit<SceneInfo, 'sites' | 'provenance' | 'hasOperator'> {
  readonly sitePosition: Float32Array; // 3m, m
  readonly siteNormal: Float32Array; // 3m
  readonly siteAxis: Float32Array; // 3m
  readonly siteSize: Float32Array; // m, m
}

export interface CoreLayout {
  readonly sites: Uint32Array; // N
  readonly flux: Float64Array; // N, lm
  readonly dimming: number;
  readonly ties: Uint32Array; // N: the tie that each moves with; empty = none is tied
  readonly mountings?: readonly Mounting[]; // where luminaires are of types: of MountedSession, not of the core
}

/** A layout that was chosen when the file was made, and its light. */
export interface CoreOpening {
  readonly layout: CoreLayout;
  readonly illuminance: Float32Array; // rows, lx
}

/** Where the search stands. */
export interface Progress {
  readonly evaluations: number; // since the start
  readonly foundAt: number; // the count at which the incumbent was found; 0 = it is the start
  readonly violation: number; // of the incumbent; 0 = every constraint is met
  readonly goal: number; // of the incumbent: sum of weight x signed value / reference value
  readonly proved: boolean; // everything that may be has been tried
}

/** What a search aside has found. */
export interface CoreTrial {
  readonly layout: CoreLayout;
  readonly violation: number;
  readonly goal: number;
  readonly limit: number | null; // proved: no layout has more of the one evenness that is asked for and missed
}

/** Everything that is shown of one layout. */
export interface CoreShown {
  readonly layout: CoreLayout;
  readonly illuminance: Float32Array; // rows, lx; where direct light is the quantity, of that alone
  readonly direct: Float32Array | null; // likewise, where some goal or constraint asks for direct light
  readonly surfaces: Float64Array; // 4 a leaf, then 4 of 'all': mean, sigma, min, max in the quantity asked for
  readonly goals: Float64Array; // 1 each: the value; of an aim its distance from the target, as a share of that
  readonly constraints: Float64Array; // 3 each: value (a contrast may be infinite or NaN), violation, margin (relative; negative = not met)
  /** 9 numbers each: eye (m), direction, UGR (-Infinity where nothing glares), background (cd/m2), E_z (lx). */
  readonly observers: { readonly names: readonly string[]; readonly numbers: Float64Array };
  /** 6 numbers a calculation grid: surface, points, largest spacing and rim (m), mean and least illuminance (lx). */
  readonly grids: Float64Array;
  /** Of each measuring plane that is asked about: surface, points, mean and least of E_h, E_z and E_z / E_h; then 5 of each
   *  vertical: direction, mean and least. */
  readonly planes: readonly Float64Array[];
}

export interface CoreCheck {
  readonly largestDifference: number; // of a mean or sigma, statistics against patches, relative to the mean
  readonly surface: number; // where: a leaf's index, or the number of leaves for 'all'
  readonly margins: Float64Array; // 1 a constraint, relative; negative = not met
}

/** One iteration of the alpha-search. */
export interface CoreAlphaStep {
  readonly alpha: number;
  readonly low: number; // the interval that it was tried for
  readonly high: number;
  readonly region: 'I' | 'II' | 'III';
  readonly mean: number; // of the guarded surfaces, as are the next two
  readonly sigma: number;
  readonly minimum: number; // true, over the patches
  readonly phi: number; // the goal in its own unit
}

export interface AlphaProgress {
  readonly done: boolean;
  readonly steps: readonly CoreAlphaStep[]; // the ones asked for
  readonly verdict: string; // '' until it is done
  readonly alpha: number | null; // the smallest that works
  readonly feasibleBound: number | null; // where none works: the best bound that some layout meets
  readonly layout: CoreLayout | null; // the answer, or the layout of the feasible bound
}

export interface BoundProgress {
  readonly done: boolean;
  readonly goal: number; // no layout has a goal below this; -Infinity until something is proved
  readonly gap: number | null; // the best possible is better than the incumbent by at most this share; null = unknown
}

const statisticCodes = Object.fromEntries(statistics.map((name, code) => [name, code])) as Record<
  Statistic,
  number
>;
const senseCodes = { min: 0, max: 1, near: 2 } as const;
const ruleCodes = { free: 0, symmetric: 1, rows: 2, field: 3 } as const;
const axisCodes = { found: 0, x: 1, z: 2, both: 3 } as const;
const quantityCodes = { illuminance: 0, exitance: 1, direct: 2 } as const;

/** The numbers of the core's enums; a module that counts otherwise is refused when it is loaded. */
export const codes = {
  statistic: statisticCodes,
  sense: senseCodes,
  quantity: quantityCodes,
  rule: ruleCodes,
  axis: axisCodes,
} as const;

/** Surfaces are sorted leaf indices, none for 'all'. */
export interface CoreGoal {
  readonly statistic: number;
  readonly sense: number;
  readonly weight: number;
  readonly surfaces: Uint32Array;
  readonly over: Uint32Array; // contrast only
  readonly target: number; // near only, above 0
  readonly quantity: number | null; // null: that of the intentions
}

export interface CoreConstraint {
  readonly statistic: number;
  readonly lower: number; // -Infinity = none
  readonly upper: number; // Infinity = none
  readonly alpha: number; // chebyshev only
  readonly surfaces: Uint32Array;
  readonly over: Uint32Array;
  readonly quantity: number | null; // null: that of the intentions
  readonly isLeast: boolean; // of the points of planes: of the least of them
  readonly direction: readonly [number, number, number] | null; // vertical only
  readonly onGrid: boolean; // at the points of the grid
}

/** How many luminaires of a type there may be; its name is for whoever reads that this cannot be. */
export interface CoreTypeRange {
  readonly least: number;
  readonly most: number;
  readonly name: string;
}

export const anyType = 0xffffffff;

/** A candidate that is not there. */
export const unknown = 0xffffffff;

export interface CoreIntentions {
  readonly quantity: number;
  readonly luminaires: {
    readonly count: number; // the least
    readonly countHigh: number; // the most; 0 = exactly `count`
    readonly rule: number;
    readonly axis: number;
    readonly leastInRow: number; // of rows
    readonly flux: Float64Array; // lm: one for all, or one each
    readonly dimmingLow: number;
    readonly dimmingHigh: number;
    readonly pinned: Uint32Array; // sites: of the first luminaires, or of those that hang there where a search starts
    readonly excluded: Uint32Array;
    readonly minDistance: number; // m
    readonly types: readonly CoreTypeRange[]; // of each type of the candidates; none = any number of any
    readonly ofType: Uint32Array; // that luminaire i must be of; anyType = any
  };
  readonly goals: readonly CoreGoal[];
  readonly constraints: readonly CoreConstraint[];
  readonly glare: CoreGlare | null; // null: nobody looks
  readonly zones: readonly CoreZone[]; // surfaces beyond those of the file, in their order
}

/** A part of a leaf surface, made of some of its rows. */
export interface CoreZone {
  readonly name: string;
  readonly leaf: number;
  readonly rows: Uint32Array; // ascending
}

/** Who looks, for glare: those that a room has by itself, or the ones named here, 6 numbers each (eye, direction). */
export interface CoreGlare {
  readonly inRoom: boolean;
  readonly names: readonly string[];
  readonly observers: Float64Array;
}

/** A value, or one readable line that says what is wrong. */
export type OrError<T> = T | string;

export interface Session {
  /** Checks a whole .flux file and lists its sections; the scene that was open stays until finish(). */
  openTable(file: Uint8Array): OrError<readonly Section[]>;
  /** The same of a file of which only header and table are there. */
  openHead(head: Uint8Array, fileBytes: number): OrError<readonly Section[]>;
  /** What is known of the room before its light, once every early section has been provided. */
  outline(): OrError<CoreInfo>;
  /** After outline(): the light that the file begins with, where it has one. */
  opening(): CoreOpening | null;
  /** Checks the inflated bytes of a section against the table. */
  verify(section: number, bytes: Uint8Array): string;
  /** verify(), then keeps a copy for finish(). */
  provide(section: number, bytes: Uint8Array): string;
  /** Decodes the needed sections into the scene. */
  finish(): string;
  /** After finish(): completes the scene by the sections of the operator; '' or one readable line. */
  finishOperator(): string;
  /**
   * Does some of what candidates will need of a room, while its responses are still on their way or once it is open: what is
   * seen from the places of its observers where `looks` (not once it is open), then of `count` sites. True when nothing is
   * left to do.
   */
  prepareLight(looks: boolean, count: number): boolean;
  /** Makes of a photometric file what its light will be computed with; unless it is used soon it is made again then. */
  expectType(file: Uint8Array): void;
  /** finish() without the statistics, and with the operator: candidates can be begun, intentions not be set yet. */
  finishLight(): string;
  /** After finishLight(): completes the scene by its statistics; '' or one readable line. */
  finishStatistics(): string;
  /** null while no scene is open. */
  info(): CoreInfo | null;
  /** W of a luminaire of each type of the candidates, before setIntentions. */
  setPowers(watts: Float64Array): void;
  /** Replaces what is asked and ends running searches; statistics of surface sets are kept. */
  setIntentions(intentions: CoreIntentions): string;
  /** Whether there is room on the sites for luminaires as they are asked for; false while no scene is open. */
  hasRoom(luminaires: CoreIntentions['luminaires']): boolean;
  /**
   * Some of what a search for the intentions will want to know of the scene, by `rows` rows of its light: true when nothing
   * is left to do. What is missing start() makes.
   */
  prepareSearch(rows: number): boolean;
  /** Begins a search at random. `seed`: 32 bits. */
  start(seed: number): string;
  /** Begins a search from a layout, fitted to the rules; its luminaires on pinned sites keep their numbers. */
  startFrom(seed: number, sites: Uint32Array, flux: Float64Array, dimming: number): string;
  /** Likewise, where some of its luminaires have just been moved: these stay, and at most four beside them follow. */
  startNear(
    seed: number,
    sites: Uint32Array,
    flux: Float64Array,
    dimming: number,
    moved: Uint32Array,
  ): string;
  /** Spends that many evaluations (one = one trial layout; a survey of near ones is four). */
  advance(evaluations: number): Progress;
  /**
   * Where the best layout misses a bound: looks among those that miss it by hardly more for one that serves the goals
   * better, which incumbent() then tells until advance(). Counts its own evaluations; violation is 0.
   */
  settle(evaluations: number): Progress;
  /**
   * Begins a short search for other intentions, from a layout where it has sites. Searches go on untouched; what is asked
   * next ends it.
   */
  startAside(intentions: CoreIntentions, seed: number, start: Uint32Array, evaluations: number): string;
  /** Something of what that starts from, which takes no evaluations; true when all of it is there, or nothing is tried. */
  enterAside(): boolean;
  /** Some of that, with at most so many evaluations: null until it is done. */
  advanceAside(evaluations: number): OrError<CoreTrial | null>;
  /** Readings of the best layout so far. */
  incumbent(): OrError<CoreShown>;
  /** Readings of any layout. */
  show(sites: Uint32Array, flux: Float64Array, dimming: number): OrError<CoreShown>;
  /** Statistics of a layout against its patches. */
  check(sites: Uint32Array, flux: Float64Array, dimming: number): OrError<CoreCheck>;
  /** Takes the scene that `candidates` have made, of which nothing is left; of quantities, observers and measuring planes
   *  only those of `asked` can be asked about. */
  adopt(candidates: Candidates, asked: CoreIntentions): string;
  /**
   * What lighter paint does for a layout in `room` as it is painted (this session is of it, or has adopted candidates in it,
   * and was asked the same): a row of numbers for each surface, its index and then what every goal and every constraint
   * gains per 0.1 more reflectance.
   */
  paintGains(
    room: Session,
    intentions: CoreIntentions,
    paint: Float64Array,
    sites: Uint32Array,
    flux: Float64Array,
    dimming: number,
  ): OrError<Float64Array>;
  /** Begins the alpha-search for the true minima and maxima that are asked for. `held`: sites of the layout whose
   *  luminaires are pinned; none = the first ones are. */
  startAlpha(seed: number, held: Uint32Array): string;
  /** Spends about that many evaluations; tells the iterations from number `from` on. */
  advanceAlpha(evaluations: number, from: number): OrError<AlphaProgress>;
  /** Begins to look for a provable bound on the goal of the search that runs or has run. */
  startBound(): string;
  /** Spends about that many steps (O(m) each). */
  advanceBound(steps: number): OrError<BoundProgress>;
  /** After startBound(): takes its last stage away, each step of which is long, for PairProof; empty where there is none. */
  takePairs(): Float64Array;
  /** What PairProof has proved of them. */
  provedByPairs(goal: number): void;
  /** Frees the session; nothing may be called after it. */
  delete(): void;
}

/** The last stage of a session's bound, in a module of its own. */
export interface PairProof {
  /** False where `pairs` are not what a session's takePairs() tells. */
  begin(pairs: Float64Array): boolean;
  /** One step; true when it was the last. */
  advance(): boolean;
  /** What is proved so far; -Infinity: nothing. */
  goal(): number;
  delete(): void;
}

/** A scene in the making, whose sites are luminaires of photometric files on the sites of a room. */
export interface Candidates {
  /**
   * `files` are photometric, `flux` (lm) is of one luminaire of each; in layouts every luminaire has a flux of 1. A candidate
   * is seven numbers: site, file, way (of file, turn and aim: the same on every site), turn (degrees), and the point that it
   * is aimed at or NaN. `paint` (corePaint): of the room. The room's session must stay.
   */
  begin(
    room: Session,
    files: readonly Uint8Array[],
    flux: Float64Array,
    candidates: Float64Array,
    paint: Float64Array,
  ): string;
  /** The candidates of `base`, whose light is all there in the room as its file has it, under paint: advance() makes theirs of it. */
  beginPainted(base: Candidates, room: Session, paint: Float64Array): string;
  /** Squares on some sites of a painted room: candidate i on sites[i]; in layouts fluxes are in lm. */
  beginSquares(room: Session, sites: Uint32Array, paint: Float64Array): string;
  /**
   * After begin(), takes what the scene of another session knows of the same luminaires in the same room and paint: `there`
   * has the index of each candidate in it, or `unknown`.
   */
  take(known: Session, there: Uint32Array): void;
  /** After take(): does without the light of some of them, which nobody is to try. */
  leaveDark(some: Uint32Array): void;
  /** After begin(): takes the light of all of them as somebody else has computed it, lx, column by column; '' or one line. */
  know(columns: Float32Array): string;
  /** After begin(): whoever is to adopt them will ask about the observers of `asked`. */
  observe(asked: CoreIntentions): void;
  /** Computes the light of so many more of them, then what is seen of them from one more place; true when all is there. */
  advance(count: number): boolean;
  delete(): void;
}

/** The colour that light takes from a room, for its picture. */
export interface ColoredLight {
  /**
   * `colors`: 3n, linear RGB of the patches; `paint` (corePaint) of the room that is lit. The room's session must stay, with
   * its operator; '' or one readable line.
   */
  begin(room: Session, colors: Float32Array, paint: Float64Array): string;
  /** After begin(): whether all of the room is grey, and light keeps its colour. */
  isGrey(): boolean;
  /** 2 a row: red and blue of white light there at a luminance of 1 (green is what lacks); `illuminance` in lx. */
  of(illuminance: Float32Array): Float32Array;
  delete(): void;
}

/** The methods of `Session` with their numbers of arguments, for the test against the built module. */
export const sessionMethods = {
  openTable: 1,
  openHead: 2,
  outline: 0,
  opening: 0,
  verify: 2,
  provide: 2,
  finish: 0,
  finishOperator: 0,
  expectType: 1,
  prepareLight: 2,
  prepareSearch: 1,
  finishLight: 0,
  finishStatistics: 0,
  info: 0,
  setPowers: 1,
  setIntentions: 1,
  hasRoom: 1,
  start: 1,
  startFrom: 4,
  startNear: 5,
  advance: 1,
  settle: 1,
  startAside: 4,
  enterAside: 0,
  advanceAside: 1,
  incumbent: 0,
  show: 3,
  check: 3,
  adopt: 2,
  paintGains: 6,
  startAlpha: 2,
  advanceAlpha: 2,
  startBound: 0,
  advanceBound: 1,
  takePairs: 0,
  provedByPairs: 1,
  delete: 0,
} as const satisfies { readonly [Method in keyof Session]: Parameters<Session[Method]>['length'] };

/** The words that the core's numbers stand for, in the order of the numbers. */
export type CoreCodes = { readonly [Kind in keyof typeof codes]: readonly string[] };

export interface CoreModule {
  codes(): CoreCodes;
  /** What a photometric file (LM-63 or EULUMDAT) says; needs no session. */
  describePhotometry(file: Uint8Array): OrError<PhotometricDescription>;
  readonly Session: new () => Session;
  readonly Candidates: new () => Candidates;
  readonly ColoredLight: new () => ColoredLight;
  readonly PairProof: new () => PairProof;
}

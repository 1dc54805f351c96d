/**
 * The worker protocol: two discriminated unions. The page asks, the worker answers; every request that may be
 * superseded carries a `revision`, and only the latest revision's answers are shown (latest wins).
 */
import type { PhotometricDescription } from '../document/photometry.ts';
import type { Intentions, Layout, Luminaires, SceneInfo } from '../document/types.ts';
import type { CoreAlphaStep } from './core.ts';

export interface SurfaceResult {
  readonly name: string;
  readonly area: number; // m2
  readonly mean: number; // lx (or lm/m2), as are sigma, min, max
  readonly sigma: number;
  readonly min: number; // over the patches
  readonly max: number;
}

/** One constraint or goal as it stands: the value reached, and for constraints whether it is met. */
export interface IntentionResult {
  readonly value: number; // mu - alpha sigma (or mu + alpha sigma) for chebyshev
  readonly met: boolean; // true for goals
  readonly violation: number; // relative, 0 when met
  readonly margin: number; // to the nearer bound, relative to it, negative when not met; Infinity for goals
}

/** Somebody who looks, and what glares there. */
export interface ObserverResult {
  readonly name: string;
  readonly position: readonly [number, number, number]; // of the eye, m
  readonly direction: readonly [number, number, number]; // unit
  readonly ugr: number | null; // null: nothing glares
  readonly background: number; // cd/m2
  readonly cylindrical: number; // lx
}

/** What the calculation grid of EN 12464-1 reads on a piece of a floor or a measuring plane. */
export interface GridResult {
  readonly name: string; // of the surface
  readonly points: number;
  readonly spacing: number; // m, the largest allowed
  readonly rim: number; // m that are left out along the edges
  readonly mean: number; // lx, E_m
  readonly min: number; // lx, E_min
  readonly max: number; // lx, E_max
}

/** Of the points of a measuring plane: their mean, and the least of them. */
export interface MeanAndLeast {
  readonly mean: number;
  readonly least: number;
}

/** What is told at the points of a measuring plane; lx, but for modelling, which may be infinite or NaN in the dark. */
export interface PlaneResult {
  readonly name: string;
  readonly points: number;
  readonly horizontal: MeanAndLeast;
  readonly cylindrical: MeanAndLeast;
  readonly modelling: MeanAndLeast;
  readonly verticals: readonly (MeanAndLeast & { readonly direction: readonly [number, number, number] })[];
}

/** A layout and its light: everything that the page shows. Buffers are transferred. */
export interface Shown {
  readonly layout: Layout;
  readonly illuminance: Float32Array; // n + receivers, lx; where direct light is the quantity, of that alone
  readonly direct?: Float32Array; // likewise: there where some goal or constraint asks for direct light
  readonly surfaces: readonly SurfaceResult[]; // one a leaf, then 'all' last; in the quantity asked for
  readonly goals: readonly IntentionResult[];
  readonly constraints: readonly IntentionResult[];
  readonly goal: number; // the weighted objective, relative to the start layout
  readonly violation: number; // 0 = every constraint is met
  readonly observers: readonly ObserverResult[]; // none: nobody looks, or the room's file cannot tell
  readonly grids: readonly GridResult[]; // of what `illuminance` is, those of task areas too
  readonly planes: readonly PlaneResult[]; // those that are asked about
}

/** A layout beside the one that is shown, and the colour of its light: red and blue of each patch at a luminance of 1. */
export interface Seen extends Shown {
  readonly colors: Float32Array | null; // white, or not known yet
}

/** What lighter paint on a surface does for what is asked: per 0.1 more reflectance, in the units of the results. */
export interface PaintGain {
  readonly surface: number; // leaf
  readonly goals: readonly number[];
  readonly constraints: readonly number[];
}

/** What a short search finds for other intentions. */
export interface Outcome {
  readonly layout: Layout;
  readonly lumens: number; // of all luminaires, dimmed
  readonly met: boolean; // every constraint
  readonly violation: number;
  readonly limit?: number; // proved, as in CoreTrial
}

/** A layout and its light as a scene file begins with them: to be seen while the rest is on its way. */
export type OpeningLight = Pick<Shown, 'layout' | 'illuminance'>;

export interface AlphaStep extends Omit<CoreAlphaStep, 'low' | 'high' | 'phi'> {
  readonly iteration: number;
  readonly interval: readonly [number, number]; // that it was tried for: (alpha a, alpha b) of figure 7
  readonly goal: number; // Phi
}

export type ToWorker =
  /** Opens a scene file -> 'room', then 'opened', or 'failed' instead of either. The buffer is transferred. */
  | { readonly type: 'open'; readonly revision: number; readonly bytes: ArrayBuffer }
  /**
   * Searches layouts for intentions, from `start` when given -> 'improved' at once (the first within some
   * milliseconds), again on every improvement, then 'settled'. Supersedes any running search.
   */
  | {
      readonly type: 'solve';
      readonly revision: number;
      readonly intentions: Intentions;
      readonly start: Layout | null;
      /** Luminaires of `start` that were put there by hand: at most four beside them follow. None: all may. */
      readonly moved: readonly number[];
      readonly seed: number;
      readonly askedAt: number; // performance.timeOrigin + event.timeStamp, ms; echoed for drag_to_layout
    }
  /** Shows exactly this layout (a link, a luminaire under the hand) -> 'improved' once, nothing searched. */
  | {
      readonly type: 'show';
      readonly revision: number;
      readonly intentions: Intentions;
      readonly layout: Layout;
    }
  /** The alpha-search of the paper's section 4 -> 'alphaStep'*, then 'alphaDone' (or 'failed'). */
  | {
      readonly type: 'alpha';
      readonly revision: number;
      readonly intentions: Intentions;
      readonly seed: number;
      readonly held: Layout | null; // whose luminaires hang on the pinned sites
    }
  /**
   * Tries other intentions shortly, one after the other, once no search runs -> 'compared' for each. `intentions`: those
   * that are asked, which the others are like.
   */
  | {
      readonly type: 'compare';
      readonly revision: number;
      readonly intentions: Intentions;
      readonly variants: readonly Intentions[];
      readonly start: Layout | null; // of the first; each of the others goes on from the one before
      readonly seed: number;
      readonly evaluations: number; // for each
    }
  /** A provable bound on the goal -> 'bounded', possibly several times, tighter each time. */
  | {
      readonly type: 'bound';
      readonly revision: number;
      readonly intentions: Intentions;
      readonly search: number | null; // revision of the 'solve' for these very intentions; null = there was none
      readonly isBrief: boolean; // without its last and longest stage
    }
  /** Recomputes every surface of a layout from the patches -> 'checked'. */
  | {
      readonly type: 'check';
      readonly revision: number;
      readonly intentions: Intentions;
      readonly search: number | null; // as for 'bound'
      readonly layout: Layout;
    }
  /**
   * Reads the light of another layout by the intentions asked last -> 'readings'. It supersedes nothing and nothing but
   * another room supersedes it: what runs goes on.
   */
  | {
      readonly type: 'read';
      readonly revision: number;
      readonly intentions: Intentions;
      readonly layout: Layout;
      /** lx of every row by each of its luminaires, column by column, where whoever owns the room has computed that. */
      readonly columns?: Float32Array<ArrayBuffer>;
    }
  /**
   * Reads a photometric file -> 'described', at once and whatever else runs. It supersedes nothing and nothing
   * supersedes it. The buffer is transferred.
   */
  | { readonly type: 'describe'; readonly revision: number; readonly file: ArrayBuffer }
  /** Keeps a photometric file for intentions whose luminaire types name it; no answer. The buffer is transferred. */
  | { readonly type: 'bring'; readonly hash: string; readonly file: ArrayBuffer }
  /** Linear RGB of the patches of the open room -> 'colored' after each light that is shown, where any has a colour. */
  | { readonly type: 'paint'; readonly colors: Float32Array }
  /**
   * Tells what lighter paint would do for the light of a layout, by its intentions -> 'gained', at once and
   * whatever else runs. It supersedes nothing and nothing supersedes it.
   */
  | {
      readonly type: 'gains';
      readonly revision: number;
      readonly intentions: Intentions;
      readonly layout: Layout;
    }
  /**
   * Looks which of these luminaires there is room for in the open room -> 'fitted'. It supersedes nothing and nothing but
   * another room supersedes it.
   */
  | { readonly type: 'fit'; readonly revision: number; readonly luminaires: readonly Luminaires[] }
  /** Stops whatever runs; the incumbent stays shown. */
  | { readonly type: 'stop' };

/** Before the app is there: fetches a file -> 'begun', 'fetched', and opens it as it comes, as revision 0. */
export type AheadRequest =
  | { readonly type: 'fetch'; readonly address: string }
  /** Another file is wanted: what is not opened yet need not be. */
  | { readonly type: 'abandon' };

export type FetchedAhead =
  /** Whether the host has such a file: then its first bytes are on their way. */
  | { readonly type: 'begun'; readonly isThere: boolean }
  /** A copy of the file; null = not all of it arrived. */
  | { readonly type: 'fetched'; readonly bytes: ArrayBuffer | null };

export type FromWorker =
  | { readonly type: 'ready' } // the module is loaded
  /** The display .glb, transferred: it can be read while the worker decodes the rest. */
  | { readonly type: 'room'; readonly revision: number; readonly room: ArrayBuffer }
  /** Of a file that is still arriving, requests wait until all of it is there; 'failed' may still follow. */
  | {
      readonly type: 'opened';
      readonly revision: number;
      readonly scene: SceneInfo;
      readonly light: OpeningLight | null;
    }
  | {
      readonly type: 'improved' | 'settled';
      readonly revision: number;
      readonly shown: Shown;
      readonly evaluations: number;
      readonly milliseconds: number; // of search
      readonly askedAt: number;
      readonly postedAt: number; // performance.timeOrigin + performance.now()
    }
  /** For the picture alone, of the light of this revision that was told last: 2 a row, as ColoredLight.of has them. */
  | { readonly type: 'colored'; readonly revision: number; readonly colors: Float32Array }
  | { readonly type: 'alphaStep'; readonly revision: number; readonly step: AlphaStep }
  | {
      readonly type: 'alphaDone';
      readonly revision: number;
      readonly alpha: number | null; // the smallest alpha found, null where there is none
      readonly verdict: string; // one sentence for a designer
      readonly shown: Shown | null;
      readonly feasibleBound: number | null; // where infeasible: the largest bound that some layout meets
    }
  | {
      readonly type: 'compared';
      readonly revision: number;
      readonly variant: number;
      readonly outcome: Outcome | null; // null: the rules leave no layout at all
      readonly done: boolean; // it was the last one
    }
  | {
      readonly type: 'bounded';
      readonly revision: number;
      readonly bound: number; // the goal cannot be better than this, proved
      readonly gap: number; // (incumbent - bound) / |incumbent|, >= 0
      readonly done: boolean;
    }
  | {
      readonly type: 'checked';
      readonly revision: number;
      readonly largestDifference: number; // relative, statistics against patches
      readonly surface: string; // where
      readonly margins: readonly { readonly constraint: number; readonly margin: number }[]; // relative
    }
  | {
      readonly type: 'readings';
      readonly revision: number;
      readonly shown: Seen | string; // one readable line where the layout cannot hang here
    }
  | {
      readonly type: 'described';
      readonly revision: number;
      readonly description: PhotometricDescription | string; // one readable line where it cannot be read
    }
  | {
      readonly type: 'gained';
      readonly revision: number;
      readonly gains: readonly PaintGain[] | string; // one readable line where nobody can say
    }
  | {
      readonly type: 'fitted';
      readonly revision: number;
      readonly first: number | null; // of the luminaires asked about; null: there is room for none
    }
  /** One readable line: what, where, the cure. The last good layout stays. */
  | {
      readonly type: 'failed';
      readonly revision: number;
      readonly message: string;
      readonly fatal: boolean; // no worker is left that could answer anything
    };

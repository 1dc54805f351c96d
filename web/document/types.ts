/**
 * What was asked: the one immutable document of the app. Undo, autosave, project files and share links all carry
 * this; what is shown (the light of a layout) lives apart, in `Shown` of the solver's answers.
 * Words and units are those of the core (core/search/intentions.h) and of intentions.json.
 */

export type Quantity = 'illuminance' | 'exitance'; // lx, or reflected lm/m2 (the paper's B)

export type Statistic =
  | 'mean'
  | 'sigma'
  | 'power' // total lm; no surface
  | 'chebyshev' // mu - alpha sigma >= min, mu + alpha sigma <= max
  | 'minimum'
  | 'maximum'
  | 'uniformity' // U_o = minimum / mean
  | 'contrast'; // mean of `surfaces` / mean of `over`

/** Names of leaf surfaces or of inner nodes of the surface tree; ['all'] = every surface but measuring planes. */
export type SurfaceNames = readonly string[];

export interface Goal {
  readonly statistic: Statistic; // mean, sigma, power or contrast
  readonly sense: 'min' | 'max';
  readonly weight: number;
  readonly surfaces: SurfaceNames;
  readonly over?: SurfaceNames;
}

export interface Constraint {
  readonly statistic: Statistic;
  readonly min?: number;
  readonly max?: number;
  readonly alpha?: number; // chebyshev only
  readonly surfaces: SurfaceNames;
  readonly over?: SurfaceNames;
}

export type Verb = 'illuminate' | 'overshadow' | 'homogenize' | 'vary' | 'keep';

/**
 * One card of the panel: a verb on a surface and what else is asked there. Cards are turned into goals and
 * constraints by `intentionsOf` (document/intentions.ts).
 */
export interface Card {
  readonly id: string;
  readonly surfaces: SurfaceNames;
  readonly verb: Verb;
  readonly weight: number;
  readonly mean?: { readonly min?: number; readonly max?: number };
  readonly spread?: { readonly max?: number; readonly min?: number }; // sigma
  readonly guarantee?: {
    readonly by: 'chebyshev' | 'patches'; // statistics, or the true minimum and maximum
    readonly alpha: number; // chebyshev only
    readonly min?: number;
    readonly max?: number;
  };
  readonly uniformity?: number; // U_o at least
  readonly contrast?: { readonly over: SurfaceNames; readonly min: number };
}

export interface Luminaires {
  readonly count: number;
  readonly flux: number; // lm each
  readonly dimming: readonly [number, number]; // common factor t; equal = not dimmable
  readonly pinned: readonly number[]; // sites
  readonly excluded: readonly number[]; // sites
  readonly minDistance: number; // m
}

export interface Camera {
  readonly position: readonly [number, number, number];
  readonly target: readonly [number, number, number];
  readonly plan: boolean; // orthographic view from above
}

/** A layout: luminaire i on sites[i], dimming * flux[i] lm. */
export interface Layout {
  readonly sites: readonly number[];
  readonly flux: readonly number[];
  readonly dimming: number;
}

export interface FiatLuxDocument {
  readonly scene: string; // identity of the .flux file, 16 hex digits
  readonly room: string; // id in the catalogue, or the file's name
  readonly cards: readonly Card[];
  readonly saving: boolean; // least power is a goal too
  readonly luminaires: Luminaires;
  readonly quantity: Quantity;
  readonly seed: number;
  /** The layout a person holds on to: from a link, by hand, or the last settled one. null = the search starts anew. */
  readonly layout: Layout | null;
}

/**
 * The words that every floor of the page shares. What was asked: the one immutable document, which undo, autosave,
 * project files and share links all carry, and the intentions made of it; what it was asked of (the room) and how it
 * is looked at (camera, display). What is shown (the light of a layout) lives apart, in `Shown` of the solver's answers.
 * Words and units are those of the core (core/search/intentions.h) and of intentions.json.
 */
import type { CheckedCard } from './schema.ts';
import type { Statistic } from './statistics.ts';

export type { Statistic };

/** lx; reflected lm/m2 (the paper's B); lx of what nothing has reflected, all that emergency lighting counts. */
export type Quantity = 'illuminance' | 'exitance' | 'direct';

/** Of the points of measuring planes: E_z, E_z / E_h, light on vertical planes that face a direction. */
export type PlaneStatistic = 'cylindrical' | 'modelling' | 'vertical';

/** Names of leaf surfaces or of inner nodes of the surface tree; ['all'] = every surface but measuring planes. */
export type SurfaceNames = readonly string[];

export interface Goal {
  readonly statistic: Statistic; // mean, sigma, power or contrast; mean where it is near a target
  readonly sense: 'min' | 'max' | 'near';
  readonly weight: number;
  readonly surfaces: SurfaceNames;
  readonly over?: SurfaceNames;
  readonly target?: number; // near only: worth |value - target| / target
  readonly quantity?: Quantity; // absent: that of the intentions
}

export interface Constraint {
  readonly statistic: Statistic;
  readonly min?: number;
  readonly max?: number;
  readonly alpha?: number; // chebyshev only
  readonly surfaces: SurfaceNames;
  readonly over?: SurfaceNames;
  readonly quantity?: Quantity; // absent: that of the intentions
  readonly of?: 'minimum'; // of the points of planes: of the least; absent: of their mean
  readonly direction?: Point; // vertical only: level, of any length but 0
  readonly on?: 'grid'; // mean, minimum, uniformity: at the points of the grid of EN 12464-1; absent: of the patches
}

/** Bounds of a statistic of planes: of the mean of the points, and of the least of them. */
export interface PlaneBounds {
  readonly min?: number;
  readonly max?: number;
  readonly least?: number;
}

export type Verb = 'illuminate' | 'overshadow' | 'homogenize' | 'vary' | 'keep';

/** As it passes the validators, for good. */
type Frozen<Value> = Value extends object ? { readonly [Key in keyof Value]: Frozen<Value[Key]> } : Value;

/**
 * One card of the panel: a verb on a surface and what else is asked there (document/schema.ts has its fields). Cards are
 * turned into goals and constraints by `intentionsOf` (document/intentions.ts).
 */
export type Card = Frozen<CheckedCard>;

/** A point of the room, m. */
export type Point = readonly [number, number, number];

/** Where luminaires of a type may be aimed: at the middle of a surface, by its name, or at a point. */
export type Aim = string | Point;

/**
 * A luminaire type: a photometric file and how luminaires of it may be used. The file itself is kept beside the
 * document (document/photometric-files.ts), under its hash.
 */
export interface LuminaireType {
  readonly id: string;
  readonly name: string; // as the file or a person says, never empty
  readonly maker: string;
  readonly file: string; // its name
  readonly hash: string; // of its bytes, 16 hex digits
  readonly flux: number; // lm of one luminaire
  readonly watts: number; // W of one luminaire; 0: not known
  readonly isOverridden?: boolean; // the flux is not the table's; absent: nobody has said which one holds
  readonly isAllowed: boolean; // the search may use it
  readonly count: readonly [number, number]; // of its luminaires
  readonly turns: readonly number[]; // degrees about the mount's normal, from its axis; at least one
  readonly tilt: number; // degrees that gamma 0 leans from the mount's normal towards C0, where it is not aimed
  readonly aims: readonly Aim[]; // none: it shines along the mount's normal
  readonly maxAimingAngle?: number; // degrees from the mount's normal to where it is aimed; absent: any
}

/** A luminaire of a type as it hangs. */
export interface Mounting {
  readonly type: string; // its id
  readonly turn: number; // degrees
  readonly aim: Point | null; // that gamma 0 goes through; null: as the type's tilt says
}

/** Somebody who looks, for glare. */
export interface Observer {
  readonly name: string;
  readonly position: Point; // of the eye
  readonly direction: Point; // of any length but 0
}

/** What glare is asked for: at most so much for anybody. */
export interface Glare {
  readonly max?: number; // UGR; absent: it is only told
  readonly observers?: readonly Observer[]; // absent: places all over the room, four directions each
}

/** How the luminaires hang together; an axis is one of the plan that a layout is mirrored about or rows run along. */
export type Rule = 'free' | 'symmetric' | 'rows' | 'field';
export type PlanAxis = 'found' | 'x' | 'z' | 'both'; // both: not of rows

export interface Arrangement {
  readonly rule: Rule;
  readonly axis?: PlanAxis; // absent = found; of a field: anywhere
  readonly leastInRow?: number; // luminaires, of rows; absent = as usual (ties.ts)
}

/** A rectangle in plan, in the room's axes, m: the smaller x and z, then the larger ones. */
export type PlanArea = readonly [x: number, z: number, farX: number, farZ: number];

/** Corners in plan, in the room's axes, m; three at least. */
export type PlanOutline = readonly (readonly [x: number, z: number])[];

/** Where in plan luminaires may hang: outside all of `keepOut`, inside one of `keepIn` where there are any. */
export interface Areas {
  readonly keepOut: readonly (PlanArea | PlanOutline)[];
  readonly keepIn: readonly (PlanArea | PlanOutline)[];
  readonly fromWalls: number; // m, at least, from a luminaire's middle
}

/** Part of a measuring plane or of a floor with light of its own, by its outline in plan (document/task-areas.ts). */
export interface TaskArea {
  readonly name: string; // its own among surfaces and areas
  readonly surface: string; // leaf that it is part of
  readonly outline: PlanOutline;
}

export interface Luminaires {
  readonly types?: readonly LuminaireType[]; // absent or none: Lambertian squares of `flux`
  readonly ofType?: readonly (string | null)[]; // id of the type that luminaire i must be of; null, beyond the end: any
  readonly count: number; // the least, where `most` is there
  readonly most?: number; // the count may be up to this
  readonly arrangement?: Arrangement; // absent = free
  readonly flux: number; // lm each
  readonly dimming: readonly [number, number]; // common factor t; equal = not dimmable
  readonly pinned: readonly number[]; // sites
  readonly excluded: readonly number[]; // sites
  readonly areas?: Areas; // absent: anywhere
  readonly minDistance: number; // m
  /** LLMF, LSF, LMF, RMF (CIE 97), 0..1: all light is maintained light. Absent: that of the new installation. */
  readonly maintenance?: readonly [number, number, number, number];
}

export interface Camera {
  readonly position: readonly [number, number, number];
  readonly target: readonly [number, number, number];
  readonly plan: boolean; // orthographic view from above
  readonly aspect?: number; // width / height of the picture that it was seen in
}

/** A view that a person keeps; its name is its own in the document. */
export interface NamedView {
  readonly name: string;
  readonly camera: Camera;
}

/** A layout: luminaire i on sites[i], dimming * flux[i] lm. */
export interface Layout {
  readonly sites: readonly number[];
  readonly flux: readonly number[];
  readonly dimming: number;
  readonly mountings?: readonly Mounting[]; // one a luminaire; absent: Lambertian squares
  readonly ties?: readonly number[]; // of each luminaire, the number of the tie it moves with; absent = none is tied
}

/** A surface in another paint than its file says. */
export interface Paint {
  readonly surface: string; // a leaf
  readonly reflectance: number; // leastPaint to mostPaint (document/paint.ts)
  readonly color?: string; // '#rrggbb', of which the hue is taken; absent: the material's own, lighter or darker
}

/** How electric energy is reckoned; what is absent is as usual (document/energy.ts). */
export interface Energy {
  readonly efficacy?: number; // lm/W, of luminaires whose type does not say what they draw
  readonly day?: number; // h a year with daylight
  readonly night?: number; // and without
  readonly occupancy?: number; // 0..1 of these hours: F_o
  readonly constant?: number; // 0..1 of the power, where light is kept constant over the years: F_c
  readonly daylight?: number; // 0..1 of the power that daylight leaves, while there is any: F_D
  readonly standby?: number; // kWh/(m2 a)
}

export interface FiatLuxDocument {
  readonly scene: string; // identity of the .flux file, 16 hex digits
  readonly room: string; // id in the catalogue, or the file's name
  readonly cards: readonly Card[];
  readonly saving: boolean; // least power is a goal too
  readonly glare?: Glare; // absent: nobody looks
  readonly taskAreas?: readonly TaskArea[]; // absent: none
  readonly luminaires: Luminaires;
  readonly quantity: Quantity;
  readonly seed: number;
  readonly roomType?: string; // id of what a standard asks of such a room, beside the cards
  readonly paint?: readonly Paint[]; // at most one a surface; absent: the room as its file has it
  readonly energy?: Energy; // absent: as usual
  /** The layout a person holds on to: from a link, by hand, or the last settled one. null = the search starts anew. */
  readonly layout: Layout | null;
  readonly views?: readonly NamedView[]; // absent: none; links leave them out
  readonly kept?: Variant; // absent: none; a link carries its layout alone, where that fits
}

/** Kept beside the work to be compared with it: everything that was asked, and the layout that answered. */
export interface Variant extends Omit<FiatLuxDocument, 'scene' | 'room' | 'layout' | 'views' | 'kept'> {
  readonly layout: Layout;
}

/** What the solver is asked for: cards turned into goals and constraints, surfaces still by their names. */
export interface Intentions {
  readonly luminaires: Luminaires;
  readonly goals: readonly Goal[];
  readonly constraints: readonly Constraint[];
  readonly quantity: Quantity;
  readonly glare?: Glare; // heeded where the room's file tells what stands in the way of sight
  readonly paint?: readonly Paint[]; // heeded where the file tells how surfaces light each other
  readonly taskAreas?: readonly TaskArea[]; // surfaces may be named by them
}

/**
 * What a scene file tells of its room. Indices of `surfaces` are leaf surfaces; receivers are measuring planes.
 * Lengths: rows = patches + receivers.
 */
export interface SceneInfo {
  readonly identity: string;
  readonly patches: number;
  readonly receivers: number;
  readonly clusters: number;
  readonly surfaces: readonly {
    readonly name: string;
    readonly area: number; // m2
    readonly patches: number;
    readonly reflectance: number;
    readonly measuring: boolean;
    readonly border?: number; // m, of a measuring plane: what it leaves out along the edges of what it measures
    readonly lost: number; // share 0..1
    readonly part?: { readonly leaf: number; readonly rows: Uint32Array }; // of no file: a task area, of that leaf
  }[];
  /** m x 3 position (m), m x 3 normal, m x 3 axis (unit), m sizes (m). */
  readonly sites: {
    readonly position: Float32Array;
    readonly normal: Float32Array;
    readonly axis: Float32Array;
    readonly size: Float32Array;
  };
  readonly surfaceOfPatch: Uint32Array; // rows
  readonly patchArea: Float32Array; // rows, m2
  readonly patchCenter: Float32Array; // 3 rows, m
  readonly patchCovered: Uint8Array; // rows: 1 = left out of statistics; empty = none is
  readonly patchReflectance: Float32Array; // rows: exitance = this x illuminance; 0 on measuring planes
  readonly hasOperator?: boolean; // its file knows the light of any photometry, not of squares only
  readonly provenance: unknown; // JSON of how the file was made: options, rays, residuals, seconds, patch size
}

export type ColorMap = 'viridis' | 'cividis' | 'inferno' | 'turbo';

/** Who looks: a camera evens most of a change of light out, an eye adapts about half-way. */
export type Adaptation = 'camera' | 'eye';

/** How the light is drawn. */
export interface Display {
  readonly mode: 'realistic' | 'falseColor';
  readonly exposure: number; // EV, realistic mode; 0 = automatic
  readonly exposureLevel?: number; // lx: the exposure is locked at this level of light; absent = it adapts
  readonly adaptation?: Adaptation; // absent = camera
  readonly colorMap: ColorMap;
  readonly steps: number; // 0 = continuous
  readonly logarithmic: boolean;
  readonly range: readonly [number, number]; // lx, ends of the legend
  readonly rangeFollows?: boolean; // the ends follow the light that is shown; absent = they are locked
  readonly isolux: boolean;
  readonly quantity: Quantity;
  readonly cutAway: boolean; // do not draw walls between the eye and the room
  readonly section?: number; // m: what is higher in the room is not drawn; absent = the whole room is
  readonly measuringPlanes: boolean; // draw them
  readonly values?: boolean; // false colour: readings on measuring planes; absent = none
  readonly luminaires?: boolean; // draw them and their tags; absent = yes
}

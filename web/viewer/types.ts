/** What the app asks of the view; implemented by `createViewer` (viewer/viewer.ts). The viewer draws only on change. */
import type { PlanFrame, RoomPlan } from '../document/plan-frame.ts';
import type { MarkedArea } from '../document/areas.ts';
import type { Camera, Display, Layout, SceneInfo } from '../document/types.ts';

export type ViewName = 'plan' | 'north' | 'east' | 'south' | 'west' | 'corner';

export interface ViewerEvents {
  /**
   * A leaf surface under the pointer (null = none) and the light there (lx, and reflected, lm/m2); x, y in CSS px of
   * the canvas.
   */
  hovered(
    surface: number | null,
    at: { x: number; y: number; lux: number; exitance: number; point: [number, number, number] } | null,
  ): void;
  /** A click, on a surface or beside it; `place`: in the air before what was clicked, m (of a preview: units of its file). */
  surfacePicked(surface: number | null, place: readonly [number, number, number] | null): void;
  /**
   * alone: it and no other is selected from now on; also: it joins the selected ones, or leaves them; held: it is about to be
   * dragged, with all that are selected where it is one of them.
   */
  luminairePicked(luminaire: number | null, how: 'alone' | 'also' | 'held'): void;
  /** While a luminaire is dragged: each time it snaps to another free site. */
  luminaireDragged(luminaire: number, site: number): void;
  luminaireDropped(luminaire: number, site: number): void;
  cameraMoved(camera: Camera): void;
  /** The WebGL context is gone or back. */
  contextLost(lost: boolean): void;
}

/** What luminaires of a type look like: their luminous area and, where it is known, their light. */
export interface LuminaireBody {
  readonly id: string; // of the type
  readonly tilt: number; // degrees, where they are not aimed
  readonly along: number; // m, of the luminous area along C0
  readonly across: number; // m, along C90
  readonly height: number; // m, along gamma 0
  readonly round: boolean;
  readonly candela: Float32Array; // as a description has it
}

/** A luminaire that shines, as it hangs. */
export interface LuminaireLight {
  readonly position: readonly [number, number, number]; // m, the middle of its luminous area
  readonly along: readonly [number, number, number]; // unit, C0
  readonly across: readonly [number, number, number]; // unit, C90
  readonly down: readonly [number, number, number]; // unit, gamma 0
  readonly size: readonly [along: number, across: number]; // m
  readonly flux: number; // lm
  readonly candela: Float32Array | null; // as a photometric description samples it, of any flux; null: Lambertian
}

/** The tag of a luminaire that can be read, px: its middle and its size. */
export interface TagPlace {
  readonly x: number;
  readonly y: number;
  readonly wide: number;
  readonly high: number;
}

/** A layout and its light, lx a patch; on its way to another one, its luminaires hang between their places in both. */
export interface OtherLight {
  readonly illuminance: Float32Array;
  readonly layout: Layout;
  readonly colors?: Float32Array | null; // of the light, as of setLightColor
  readonly towards?: { readonly layout: Layout; readonly share: number };
}

/** A leaf surface that is painted: its albedo is another (linear RGB), or its material's own times a factor. */
export interface SurfacePaint {
  readonly surface: number;
  readonly reflectance: number;
  readonly albedo: readonly [number, number, number] | null;
  readonly factor: number; // of the material's own albedo, where it has no other
}

/** Somebody who looks, and what glares there. */
export interface SeenGlare {
  readonly position: readonly [number, number, number]; // of the eye, m
  readonly direction: readonly [number, number, number];
  readonly ugr: number | null; // null: nothing glares
}

/** A storey of the room that is shown, and where one stands in its rooms. */
export interface StoreyView {
  readonly floor: number; // m, its height in the room
  readonly clear: number; // m over it
  readonly cut: number; // m, a height for the section that lets one see into its rooms
  readonly rooms: readonly { readonly surface: number; readonly area: number; readonly camera: Camera }[]; // surface: leaf of the floor that is its own, or -1
}

/** What there is to look at where there are several rooms; lengths: m, heights in the room. */
export interface BuildingView {
  readonly storeys: readonly StoreyView[]; // from below
  readonly low: number;
  readonly high: number;
}

export interface Viewer {
  /** Begins to read a room's display mesh, for an `open` of the same buffer. */
  prepare(glb: ArrayBuffer): void;
  /** Shows a room's display mesh; resolves when it can be drawn. Rejects with one readable line. */
  open(glb: ArrayBuffer, scene: SceneInfo): Promise<void>;
  /** A plain .glb may come: what draws it is made ready meanwhile. */
  expectPreview(): void;
  /** Shows a plain .glb without light (a dropped file that still needs `fiatlux precompute`). */
  preview(glb: ArrayBuffer, options?: { readonly keepView?: boolean }): Promise<void>;
  /**
   * The next room is come into: from within, at dusk; as soon as there is light it fades on and the eye rises to home. Any
   * input ends that at once. Nothing of it where less motion is asked for.
   */
  arrive(): void;
  /**
   * The light of a layout: n + receivers values, lx. Cheap: once per solver update. Sets the mark 'light set': the next
   * frame shows it in full.
   */
  setLight(illuminance: Float32Array): void;
  /** The colour of that light: red and blue of each patch at a luminance of 1. White until it is first told. */
  setLightColor(colors: Float32Array): void;
  /** The paint on the surfaces, and what each patch reflects under it; null: as in the file. */
  setPaint(paint: readonly SurfacePaint[], patchReflectance: Float32Array | null): void;
  /** Leaf surfaces that are outlined, for something is told of them. */
  setGlow(surfaces: readonly number[]): void;
  /** Linear RGB of each patch as its material has it, some time after the room was opened; null where it is not there any more. */
  colors(): Promise<Float32Array | null>;
  /** `pinned`: sites. */
  setLayout(layout: Layout, pinned: readonly number[]): void;
  /** Another light of the same room, drawn left of a divider with the same eye, exposure and scale; null: none. */
  compareWith(other: OtherLight | null): void;
  /** Where the divider stands, a share of the picture's width. */
  divide(share: number): void;
  /**
   * Of the types that a layout's mountings name, and of those of the layout that it is compared with, whose names may mean
   * other ones; luminaires of types that are not there are drawn as squares.
   */
  setBodies(bodies: readonly LuminaireBody[], others: readonly LuminaireBody[]): void;
  /** The luminaire picked last is the last. */
  setSelection(surface: number | null, luminaires: readonly number[]): void;
  /** The leaf surfaces that the intentions name: the room is first looked at from where they are seen. */
  setAims(surfaces: readonly number[]): void;
  /** Flies to where these leaf surfaces are seen, unless they are. */
  reveal(surfaces: readonly number[]): void;
  /** Sites that those are going to that move with a luminaire in the hand. */
  setGhosts(sites: readonly number[]): void;
  /** Areas in plan, one that is being drawn included. */
  setAreas(areas: readonly MarkedArea[]): void;
  /** The room's x and z, m, under a point of the page in a plan view; null elsewhere. */
  planPoint(clientX: number, clientY: number): readonly [x: number, z: number] | null;
  /** Sites where no luminaire may hang, and which of them are marked. */
  setBarred(sites: readonly number[], crossed: readonly number[]): void;
  /** Those whose glare is asked for. */
  setObservers(observers: readonly SeenGlare[]): void;
  /** From now on nothing in the picture can be picked or taken: pointers and keys only move the eye, and hover. */
  lookOnly(): void;
  setDisplay(display: Display): void;
  /** The next frame is the panel's, which has much to lay out in it. */
  standBack(): void;
  /** True while a person drags: the exposure stays as it is, so that more light looks brighter. */
  holdExposure(active: boolean): void;
  /** The light that the exposure is made for, lx: what a lock keeps. */
  exposureLevel(): number;
  setCamera(camera: Camera): void;
  /** As setCamera, in a short flight. */
  flyTo(camera: Camera): void;
  /** The view that is on the screen; a movement that is still running out ends there. */
  camera(): Camera;
  /** Where the corner of the floor is; null before a room is open. */
  frame(): PlanFrame | null;
  /** The room in plan, made out of its mesh; null before a room is open. */
  plan(): RoomPlan | null;
  /** Null where there is but one room, or none. */
  building(): BuildingView | null;
  /** Where to cut the room that is open, so that what is asked about (setAims) is seen: m; null where nothing hides it. */
  openingCut(): Promise<number | null>;
  view(name: ViewName): void;
  fit(): void;
  home(): void;
  /** The present picture, drawn at once; one in false colours has its legend in a corner. */
  png(): Promise<Blob>;
  /** What is seen in a picture of one size and shape, however large the view is on the screen; else as png. */
  picture(): Promise<Blob>;
  /** The middle of the present picture, drawn at once, in so few pixels. Whoever asks closes it. */
  thumbnail(width: number, height: number): Promise<ImageBitmap>;
  /** The present picture, drawn at once, as one of a video; µs from its beginning. Whoever asks closes it. */
  still(timestamp: number): VideoFrame;
  dispose(): void;
}

export type CreateViewer = (canvas: HTMLCanvasElement, labels: HTMLElement, events: ViewerEvents) => Viewer;

/** [x, z] in metres: x to the right, z downwards in the plan. */
export type Point = readonly [number, number];
export type ItemKind =
  | 'desk' | 'workplace' | 'table' | 'round table' | 'chair' | 'office chair' | 'cupboard' | 'bookcase' | 'sofa'
  | 'bench' | 'partition' | 'plant' | 'column' | 'round column'; // prettier-ignore
export type OpeningKind = 'door' | 'window';
export type MountKind = 'ceiling' | 'tiles' | 'rails' | 'plane';
export type FinishName = 'ceiling' | 'walls' | 'floor';

export interface Finish {
  readonly reflectance: number; // 0..0.95
  readonly colour: string; // #rrggbb
}

export interface Opening {
  readonly kind: OpeningKind;
  readonly wall: number; // from corner `wall` to the next
  readonly at: number; // m along the wall, to the nearer edge
  readonly width: number; // m
  readonly sill: number; // m
  readonly height: number; // m
}

export interface Item {
  readonly kind: ItemKind;
  readonly x: number; // m, of the centre
  readonly z: number;
  readonly turn: number; // degrees, counter-clockwise from above; 0: the front looks down the plan
  readonly size: readonly [width: number, depth: number, height: number]; // m
}

/** Where luminaires may hang. */
export interface Mount {
  readonly kind: MountKind;
  readonly spacing: number; // m between places; the edge of a tile
  readonly luminaire: number; // m, its edge; the width of a rail
  readonly drop: number; // m below the ceiling: rails and suspended planes
  readonly rows: number; // m between rails
  readonly origin: Point; // a corner of a tile
  readonly turn: number; // degrees, of tiles and rails
}

export interface Task {
  readonly x: number; // m, of the centre
  readonly z: number;
  readonly width: number; // m
  readonly depth: number;
  readonly height: number; // m above the floor
  readonly turn: number; // degrees
}

export interface RoomPlan {
  readonly name: string;
  readonly outline: readonly Point[]; // clockwise as the plan is drawn
  readonly height: number; // m
  readonly finishes: Readonly<Record<FinishName, Finish>>;
  readonly openings: readonly Opening[];
  readonly items: readonly Item[];
  readonly mount: Mount;
  readonly plane: { readonly height: number; readonly rim: number } | null; // m
  readonly tasks: readonly Task[];
}

export type ReadPlan =
  | { readonly plan: RoomPlan; readonly fault?: undefined }
  | { readonly plan?: undefined; readonly fault: string };

export const itemKinds: readonly ItemKind[];
export const mostItems: number;
export const mostCorners: number;
export const sizesOf: Readonly<Record<ItemKind, string>>; // letters of 'wdh' that a person may choose

export function readPlan(value: unknown): ReadPlan;
export function planOf(outline: readonly Point[], height: number, name?: string): RoomPlan;
export function usualItem(kind: ItemKind, at: Point, height: number, turn?: number): Item;
export function usualOpening(kind: OpeningKind, wall: number, at: number): Opening;
export function wallName(plan: RoomPlan, wall: number): string;

/**
 * A model as columns over a grid in plan: of each cell the level faces that its middle meets, from below to above, and
 * on any height the cells that upright faces pass. From these, floors and the spaces over them are read (storeys.ts).
 */
import type { Box } from '../eye/framing.ts';

const mostCells = 60_000;
const finest = 0.12; // m
const level = 0.7; // cosine of the slope that a face may have

/** Triangles in world space: three corners each in `index`, xyz each in `positions`, m. */
export interface Solid {
  readonly index: ArrayLike<number>;
  readonly positions: ArrayLike<number>;
  readonly surface: number; // leaf, -1 = none
}

/** What the middle of a cell meets on the way up. */
export interface Face {
  readonly y: number; // m
  readonly facesUp: boolean;
  readonly surface: number;
}

export class Columns {
  readonly wide: number; // cells along x
  readonly deep: number; // cells along z
  readonly size: number; // m, of a cell
  readonly faces: readonly (readonly Face[])[]; // by cell: x + wide * z
  readonly #solids: readonly Solid[];
  readonly #box: Box;

  constructor(solids: readonly Solid[], box: Box) {
    const [width, depth] = [box.max[0] - box.min[0], box.max[2] - box.min[2]];
    this.size = Math.max(finest, Math.sqrt((width * depth) / mostCells));
    this.wide = Math.max(1, Math.ceil(width / this.size));
    this.deep = Math.max(1, Math.ceil(depth / this.size));
    this.#box = box;
    this.#solids = solids;
    this.faces = this.#met();
  }

  /** x and z of the middle of a cell, m. */
  middle(cell: number): [x: number, z: number] {
    const [x, z] = [cell % this.wide, Math.floor(cell / this.wide)];
    return [this.#box.min[0] + (x + 0.5) * this.size, this.#box.min[2] + (z + 0.5) * this.size];
  }

  /** The cells that something passes at a height: 1. */
  passedAt(y: number): Uint8Array {
    const passed = new Uint8Array(this.wide * this.deep);
    for (const { index, positions } of this.#solids)
      forEachCut(index, positions, y, (ax, az, bx, bz) => this.#draw(passed, ax, az, bx, bz));
    return passed;
  }

  #met(): Face[][] {
    const faces: Face[][] = Array.from({ length: this.wide * this.deep }, () => []);
    for (const { index, positions, surface } of this.#solids)
      for (let i = 0; i + 2 < index.length; i += 3) {
        const [a, b, c] = [3 * index[i]!, 3 * index[i + 1]!, 3 * index[i + 2]!];
        this.#meet(faces, positions, surface, a, b, c);
      }
    for (const column of faces) column.sort((one, other) => one.y - other.y);
    return faces;
  }

  /** Puts a triangle into the columns whose middles it covers. */
  #meet(faces: Face[][], p: ArrayLike<number>, surface: number, a: number, b: number, c: number): void {
    const [ux, uy, uz] = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!];
    const [vx, vy, vz] = [p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!];
    const up = uz * vx - ux * vz; // twice its area in plan
    const [nx, nz] = [uy * vz - uz * vy, ux * vy - uy * vx];
    if (up * up <= level * level * (nx * nx + up * up + nz * nz)) return;
    const { min } = this.#box;
    const [ax, az, y] = [p[a]! - min[0], p[a + 2]! - min[2], p[a + 1]!];
    const firstX = Math.max(0, Math.ceil((ax + Math.min(0, ux, vx)) / this.size - 0.5));
    const lastX = Math.min(this.wide - 1, Math.floor((ax + Math.max(0, ux, vx)) / this.size - 0.5));
    const firstZ = Math.max(0, Math.ceil((az + Math.min(0, uz, vz)) / this.size - 0.5));
    const lastZ = Math.min(this.deep - 1, Math.floor((az + Math.max(0, uz, vz)) / this.size - 0.5));
    for (let z = firstZ; z <= lastZ; z++)
      for (let x = firstX; x <= lastX; x++) {
        const [dx, dz] = [(x + 0.5) * this.size - ax, (z + 0.5) * this.size - az];
        const [s, t] = [(dz * vx - dx * vz) / up, (dx * uz - dz * ux) / up];
        if (s < 0 || t < 0 || s + t > 1) continue;
        faces[x + this.wide * z]!.push({ y: y + s * uy + t * vy, facesUp: up > 0, surface });
      }
  }

  #draw(passed: Uint8Array, ax: number, az: number, bx: number, bz: number): void {
    const steps = Math.max(1, Math.ceil((3 * Math.hypot(bx - ax, bz - az)) / this.size));
    for (let i = 0; i <= steps; i++) {
      const at = (a: number, b: number, low: number) =>
        Math.floor((a + ((b - a) * i) / steps - low) / this.size);
      const x = Math.min(this.wide - 1, Math.max(0, at(ax, bx, this.#box.min[0])));
      const z = Math.min(this.deep - 1, Math.max(0, at(az, bz, this.#box.min[2])));
      passed[x + this.wide * z] = 1;
    }
  }
}

/** The segments (ends in plan) in which a level plane cuts triangles; those that lie in it are none. */
export function forEachCut(
  index: ArrayLike<number>,
  positions: ArrayLike<number>,
  y: number,
  visit: (ax: number, az: number, bx: number, bz: number) => void,
): void {
  const ends = [0, 0, 0, 0];
  for (let i = 0; i + 2 < index.length; i += 3) {
    const [a, b, c] = [3 * index[i]!, 3 * index[i + 1]!, 3 * index[i + 2]!];
    const [isA, isB, isC] = [positions[a + 1]! > y, positions[b + 1]! > y, positions[c + 1]! > y];
    if (isA === isB && isB === isC) continue;
    let at = 0;
    const cross = (from: number, to: number) => {
      const k = (y - positions[from + 1]!) / (positions[to + 1]! - positions[from + 1]!);
      ends[at++] = positions[from]! + k * (positions[to]! - positions[from]!);
      ends[at++] = positions[from + 2]! + k * (positions[to + 2]! - positions[from + 2]!);
    };
    if (isA !== isB) cross(a, b);
    if (isB !== isC) cross(b, c);
    if (isC !== isA) cross(c, a);
    visit(ends[0]!, ends[1]!, ends[2]!, ends[3]!);
  }
}

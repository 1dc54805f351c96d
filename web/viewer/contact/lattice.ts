/**
 * What the light near contacts is known on: a lattice on each triangle that is worth it, so many cells along an edge, rows
 * along its first edge from its first corner to the third.
 */
import { TriangleTree } from '../room/triangle-tree.ts';

export type Vec = readonly [number, number, number];
export type Triple = [number, number, number];

/** Triangles of one surface, in the room's coordinates, m. */
export interface SolidPart {
  readonly index: Uint32Array;
  readonly positions: Float32Array; // 3 a vertex
  readonly normals: Float32Array; // 3 a vertex, unit
  readonly patches: Float32Array; // 4 a vertex: patches that it blends
  readonly weights: Float32Array; // 4 a vertex: their shares
  readonly reflectance: number;
}

export interface Solid {
  readonly parts: readonly SolidPart[];
  readonly patchCenter: Float32Array; // 3 a patch, m
  readonly edge: number; // m, of a usual patch
}

/** A triangle with what is asked of it again and again. */
export interface Face {
  readonly part: SolidPart;
  readonly vertices: readonly [number, number, number];
  readonly corners: readonly [Vec, Vec, Vec];
  readonly normal: Vec;
  readonly area: number; // m2
}

/** The triangles of a room, to be met by rays. */
export class Solids {
  readonly tree: TriangleTree;
  readonly positions: Float32Array;
  readonly index: Uint32Array;
  readonly partOf: Uint16Array; // a triangle
  readonly room: Solid;

  constructor(room: Solid) {
    const total = (list: (part: SolidPart) => { readonly length: number }) =>
      room.parts.reduce((sum, part) => sum + list(part).length, 0);
    this.room = room;
    this.positions = new Float32Array(total(({ positions }) => positions));
    this.index = new Uint32Array(total(({ index }) => index));
    this.partOf = new Uint16Array(this.index.length / 3);
    let [vertices, corners] = [0, 0];
    room.parts.forEach((part, p) => {
      this.positions.set(part.positions, 3 * vertices);
      this.partOf.fill(p, corners / 3, (corners + part.index.length) / 3);
      for (const vertex of part.index) this.index[corners++] = vertices + vertex;
      vertices += part.positions.length / 3;
    });
    this.tree = TriangleTree.of(this.index, this.positions);
  }
}

/** Values of a lattice. */
export const latticeSize = (cells: number): number => ((cells + 1) * (cells + 2)) / 2;

/** Where the value at i cells along the first edge and j along the second is. */
export const placeOf = (cells: number, i: number, j: number): number =>
  j * (cells + 1) - (j * (j - 1)) / 2 + i;

/** A little above a face and inside of it, so that what only touches its border does not hide the place. */
export function placeAbove(face: Face, u: number, v: number, lift: number, inside = 2 * lift): Triple {
  const point = pointOf(face, u, v);
  const middle = pointOf(face, 1 / 3, 1 / 3);
  const pull = Math.min(0.3, inside / Math.max(1e-9, distance(point, middle)));
  return point.map(
    (value, axis) => value + pull * (middle[axis]! - value) + lift * face.normal[axis]!,
  ) as Triple;
}

/** Places of a lattice that are next to each other. */
export const beside = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
  [1, -1],
  [-1, 1],
] as const;

/**
 * Places that are covered take what is seen nearest to them, and `otherwise` where nothing is: their darkness is not to be
 * smeared over the edge of what covers them, nor to show on a sliver beside it.
 */
export function uncover(
  values: Float32Array,
  covered: ArrayLike<number | boolean>,
  cells: number,
  otherwise: number,
): void {
  const isKnown = Array.from(covered, (is) => !is);
  for (let isDone = false; !isDone;) {
    const before = isKnown.slice();
    isDone = true;
    for (let j = 0; j <= cells; j++)
      for (let i = 0; i <= cells - j; i++) {
        const here = placeOf(cells, i, j);
        if (before[here]) continue;
        let [sum, count] = [0, 0];
        for (const [di, dj] of beside) {
          const [p, q] = [i + di, j + dj];
          if (p < 0 || q < 0 || p + q > cells || !before[placeOf(cells, p, q)]) continue;
          sum += values[placeOf(cells, p, q)]!;
          count++;
        }
        if (count === 0) continue;
        values[here] = sum / count;
        isKnown[here] = true;
        isDone = false;
      }
  }
  isKnown.forEach((is, k) => {
    if (!is) values[k] = otherwise;
  });
}

/** Means over patches of what is known at lattices: every small triangle counts for the patch whose middle is nearest. */
export class PatchMeans {
  readonly #patchCenter: Float32Array;
  readonly #sums: Float64Array; // area x value
  readonly #areas: Float64Array;

  constructor({ patchCenter }: Solid) {
    this.#patchCenter = patchCenter;
    this.#sums = new Float64Array(patchCenter.length / 3);
    this.#areas = new Float64Array(patchCenter.length / 3);
  }

  /** `valueOf`: the mean over a small triangle by its corners in the lattice, and the share of it that counts. */
  add(
    face: Face,
    cells: number,
    valueOf: (corners: Triple) => readonly [value: number, share: number],
  ): void {
    const patches = patchesOf(face);
    const n = Math.max(1, cells);
    for (let j = 0; j < n; j++)
      for (let i = 0; i < n - j; i++) {
        const [a, b, c] = [placeOf(n, i, j), placeOf(n, i + 1, j), placeOf(n, i, j + 1)];
        this.#count(face, patches, [(i + 1 / 3) / n, (j + 1 / 3) / n], valueOf([a, b, c]), n);
        if (i + j + 1 >= n) continue;
        const across = valueOf([b, c, placeOf(n, i + 1, j + 1)]);
        this.#count(face, patches, [(i + 2 / 3) / n, (j + 2 / 3) / n], across, n);
      }
  }

  /** Of every patch; `otherwise` where nothing counted. */
  means(otherwise: number): Float32Array {
    return Float32Array.from(this.#sums, (sum, p) =>
      this.#areas[p]! > 0 ? sum / this.#areas[p]! : otherwise,
    );
  }

  #count(
    face: Face,
    patches: readonly number[],
    [u, v]: readonly [number, number],
    [value, share]: readonly [number, number],
    cells: number,
  ): void {
    const [x, y, z] = pointOf(face, u, v);
    const center = this.#patchCenter;
    let [nearest, best] = [-1, Infinity];
    for (const patch of patches) {
      const [dx, dy, dz] = [center[3 * patch]! - x, center[3 * patch + 1]! - y, center[3 * patch + 2]! - z];
      const far = dx * dx + dy * dy + dz * dz;
      if (far < best) [nearest, best] = [patch, far];
    }
    if (nearest < 0) return;
    const area = (share * face.area) / (cells * cells);
    this.#sums[nearest]! += area * value;
    this.#areas[nearest]! += area;
  }
}

export function faceOf(part: SolidPart, first: number): Face | null {
  const vertices = [0, 1, 2].map((i) => part.index[first + i]!) as Triple;
  const corners = vertices.map((v) => [...part.positions.subarray(3 * v, 3 * v + 3)]) as unknown as [
    Vec,
    Vec,
    Vec,
  ];
  const [a, b, c] = corners;
  const normal = cross(minus(b, a), minus(c, a));
  const size = Math.hypot(...normal);
  if (!(size > 1e-12)) return null;
  return { part, vertices, corners, area: size / 2, normal: normal.map((x) => x / size) as Triple };
}

export function pointOf({ corners: [a, b, c] }: Face, u: number, v: number): Triple {
  const w = 1 - u - v;
  return [w * a[0] + u * b[0] + v * c[0], w * a[1] + u * b[1] + v * c[1], w * a[2] + u * b[2] + v * c[2]];
}

/** As the surface is shaded; that of the triangle where the file's points elsewhere. */
export function smoothNormal({ part, vertices, normal }: Face, u: number, v: number): Vec {
  const n: Triple = [0, 0, 0];
  [1 - u - v, u, v].forEach((share, corner) => {
    for (let axis = 0; axis < 3; axis++) n[axis]! += share * part.normals[3 * vertices[corner]! + axis]!;
  });
  const size = Math.hypot(...n);
  const along = (n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2]) / size;
  return along > 0.3 ? [n[0] / size, n[1] / size, n[2] / size] : normal;
}

/** All patches that the corners of a face blend. */
export function patchesOf({ part: { patches, weights }, vertices }: Face): number[] {
  const found: number[] = [];
  for (const vertex of vertices)
    for (let k = 4 * vertex; k < 4 * vertex + 4; k++)
      if (weights[k]! > 0 && !found.includes(patches[k]!)) found.push(patches[k]!);
  return found;
}

export const minus = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const distance = (a: Vec, b: Vec): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
export const cross = (a: Vec, b: Vec): Triple => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

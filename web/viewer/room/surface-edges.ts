/**
 * Edges of a surface's mesh: where it ends, and where it bends by more than a crease angle. The same as three's
 * EdgesGeometry, but with integer keys, so that a wall of many thousand triangles does not stop the picture, and
 * without the seams of flat neighbours that are cut differently.
 */

import { weldVertices } from './weld.ts';
import type { Pieces } from '../stage/breath.ts';

const weld = 5e-4; // m: vertices as near as this are one
const shortest = 1e-4; // m: less is no edge

type Triple = readonly [number, number, number];

/** Unit normals of triangles, xyz each; NaN where one has no area. `corners`: vertices, three a triangle. */
function normalsOf(positions: ArrayLike<number>, corners: Uint32Array): Float64Array {
  const normals = new Float64Array(corners.length);
  // note: plain numbers, for this runs before the browser has compiled it well.
  for (let i = 0; i + 2 < corners.length; i += 3) {
    const a = 3 * corners[i]!;
    const b = 3 * corners[i + 1]!;
    const c = 3 * corners[i + 2]!;
    const ux = positions[b]! - positions[a]!;
    const uy = positions[b + 1]! - positions[a + 1]!;
    const uz = positions[b + 2]! - positions[a + 2]!;
    const vx = positions[c]! - positions[a]!;
    const vy = positions[c + 1]! - positions[a + 1]!;
    const vz = positions[c + 2]! - positions[a + 2]!;
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    const length = Math.hypot(x, y, z);
    const scale = length > 1e-12 ? 1 / length : NaN;
    normals[i] = x * scale;
    normals[i + 1] = y * scale;
    normals[i + 2] = z * scale;
  }
  return normals;
}

/** Open edges that lie on one line and belong to triangles of one plane: a place on it and the steps of what is left of it. */
interface Line {
  readonly foot: Triple;
  readonly direction: Triple;
  readonly steps: { readonly at: number; readonly change: 1 | -1 }[];
}

const dot = (a: Triple, b: Triple): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const along = (a: Triple, b: Triple, t: number): Triple => [
  a[0] + t * b[0],
  a[1] + t * b[1],
  a[2] + t * b[2],
];

/** Odd scales and an offset, so that round measures of a room do not fall between two keys. */
const keyOf = (triple: Triple, scale: number): string =>
  triple.map((value) => Math.round(value * scale + 0.317)).join(' ');

/** Ends of an edge with a triangle on one side, and the unit normal of that. */
interface OpenEdge {
  readonly from: Triple;
  readonly to: Triple;
  readonly normal: Triple;
}

/**
 * Where flat neighbours are cut differently (T-junctions), both sides have open edges that run against each other on
 * one line. They cancel; what remains is the boundary.
 */
function cancelOpposed(open: readonly OpenEdge[]): [Triple, Triple][] {
  const lines = new Map<string, Line>();
  for (const { from, to, normal } of open) {
    const span = along(to, from, -1);
    const length = Math.hypot(...span);
    if (length < shortest) continue;
    const leading = span.find((value) => Math.abs(value) > 0.5 * length)!;
    const direction = span.map((value) => (Math.sign(leading) * value) / length) as unknown as Triple;
    const foot = along(from, direction, -dot(from, direction));
    const key = `${keyOf(direction, 197.3)}|${keyOf(foot, 197.3)}|${keyOf(normal, 19.7)}`;
    let line = lines.get(key);
    if (!line) lines.set(key, (line = { foot, direction, steps: [] }));
    line.steps.push(
      { at: dot(from, line.direction), change: 1 },
      { at: dot(to, line.direction), change: -1 },
    );
  }
  const left: [Triple, Triple][] = [];
  for (const { foot, direction, steps } of lines.values()) {
    steps.sort((a, b) => a.at - b.at);
    let covered = 0;
    steps.forEach(({ at, change }, i) => {
      covered += change;
      const next = steps[i + 1]?.at ?? at;
      if (covered !== 0 && next - at > shortest)
        left.push([along(foot, direction, at), along(foot, direction, next)]);
    });
  }
  return left;
}

/** Directed edges whose twin was not met yet, by open addressing: a Map of them would be much to clean up. */
class OpenEdges {
  readonly #mask: number;
  readonly #from: Int32Array; // -1: none was here
  readonly #to: Int32Array;
  readonly #corner: Int32Array; // of the triangle; -1: met

  constructor(most: number) {
    const capacity = 1 << Math.max(4, Math.ceil(Math.log2(2 * most)));
    this.#mask = capacity - 1;
    this.#from = new Int32Array(capacity).fill(-1);
    this.#to = new Int32Array(capacity);
    this.#corner = new Int32Array(capacity);
  }

  add(from: number, to: number, corner: number): void {
    const slot = this.#slot(from, to);
    this.#from[slot] = from;
    this.#to[slot] = to;
    this.#corner[slot] = corner;
  }

  /** Removes an edge; the corner that came with it, or -1. */
  take(from: number, to: number): number {
    const slot = this.#slot(from, to);
    if (this.#from[slot] === -1) return -1;
    const corner = this.#corner[slot]!;
    this.#corner[slot] = -1;
    return corner;
  }

  forEach(visit: (from: number, to: number, corner: number) => void): void {
    for (let slot = 0; slot <= this.#mask; slot++)
      if (this.#from[slot]! >= 0 && this.#corner[slot]! >= 0)
        visit(this.#from[slot]!, this.#to[slot]!, this.#corner[slot]!);
  }

  #slot(from: number, to: number): number {
    let slot = (Math.imul(from, 73856093) ^ Math.imul(to, 19349663)) & this.#mask;
    while (this.#from[slot] !== -1 && (this.#from[slot] !== from || this.#to[slot] !== to))
      slot = (slot + 1) & this.#mask;
    return slot;
  }
}

/** Ends of the edges, xyz each, two ends an edge. `crease` in degrees. */
export function* surfaceEdges(
  index: ArrayLike<number>,
  positions: ArrayLike<number>,
  crease: number,
): Pieces<Float32Array> {
  const welded = yield* weldVertices(positions, weld);
  yield;
  const cosine = Math.cos((crease * Math.PI) / 180);
  const corners = new Uint32Array(index.length);
  for (let i = 0; i < index.length; i++) corners[i] = welded[index[i]!]!;
  const normals = normalsOf(positions, corners);
  const normal = (first: number): Triple => [normals[first]!, normals[first + 1]!, normals[first + 2]!];
  yield;
  const open = new OpenEdges(index.length);
  const at = (v: number): Triple => [positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!];
  const drawn: [Triple, Triple][] = [];
  for (let i = 0; i + 2 < index.length; i += 3) {
    if (Number.isNaN(normals[i])) continue;
    for (let side = 0; side < 3; side++) {
      const from = corners[i + side]!;
      const to = corners[i + ((side + 1) % 3)]!;
      const twin = open.take(to, from);
      if (twin < 0) open.add(from, to, i);
      else if (dot(normal(i), normal(twin)) < cosine) drawn.push([at(from), at(to)]);
    }
  }
  yield;
  const ends: OpenEdge[] = [];
  open.forEach((from, to, corner) => ends.push({ from: at(from), to: at(to), normal: normal(corner) }));
  yield;
  drawn.push(...cancelOpposed(ends));
  return Float32Array.from(drawn.flat(2));
}

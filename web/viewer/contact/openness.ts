/**
 * Light within a patch, near what touches it. The file knows the mean of a patch, and a keyboard is smaller than one; so
 * the picture spreads that mean over the patch by how open each place is to what is further away:
 *   V(x) = 1 - a (1 - mean over directions, by the cube of their cosine, of 1 - w (1 - c rho)), w = 1 - (d / reach)^2,
 *          for what is met from its front at d < reach, of reflectance rho; 0 from behind; 1 for what meets nothing;
 *          a: the share of light that comes from all round; 0 where a solid covers x
 *   E(x) = V(x) x (light of the patches, blended) / (mean V of the patches, blended)
 * so a patch keeps its mean, and what is hidden under a foot no longer darkens what is seen beside it. V is known at a
 * lattice on each triangle before which something ends; elsewhere it is 1: the corner of two walls is what their patches say.
 */
import { TriangleTree } from '../room/triangle-tree.ts';

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

export interface Openness {
  /** A part: two numbers a triangle: its first value, and the cells along an edge; none: V is 1 there. */
  readonly tiles: readonly Uint32Array[];
  /** V x 255 at the lattice of each triangle, rows along its first edge, from its first corner to the third. */
  readonly values: Uint8Array;
  readonly means: Float32Array; // V a patch
}

const directions = 32;
const crowd = 100; // triangles about a face: from here on the tree is faster
const fine = 0.035; // m, of the lattice
const mostCells = 8; // along an edge
const touching = 0.06; // m: what is nearer has a shadow with an edge
const within = 0.01; // m: so far inside of a triangle is not at its border
const lift = 1e-3; // m above the surface, and towards the triangle's middle
const same = 1e-5; // m
const halvings = 4; // to where something begins to cover a surface
const steepest = 0.25; // of a cell: what V does in less is not continued
const darkest = 0.1; // V behind an edge
const around = 0.5; // of the light comes from all round; the rest from luminaires, whose shadows the patches know
const lit = 0.8; // how bright, for its reflectance, what is met is

type Vec = readonly [number, number, number];
type Triple = [number, number, number];

/** About z, by the cube of the cosine: most light comes from before a surface, little from along it. */
const hemisphere: readonly Vec[] = Array.from({ length: directions }, (_, k) => {
  const z = (1 - (k + 0.5) / directions) ** 0.25;
  const [r, turn] = [Math.sqrt(1 - z * z), k * Math.PI * (3 - Math.sqrt(5))];
  return [r * Math.cos(turn), r * Math.sin(turn), z];
});

/** About z: straight on and aslant, where the walls of what covers a place are met. */
const lookouts: readonly Vec[] = [
  [0, 0, 1],
  [0.5, 0.5, Math.SQRT1_2],
  [-0.5, 0.5, Math.SQRT1_2],
  [-0.5, -0.5, Math.SQRT1_2],
  [0.5, -0.5, Math.SQRT1_2],
];

export const latticeSize = (cells: number): number => ((cells + 1) * (cells + 2)) / 2;

/** Takes seconds in a furnished room. */
export function openness(solid: Solid): Openness {
  return new OpennessOfRoom(solid).run();
}

/** A triangle with what is asked of it again and again. */
interface Face {
  readonly part: SolidPart;
  readonly vertices: readonly [number, number, number];
  readonly corners: readonly [Vec, Vec, Vec];
  readonly normal: Vec;
  readonly area: number; // m2
}

class OpennessOfRoom {
  readonly #solid: Solid;
  readonly #reach: number; // m
  readonly #least: number; // m2, of a triangle that is looked at: smaller ones have their patches' light
  readonly #tree: TriangleTree;
  readonly #partOf: Uint16Array; // a triangle
  readonly #positions: Float32Array;
  readonly #index: Uint32Array;
  readonly #sums: Float64Array; // a patch: area x V
  readonly #areas: Float64Array; // a patch
  readonly #near = new NearTriangles();
  #values = new Uint8Array(1 << 16);
  #used = 0;

  constructor(solid: Solid) {
    const { parts, patchCenter, edge } = solid;
    this.#solid = solid;
    this.#reach = Math.min(0.3, Math.max(0.15, 1.5 * edge));
    this.#least = (0.4 * edge) ** 2 / 2;
    const total = (list: (part: SolidPart) => { readonly length: number }) =>
      parts.reduce((sum, part) => sum + list(part).length, 0);
    this.#positions = new Float32Array(total(({ positions }) => positions));
    this.#index = new Uint32Array(total(({ index }) => index));
    this.#partOf = new Uint16Array(this.#index.length / 3);
    let [vertices, corners] = [0, 0];
    parts.forEach((part, p) => {
      this.#positions.set(part.positions, 3 * vertices);
      this.#partOf.fill(p, corners / 3, (corners + part.index.length) / 3);
      for (const vertex of part.index) this.#index[corners++] = vertices + vertex;
      vertices += part.positions.length / 3;
    });
    this.#tree = new TriangleTree(this.#index, this.#positions);
    this.#sums = new Float64Array(patchCenter.length / 3);
    this.#areas = new Float64Array(patchCenter.length / 3);
  }

  run(): Openness {
    const tiles = this.#solid.parts.map((part) => {
      const tile = new Uint32Array((2 * part.index.length) / 3);
      for (let t = 0; 3 * t < part.index.length; t++) {
        const face = faceOf(part, 3 * t);
        if (face) tile.set(this.#addTile(face), 2 * t);
      }
      return tile;
    });
    const means = Float32Array.from(this.#sums, (sum, p) =>
      this.#areas[p]! > 0 ? sum / this.#areas[p]! : 1,
    );
    return { tiles, values: this.#values.slice(0, this.#used), means };
  }

  /** How finely a triangle is looked at; 0: nothing is before it. */
  #cellsOf(face: Face): number {
    const [a, b, c] = face.corners;
    const longest = Math.max(distance(a, b), distance(b, c), distance(c, a));
    if (face.area < this.#least) return 0;
    const above = face.normal.map((x) => touching * x) as Triple;
    const near = boxAbout(face.corners, above, -within);
    const isNear = this.#tree.some(...near, (first) => this.#isBefore(face, first, 2 * lift));
    if (!isNear) return 0;
    this.#near.clear();
    this.#tree.some(...boxAbout(face.corners, [0, 0, 0], this.#reach), (first) => {
      if (this.#isBefore(face, first, lift)) this.#near.add(this.#positions, this.#index, first);
      return false;
    });
    return Math.min(mostCells, Math.max(1, Math.ceil(longest / (Math.SQRT2 * fine) - 0.01)));
  }

  /** Whether a triangle rises above the plane of a face. */
  #isBefore({ corners, normal }: Face, first: number, height: number): boolean {
    for (let i = first; i < first + 3; i++) {
      const at = 3 * this.#index[i]!;
      let above = 0;
      for (let axis = 0; axis < 3; axis++)
        above += normal[axis]! * (this.#positions[at + axis]! - corners[0][axis]!);
      if (above > height) return true;
    }
    return false;
  }

  /** V at the lattice of a face, and its share in the means of the patches there; where it lies, and its cells. */
  #addTile(face: Face): [first: number, cells: number] {
    const begin = this.#used;
    const cells = this.#cellsOf(face);
    const found = this.#lattice(face, cells);
    const edges = this.#edges(face, found, cells);

    // Every small triangle counts for the patch whose middle is nearest.
    const patches = patchesOf(face);
    const n = Math.max(1, cells);
    const row = (j: number) => j * (n + 1) - (j * (j - 1)) / 2;
    for (let j = 0; j < n; j++)
      for (let i = 0; i < n - j; i++) {
        const [a, b, c] = [row(j) + i, row(j) + i + 1, row(j + 1) + i];
        const value = meanBefore(found, edges, [a, b, c]);
        this.#count(face, patches, (i + 1 / 3) / n, (j + 1 / 3) / n, value, n);
        if (i + j + 1 >= n) continue;
        const across = meanBefore(found, edges, [b, c, row(j + 1) + i + 1]);
        this.#count(face, patches, (i + 2 / 3) / n, (j + 2 / 3) / n, across, n);
      }
    if (cells === 0) return [0, 0];

    goOnBehind(found, edges);
    uncover(found, n);
    const count = found.length;
    if (begin + count > this.#values.length) {
      const more = new Uint8Array(2 * this.#values.length);
      more.set(this.#values);
      this.#values = more;
    }
    for (let k = 0; k < count; k++) this.#values[begin + k] = Math.round(255 * found[k]!);
    this.#used += count;
    return [begin, cells];
  }

  /** V at a lattice of so many cells an edge; of none: 0 for what lies wholly within a solid, else 1. */
  #lattice(face: Face, cells: number): Float32Array {
    const found = new Float32Array(latticeSize(Math.max(1, cells)));
    if (cells === 0) return found.fill(this.#isWithin(face) ? 0 : 1);
    let k = 0;
    for (let j = 0; j <= cells; j++)
      for (let i = 0; i <= cells - j; i++) found[k++] = this.#at(face, i / cells, j / cells);
    return found;
  }

  /** Where between neighbours of the lattice one is covered and the other is not. */
  #edges(face: Face, found: Float32Array, cells: number): Edges {
    const edges: Edges = new Map();
    const row = (j: number) => j * (cells + 1) - (j * (j - 1)) / 2;
    for (let j = 0; j <= cells; j++)
      for (let i = 0; i <= cells - j; i++) {
        const seen = row(j) + i;
        if (found[seen] === 0) continue;
        for (const [di, dj] of beside) {
          const [p, q] = [i + di, j + dj];
          if (p < 0 || q < 0 || p + q > cells || found[row(q) + p]! > 0) continue;
          const edge = this.#edgeBetween(face, [i / cells, j / cells], [p / cells, q / cells], found[seen]!);
          edges.set(edgeKey(seen, row(q) + p), edge);
        }
      }
    return edges;
  }

  /** By halving. */
  #edgeBetween(face: Face, [u, v]: readonly number[], [cu, cv]: readonly number[], open: number): Edge {
    let [before, behind, value] = [0, 1, open];
    for (let step = 0; step < halvings; step++) {
      const middle = (before + behind) / 2;
      const there = this.#at(face, u! + middle * (cu! - u!), v! + middle * (cv! - v!));
      if (there > 0) [before, value] = [middle, there];
      else behind = middle;
    }
    return { share: (before + behind) / 2, value };
  }

  #count(face: Face, patches: readonly number[], u: number, v: number, value: number, cells: number): void {
    const { patchCenter } = this.#solid;
    const [x, y, z] = pointOf(face, u, v);
    let [nearest, best] = [-1, Infinity];
    for (const patch of patches) {
      const [dx, dy] = [patchCenter[3 * patch]! - x, patchCenter[3 * patch + 1]! - y];
      const dz = patchCenter[3 * patch + 2]! - z;
      const far = dx * dx + dy * dy + dz * dz;
      if (far < best) [nearest, best] = [patch, far];
    }
    if (nearest < 0) return;
    const area = face.area / (cells * cells);
    this.#sums[nearest]! += area * value;
    this.#areas[nearest]! += area;
  }

  #at(face: Face, u: number, v: number): number {
    // A little above the surface and inside of the triangle, so that what only touches its border does not hide it.
    const { normal } = face;
    const point = pointOf(face, u, v);
    const middle = pointOf(face, 1 / 3, 1 / 3);
    const pull = Math.min(0.3, (2 * lift) / Math.max(1e-9, distance(point, middle)));
    const [x, y, z] = point.map(
      (value, axis) => value + pull * (middle[axis]! - value) + lift * normal[axis]!,
    ) as Triple;

    const tree = this.#tree;
    if (this.#isCovered(x, y, z, normal)) return 0;
    const up = smoothNormal(face, u, v);
    const [s, t] = frameAbout(up);
    const isCrowded = this.#near.count > crowd;
    if (!isCrowded) this.#near.lookFrom(x, y, z, this.#reach);
    let sum = 0;
    for (const [a, b, c] of hemisphere) {
      const dx = a * s[0] + b * t[0] + c * up[0];
      const dy = a * s[1] + b * t[1] + c * up[1];
      const dz = a * s[2] + b * t[2] + c * up[2];
      const met = isCrowded ? this.#meet(x, y, z, dx, dy, dz) : this.#near.meet(dx, dy, dz);
      if (met === 0) sum += 1;
      else if (met > 0) {
        const first = isCrowded ? tree.met : this.#near.first;
        const { reflectance } = this.#solid.parts[this.#partOf[first / 3]!]!;
        const near = 1 - (met / this.#reach) ** 2;
        sum += 1 - near * (1 - lit * reflectance);
      }
    }
    return 1 - around * (1 - sum / directions);
  }

  /** Whether a face before which nothing ends is covered nevertheless: by a solid that is larger. */
  #isWithin(face: Face): boolean {
    const [x, y, z] = pointOf(face, 1 / 3, 1 / 3).map((value, axis) => value + lift * face.normal[axis]!);
    return this.#isCovered(x!, y!, z!, face.normal);
  }

  /** Whether a place lies within a solid: from there all that is before the surface is seen from behind. */
  #isCovered(x: number, y: number, z: number, normal: Vec): boolean {
    const tree = this.#tree;
    const [s, t] = frameAbout(normal);
    return lookouts.every(([a, b, c]) => {
      const [dx, dy, dz] = [0, 1, 2].map((axis) => a * s[axis]! + b * t[axis]! + c * normal[axis]!) as Triple;
      tree.reach(x, y, z, dx, dy, dz, true, Infinity);
      return tree.met >= 0 && tree.isBack;
    });
  }

  /** As NearTriangles.meet, by the tree. */
  #meet(x: number, y: number, z: number, dx: number, dy: number, dz: number): number {
    const far = this.#tree.reach(x, y, z, dx, dy, dz, true, this.#reach);
    return this.#tree.met < 0 ? 0 : this.#tree.isBack ? -far : far;
  }
}

const numbersEach = 13; // of a triangle: a corner, two edges, its middle and radius

/** The few triangles about a face: for rays that reach no further, faster than a tree. */
class NearTriangles {
  count = 0;
  first = 0; // of the triangle last met
  #numbers = new Float64Array(numbersEach * 64);
  #firsts: number[] = [];
  #seen: number[] = []; // those within reach of the eye
  #eye: Triple = [0, 0, 0];
  #reach = 0;

  clear(): void {
    this.count = 0;
  }

  add(positions: Float32Array, index: Uint32Array, first: number): void {
    const at = numbersEach * this.count;
    if (at === this.#numbers.length) {
      const more = new Float64Array(2 * at);
      more.set(this.#numbers);
      this.#numbers = more;
    }
    const n = this.#numbers;
    let radius = 0;
    for (let axis = 0; axis < 3; axis++) {
      const a = positions[3 * index[first]! + axis]!;
      const b = positions[3 * index[first + 1]! + axis]!;
      const c = positions[3 * index[first + 2]! + axis]!;
      const [low, high] = [Math.min(a, b, c), Math.max(a, b, c)];
      n[at + axis] = a;
      n[at + 3 + axis] = b - a;
      n[at + 6 + axis] = c - a;
      n[at + 9 + axis] = (low + high) / 2;
      radius += ((high - low) / 2) ** 2;
    }
    n[at + 12] = Math.sqrt(radius);
    this.#firsts[this.count++] = first;
  }

  /** Where the rays to come begin, and how far they go. */
  lookFrom(x: number, y: number, z: number, reach: number): void {
    this.#eye = [x, y, z];
    this.#reach = reach;
    this.#seen.length = 0;
    const n = this.#numbers;
    for (let i = 0; i < this.count; i++) {
      const at = numbersEach * i;
      const [dx, dy, dz] = [n[at + 9]! - x, n[at + 10]! - y, n[at + 11]! - z];
      if (dx * dx + dy * dy + dz * dz < (reach + n[at + 12]!) ** 2) this.#seen.push(at);
    }
  }

  /** How far the nearest triangle along d is, negative from behind; 0: none within reach. */
  meet(dx: number, dy: number, dz: number): number {
    const n = this.#numbers;
    const [x, y, z] = this.#eye;
    const seen = this.#seen;
    let best = this.#reach;
    let found = 0;
    for (let i = 0; i < seen.length; i++) {
      const at = seen[i]!;
      const ux = n[at + 3]!;
      const uy = n[at + 4]!;
      const uz = n[at + 5]!;
      const vx = n[at + 6]!;
      const vy = n[at + 7]!;
      const vz = n[at + 8]!;
      const hx = dy * vz - dz * vy;
      const hy = dz * vx - dx * vz;
      const hz = dx * vy - dy * vx;
      const det = ux * hx + uy * hy + uz * hz;
      if (det === 0) continue;
      const sx = x - n[at]!;
      const sy = y - n[at + 1]!;
      const sz = z - n[at + 2]!;
      const u = (sx * hx + sy * hy + sz * hz) / det;
      if (u < 0 || u > 1) continue;
      const qx = sy * uz - sz * uy;
      const qy = sz * ux - sx * uz;
      const qz = sx * uy - sy * ux;
      const v = (dx * qx + dy * qy + dz * qz) / det;
      if (v < 0 || u + v > 1) continue;
      const far = (vx * qx + vy * qy + vz * qz) / det;
      if (!(far > 0) || far > best + same) continue;
      // Of two sides of one sheet the front is met.
      if (found !== 0 && far > best - same && (found > 0 || det < 0)) continue;
      best = far;
      found = det < 0 ? -far : far;
      this.first = this.#firsts[at / numbersEach]!;
    }
    return found;
  }
}

/** Between a place that is seen and one that is covered. */
interface Edge {
  readonly share: number; // of the way to the covered one
  readonly value: number; // V there
}
type Edges = Map<number, Edge>;

const edgeKey = (seen: number, covered: number): number => 256 * seen + covered;

/** The mean of V over a small triangle of a lattice, 0 where it is covered. */
function meanBefore(found: Float32Array, edges: Edges, corners: Triple): number {
  const seen = corners.filter((k) => found[k]! > 0);
  const covered = corners.filter((k) => found[k] === 0);
  const at = (k: number) => found[k]!;
  const edge = (from: number, to: number) => edges.get(edgeKey(seen[from]!, covered[to]!))!;
  if (covered.length === 0) return seen.reduce((sum, k) => sum + at(k), 0) / 3;
  if (seen.length === 0) return 0;
  if (seen.length === 1) {
    const [left, right] = [edge(0, 0), edge(0, 1)];
    return (left.share * right.share * (at(seen[0]!) + left.value + right.value)) / 3;
  }
  const [left, right] = [edge(0, 0), edge(1, 0)];
  const [a, b] = [at(seen[0]!), at(seen[1]!)];
  const beside = right.share * (a + b + right.value);
  return (beside + left.share * (1 - right.share) * (a + left.value + right.value)) / 3;
}

/** Behind an edge V goes on as it came to it, so that what is drawn between the two is right where it is seen. */
function goOnBehind(found: Float32Array, edges: Edges): void {
  const sums = new Map<number, [sum: number, count: number]>();
  for (const [key, { share, value }] of edges) {
    const [seen, covered] = [key >> 8, key & 255];
    const [sum, count] = sums.get(covered) ?? [0, 0];
    const slope = (value - found[seen]!) / Math.max(steepest, share);
    sums.set(covered, [sum + found[seen]! + slope, count + 1]);
  }
  for (const [covered, [sum, count]] of sums) found[covered] = Math.min(1, Math.max(darkest, sum / count));
}

/**
 * Places that are covered take what is seen nearest to them, or are open: their darkness is not to be smeared over the
 * edge of what covers them, nor to show on a sliver beside it.
 */
function uncover(values: Float32Array, cells: number): void {
  const at = (i: number, j: number) => j * (cells + 1) - (j * (j - 1)) / 2 + i;
  for (let isDone = false; !isDone;) {
    const before = values.slice();
    isDone = true;
    for (let j = 0; j <= cells; j++)
      for (let i = 0; i <= cells - j; i++) {
        if (before[at(i, j)]! > 0) continue;
        let [sum, count] = [0, 0];
        for (const [di, dj] of beside) {
          const [p, q] = [i + di, j + dj];
          if (p < 0 || q < 0 || p + q > cells || before[at(p, q)]! === 0) continue;
          sum += before[at(p, q)]!;
          count++;
        }
        if (count === 0) continue;
        values[at(i, j)] = sum / count;
        isDone = false;
      }
  }
  values.forEach((value, k) => (values[k] = value || 1));
}

const beside = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
  [1, -1],
  [-1, 1],
] as const;

function faceOf(part: SolidPart, first: number): Face | null {
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

function pointOf({ corners: [a, b, c] }: Face, u: number, v: number): Triple {
  const w = 1 - u - v;
  return [w * a[0] + u * b[0] + v * c[0], w * a[1] + u * b[1] + v * c[1], w * a[2] + u * b[2] + v * c[2]];
}

/** As the surface is shaded; that of the triangle where the file's points elsewhere. */
function smoothNormal({ part, vertices, normal }: Face, u: number, v: number): Vec {
  const n: Triple = [0, 0, 0];
  [1 - u - v, u, v].forEach((share, corner) => {
    for (let axis = 0; axis < 3; axis++) n[axis]! += share * part.normals[3 * vertices[corner]! + axis]!;
  });
  const size = Math.hypot(...n);
  const along = (n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2]) / size;
  return along > 0.3 ? [n[0] / size, n[1] / size, n[2] / size] : normal;
}

function frameAbout([x, y, z]: Vec): [Vec, Vec] {
  const other: Vec = Math.abs(x) > 0.7 ? [0, 1, 0] : [1, 0, 0];
  const s = cross(other, [x, y, z]);
  const size = Math.hypot(...s);
  const unit: Vec = [s[0] / size, s[1] / size, s[2] / size];
  return [unit, cross([x, y, z], unit)];
}

/** All patches that the corners of a face blend. */
function patchesOf({ part: { patches, weights }, vertices }: Face): number[] {
  const found: number[] = [];
  for (const vertex of vertices)
    for (let k = 4 * vertex; k < 4 * vertex + 4; k++)
      if (weights[k]! > 0 && !found.includes(patches[k]!)) found.push(patches[k]!);
  return found;
}

/** The box of a triangle, stretched along a vector, and then wider by a margin on all sides. */
function boxAbout(corners: readonly Vec[], along: Vec, margin: number): [Vec, Vec] {
  const end = (sign: 1 | -1) =>
    [0, 1, 2].map((axis) => {
      const extreme = sign * Math.max(...corners.map((corner) => sign * corner[axis]!));
      const stretched = extreme + sign * Math.max(0, sign * along[axis]!);
      return stretched + sign * margin;
    }) as Triple;
  const [low, high] = [end(-1), end(1)];
  for (let axis = 0; axis < 3; axis++)
    if (low[axis]! > high[axis]!) low[axis] = high[axis] = (low[axis]! + high[axis]!) / 2;
  return [low, high];
}

const minus = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const distance = (a: Vec, b: Vec): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const cross = (a: Vec, b: Vec): Triple => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

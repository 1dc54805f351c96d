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
import {
  beside,
  cross,
  distance,
  faceOf,
  latticeSize,
  PatchMeans,
  placeAbove,
  placeOf,
  pointOf,
  smoothNormal,
  uncover,
  type Face,
  type Solids,
  type Triple,
  type Vec,
} from './lattice.ts';

export interface Openness {
  /** A part: two numbers a triangle: its first value, and the cells along an edge; none: V is 1 there, and shadows are those of its patches. */
  readonly tiles: readonly Uint32Array[];
  /** V x 255 at the lattice of each triangle, rows along its first edge, from its first corner to the third. */
  readonly values: Uint8Array;
  readonly covered: Uint8Array; // 1: a solid is there, and the value is that of a place beside it
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
const shadeCells = 3; // along an edge, where luminaires only cast a shadow (contact/shadows.ts)
const shading = 0.6; // m: shadows of what is further away are as wide as patches
const low = 0.05; // m: what is lower has no shadow
const upward = 0.5; // most light comes from above
const halvings = 4; // to where something begins to cover a surface
const steepest = 0.25; // of a cell: what V does in less is not continued
const darkest = 0.1; // V behind an edge
const around = 0.5; // of the light comes from all round; the rest from luminaires, whose shadows the patches know
const lit = 0.8; // how bright, for its reflectance, what is met is

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

/** Takes seconds in a furnished room. */
export function openness(solids: Solids): Openness {
  return new OpennessOfRoom(solids).run();
}

class OpennessOfRoom {
  readonly #solids: Solids;
  readonly #reach: number; // m
  readonly #least: number; // m2, of a triangle that is looked at: smaller ones have their patches' light
  readonly #means: PatchMeans;
  readonly #near = new NearTriangles();
  #values = new Uint8Array(1 << 16);
  #covered = new Uint8Array(1 << 16);
  #used = 0;

  constructor(solids: Solids) {
    this.#solids = solids;
    const { edge } = solids.room;
    this.#reach = Math.min(0.3, Math.max(0.15, 1.5 * edge));
    this.#least = (0.4 * edge) ** 2 / 2;
    this.#means = new PatchMeans(solids.room);
  }

  run(): Openness {
    const tiles = this.#solids.room.parts.map((part) => {
      const tile = new Uint32Array((2 * part.index.length) / 3);
      for (let t = 0; 3 * t < part.index.length; t++) {
        const face = faceOf(part, 3 * t);
        if (face) tile.set(this.#addTile(face), 2 * t);
      }
      return tile;
    });
    const [values, covered] = [this.#values, this.#covered].map((all) => all.slice(0, this.#used)) as [
      Uint8Array,
      Uint8Array,
    ];
    return { tiles, values, covered, means: this.#means.means(1) };
  }

  /** How finely a triangle is looked at; 0: nothing is before it. */
  #cellsOf(face: Face): number {
    const [a, b, c] = face.corners;
    const longest = Math.max(distance(a, b), distance(b, c), distance(c, a));
    if (face.area < this.#least) return 0;
    const above = face.normal.map((x) => touching * x) as Triple;
    const near = boxAbout(face.corners, above, -within);
    const isNear = this.#solids.tree.some(...near, (first) => this.#isBefore(face, first, 2 * lift));
    if (!isNear) return 0;
    this.#near.clear();
    this.#solids.tree.some(...boxAbout(face.corners, [0, 0, 0], this.#reach), (first) => {
      if (this.#isBefore(face, first, lift))
        this.#near.add(this.#solids.positions, this.#solids.index, first);
      return false;
    });
    return Math.min(mostCells, Math.max(1, Math.ceil(longest / (Math.SQRT2 * fine) - 0.01)));
  }

  /** Whether something stands beside a face that is seen from above, or over any. */
  #canBeShaded(face: Face): boolean {
    if (face.area < this.#least) return false;
    const [high, aside] = face.normal[1] > upward ? [0, shading] : [shading, -within];
    const box = boxAbout(face.corners, face.normal.map((x) => high * x) as Triple, aside);
    return this.#solids.tree.some(...box, (first) => this.#isBefore(face, first, low));
  }

  /** Whether a triangle rises above the plane of a face. */
  #isBefore({ corners, normal }: Face, first: number, height: number): boolean {
    for (let i = first; i < first + 3; i++) {
      const at = 3 * this.#solids.index[i]!;
      let above = 0;
      for (let axis = 0; axis < 3; axis++)
        above += normal[axis]! * (this.#solids.positions[at + axis]! - corners[0][axis]!);
      if (above > height) return true;
    }
    return false;
  }

  /** V at the lattice of a face, and its share in the means of the patches there; where it lies, and its cells. */
  #addTile(face: Face): [first: number, cells: number] {
    const begin = this.#used;
    const near = this.#cellsOf(face);
    const cells = near || (this.#canBeShaded(face) ? shadeCells : 0);
    const found = near > 0 ? this.#lattice(face, near) : this.#open(face, cells);
    const edges = this.#edges(face, found, cells);

    this.#means.add(face, cells, (corners) => [meanBefore(found, edges, corners), 1]);
    if (cells === 0) return [0, 0];

    const isCovered = found.map((value) => Number(value === 0));
    goOnBehind(found, edges);
    uncover(
      found,
      found.map((value) => Number(value === 0)),
      cells,
      1,
    );
    const count = found.length;
    if (begin + count > this.#values.length)
      [this.#values, this.#covered] = [twice(this.#values), twice(this.#covered)];
    for (let k = 0; k < count; k++) this.#values[begin + k] = Math.round(255 * found[k]!);
    this.#covered.set(isCovered, begin);
    this.#used += count;
    return [begin, cells];
  }

  /** V before which nothing ends: 0 for what lies wholly within a solid, else 1. */
  #open(face: Face, cells: number): Float32Array {
    return new Float32Array(latticeSize(Math.max(1, cells))).fill(this.#isWithin(face) ? 0 : 1);
  }

  /** V at a lattice of so many cells an edge. */
  #lattice(face: Face, cells: number): Float32Array {
    const found = new Float32Array(latticeSize(cells));
    let k = 0;
    for (let j = 0; j <= cells; j++)
      for (let i = 0; i <= cells - j; i++) found[k++] = this.#at(face, i / cells, j / cells);
    return found;
  }

  /** Where between neighbours of the lattice one is covered and the other is not. */
  #edges(face: Face, found: Float32Array, cells: number): Edges {
    const edges: Edges = new Map();
    for (let j = 0; j <= cells; j++)
      for (let i = 0; i <= cells - j; i++) {
        const seen = placeOf(cells, i, j);
        if (found[seen] === 0) continue;
        for (const [di, dj] of beside) {
          const [p, q] = [i + di, j + dj];
          if (p < 0 || q < 0 || p + q > cells || found[placeOf(cells, p, q)]! > 0) continue;
          const edge = this.#edgeBetween(face, [i / cells, j / cells], [p / cells, q / cells], found[seen]!);
          edges.set(edgeKey(seen, placeOf(cells, p, q)), edge);
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

  #at(face: Face, u: number, v: number): number {
    const { normal } = face;
    const [x, y, z] = placeAbove(face, u, v, lift);
    const tree = this.#solids.tree;
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
        const { reflectance } = this.#solids.room.parts[this.#solids.partOf[first / 3]!]!;
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
    const tree = this.#solids.tree;
    const [s, t] = frameAbout(normal);
    return lookouts.every(([a, b, c]) => {
      const [dx, dy, dz] = [0, 1, 2].map((axis) => a * s[axis]! + b * t[axis]! + c * normal[axis]!) as Triple;
      tree.reach(x, y, z, dx, dy, dz, true, Infinity);
      return tree.met >= 0 && tree.isBack;
    });
  }

  /** As NearTriangles.meet, by the tree. */
  #meet(x: number, y: number, z: number, dx: number, dy: number, dz: number): number {
    const far = this.#solids.tree.reach(x, y, z, dx, dy, dz, true, this.#reach);
    return this.#solids.tree.met < 0 ? 0 : this.#solids.tree.isBack ? -far : far;
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

function twice(values: Uint8Array): Uint8Array<ArrayBuffer> {
  const more = new Uint8Array(2 * values.length);
  more.set(values);
  return more;
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

function frameAbout([x, y, z]: Vec): [Vec, Vec] {
  const other: Vec = Math.abs(x) > 0.7 ? [0, 1, 0] : [1, 0, 0];
  const s = cross(other, [x, y, z]);
  const size = Math.hypot(...s);
  const unit: Vec = [s[0] / size, s[1] / size, s[2] / size];
  return [unit, cross([x, y, z], unit)];
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

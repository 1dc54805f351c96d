/**
 * A tree of boxes over the triangles of a mesh, so that the light under the pointer is found in microseconds: nodes
 * are split in the middle of their longest side until they hold few triangles.
 */

import { atOnce, type Pieces } from '../stage/breath.ts';

const leafSize = 8;
const many = 1000; // triangles: fewer are sorted in one piece
const boxSize = 9; // numbers
const deepest = 60; // levels
const same = 1e-5; // of two sides of one sheet the front is met
const tiny = 1e-12; // of a direction that has no part along an axis

export interface TreeHit {
  readonly distance: number; // along the ray, in lengths of its direction
  readonly first: number; // place of the triangle's first vertex in the index
}

type Vec = readonly [number, number, number];

export class TriangleTree {
  met = -1; // what ended the last `reach`: place of the triangle's first vertex in the index; -1: nothing
  isBack = false; // that triangle was met from behind
  #index: ArrayLike<number>;
  #positions: ArrayLike<number>; // xyz each
  #triangles: Uint32Array; // ordered by node
  #nodes = new Nodes();
  #stack = new Int32Array(deepest + 2);

  private constructor(index: ArrayLike<number>, positions: ArrayLike<number>) {
    this.#index = index;
    this.#positions = positions;
    this.#triangles = Uint32Array.from({ length: Math.floor(index.length / 3) }, (_, i) => i);
  }

  static of(index: ArrayLike<number>, positions: ArrayLike<number>): TriangleTree {
    return atOnce(TriangleTree.growing(index, positions));
  }

  static *growing(index: ArrayLike<number>, positions: ArrayLike<number>): Pieces<TriangleTree> {
    const tree = new TriangleTree(index, positions);
    const { length } = tree.#triangles;
    if (length === 0) return tree;
    const boxes = tree.#boxes();
    yield;
    yield* tree.#build(boxes, 0, length);
    return tree;
  }

  /** The nearest triangle that the ray meets, seen from its front unless `bothSides`; nearer than `limit`. */
  cast(origin: Vec, direction: Vec, bothSides = false, limit = Infinity): TreeHit | null {
    const [dx, dy, dz] = direction;
    const distance = this.reach(origin[0], origin[1], origin[2], dx, dy, dz, bothSides, limit);
    return this.met < 0 ? null : { distance, first: this.met };
  }

  /** As `cast`, for many rays: how far the ray from o along d comes, at most `limit`; see `met` and `isBack`. */
  reach(
    ox: number,
    oy: number,
    oz: number,
    dx: number,
    dy: number,
    dz: number,
    bothSides: boolean,
    limit: number,
    orAny = false, // whatever is met within the limit will do
  ): number {
    const stack = this.#stack;
    const { start, count } = this.#nodes;
    const [ix, iy, iz] = [1 / (dx || tiny), 1 / (dy || tiny), 1 / (dz || tiny)];
    let best = limit;
    let depth = 0;
    this.met = -1;
    if (count.length > 0) stack[depth++] = 0;
    while (depth > 0) {
      const node = stack[--depth]!;
      if (!this.#nodes.isMet(node, ox, oy, oz, ix, iy, iz, best)) continue;
      const held = count[node]!;
      if (held === 0) {
        stack[depth++] = start[node]!;
        stack[depth++] = node + 1;
        continue;
      }
      for (let i = start[node]!; i < start[node]! + held; i++) {
        const first = 3 * this.#triangles[i]!;
        const distance = this.#distance(first, ox, oy, oz, dx, dy, dz, bothSides);
        const far = Math.abs(distance);
        const isFurther = far > best - same && !(this.isBack && distance > 0 && far < best + same);
        if (this.met < 0 ? far >= best : isFurther) continue;
        best = far;
        this.met = first;
        this.isBack = distance < 0;
        if (orAny) return best;
      }
    }
    return best;
  }

  /** Whether a triangle, met from either side, is nearer along the ray from o than `limit` lengths of d. */
  isBlocked(ox: number, oy: number, oz: number, dx: number, dy: number, dz: number, limit: number): boolean {
    this.reach(ox, oy, oz, dx, dy, dz, true, limit, true);
    return this.met >= 0;
  }

  /** Visits the triangles whose boxes touch a box, until one answers true; whether one did. */
  some(low: Vec, high: Vec, visit: (first: number) => boolean): boolean {
    const { start, count } = this.#nodes;
    const stack = count.length > 0 ? [0] : [];
    while (stack.length > 0) {
      const node = stack.pop()!;
      if (!this.#nodes.touches(node, low, high)) continue;
      const held = count[node]!;
      if (held === 0) stack.push(start[node]!, node + 1);
      for (let i = start[node]!; i < start[node]! + held; i++) {
        const first = 3 * this.#triangles[i]!;
        if (this.#touches(first, low, high) && visit(first)) return true;
      }
    }
    return false;
  }

  /** Of every triangle: low xyz, high xyz, three times its centre. */
  #boxes(): Float64Array {
    const [index, p] = [this.#index, this.#positions];
    const boxes = new Float64Array(boxSize * this.#triangles.length);
    for (let triangle = 0, at = 0; triangle < this.#triangles.length; triangle++, at += boxSize) {
      const a = 3 * index[3 * triangle]!;
      const b = 3 * index[3 * triangle + 1]!;
      const c = 3 * index[3 * triangle + 2]!;
      for (let axis = 0; axis < 3; axis++) {
        const [x, y, z] = [p[a + axis]!, p[b + axis]!, p[c + axis]!];
        boxes[at + axis] = Math.min(x, y, z);
        boxes[at + 3 + axis] = Math.max(x, y, z);
        boxes[at + 6 + axis] = x + y + z;
      }
    }
    return boxes;
  }

  /** Makes the node of triangles begin..end and, after it, its children; returns the node. */
  *#build(boxes: Float64Array, begin: number, end: number, depth = 0): Pieces<number> {
    const node = this.#nodes.add(begin, end - begin);
    const [axis, split] = this.#nodes.enclose(node, boxes, this.#triangles, begin, end);
    if (end - begin <= leafSize || depth >= deepest) return node;
    if (end - begin > many) yield;
    const middle = this.#partition(boxes, axis, split, begin, end);
    if (middle === begin || middle === end) return node; // all in one place
    if (end - begin > many) yield;
    yield* this.#build(boxes, begin, middle, depth + 1);
    this.#nodes.start[node] = yield* this.#build(boxes, middle, end, depth + 1);
    this.#nodes.count[node] = 0;
    return node;
  }

  #partition(boxes: Float64Array, axis: number, split: number, begin: number, end: number): number {
    let [i, j] = [begin, end];
    while (i < j) {
      const triangle = this.#triangles[i]!;
      if (boxes[boxSize * triangle + 6 + axis]! < split) {
        i++;
        continue;
      }
      j--;
      this.#triangles[i] = this.#triangles[j]!;
      this.#triangles[j] = triangle;
    }
    return i;
  }

  #touches(first: number, low: Vec, high: Vec): boolean {
    const p = this.#positions;
    const a = 3 * this.#index[first]!;
    const b = 3 * this.#index[first + 1]!;
    const c = 3 * this.#index[first + 2]!;
    for (let axis = 0; axis < 3; axis++) {
      if (Math.min(p[a + axis]!, p[b + axis]!, p[c + axis]!) > high[axis]!) return false;
      if (Math.max(p[a + axis]!, p[b + axis]!, p[c + axis]!) < low[axis]!) return false;
    }
    return true;
  }

  /** Where the ray meets a triangle (Moeller and Trumbore), negative from behind, or Infinity. */
  #distance(
    first: number,
    ox: number,
    oy: number,
    oz: number,
    dx: number,
    dy: number,
    dz: number,
    bothSides: boolean,
  ): number {
    const p = this.#positions;
    const a = 3 * this.#index[first]!;
    const b = 3 * this.#index[first + 1]!;
    const c = 3 * this.#index[first + 2]!;
    const [ax, ay, az] = [p[a]!, p[a + 1]!, p[a + 2]!];
    const [ux, uy, uz] = [p[b]! - ax, p[b + 1]! - ay, p[b + 2]! - az];
    const [vx, vy, vz] = [p[c]! - ax, p[c + 1]! - ay, p[c + 2]! - az];
    const [hx, hy, hz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
    const det = ux * hx + uy * hy + uz * hz; // > 0: seen from the front
    if (bothSides ? det === 0 : det <= 0) return Infinity;
    const [sx, sy, sz] = [ox - ax, oy - ay, oz - az];
    const u = (sx * hx + sy * hy + sz * hz) / det;
    if (u < 0 || u > 1) return Infinity;
    const [qx, qy, qz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
    const v = (dx * qx + dy * qy + dz * qz) / det;
    if (v < 0 || u + v > 1) return Infinity;
    const distance = (vx * qx + vy * qy + vz * qz) / det;
    if (!(distance > 0)) return Infinity;
    return det < 0 ? -distance : distance;
  }
}

/** The boxes of the tree, one after the other. */
class Nodes {
  readonly start: number[] = []; // leaf: first of the triangles; inner: the second child (the first one follows its parent)
  readonly count: number[] = []; // leaf: triangles; inner: 0
  readonly #bounds: number[] = []; // six a node: low xyz, high xyz
  readonly #all = new Float64Array(6); // least and most of the centres; xyz each

  add(start: number, count: number): number {
    this.start.push(start);
    return this.count.push(count) - 1;
  }

  /** Sets the box of a node to that of some triangles; along which axis their centres lie, and three times the middle of it. */
  enclose(node: number, boxes: Float64Array, triangles: Uint32Array, begin: number, end: number) {
    const all = this.#all;
    // note: plain numbers, for this runs before the browser has compiled it well.
    for (let axis = 0; axis < 3; axis++) {
      let [low, high, least, most] = [Infinity, -Infinity, Infinity, -Infinity];
      for (let i = begin; i < end; i++) {
        const at = boxSize * triangles[i]! + axis;
        const center = boxes[at + 6]!;
        if (boxes[at]! < low) low = boxes[at]!;
        if (boxes[at + 3]! > high) high = boxes[at + 3]!;
        if (center < least) least = center;
        if (center > most) most = center;
      }
      this.#bounds[6 * node + axis] = low;
      this.#bounds[6 * node + 3 + axis] = high;
      all[axis] = least;
      all[3 + axis] = most;
    }
    const size = (axis: number) => all[3 + axis]! - all[axis]!;
    const wide = size(1) > size(0) ? 1 : 0;
    const axis = size(2) > size(wide) ? 2 : wide;
    return [axis, (all[axis]! + all[3 + axis]!) / 2] as const;
  }

  touches(node: number, low: Vec, high: Vec): boolean {
    const bounds = this.#bounds;
    for (let axis = 0; axis < 3; axis++)
      if (bounds[6 * node + axis]! > high[axis]! || bounds[6 * node + 3 + axis]! < low[axis]!) return false;
    return true;
  }

  /** By slabs; i = 1 / direction. */
  isMet(
    node: number,
    ox: number,
    oy: number,
    oz: number,
    ix: number,
    iy: number,
    iz: number,
    limit: number,
  ): boolean {
    const bounds = this.#bounds;
    const at = 6 * node;
    const [ax, bx] = [(bounds[at]! - ox) * ix, (bounds[at + 3]! - ox) * ix];
    const [ay, by] = [(bounds[at + 1]! - oy) * iy, (bounds[at + 4]! - oy) * iy];
    const [az, bz] = [(bounds[at + 2]! - oz) * iz, (bounds[at + 5]! - oz) * iz];
    const near = Math.max(0, Math.min(ax, bx), Math.min(ay, by), Math.min(az, bz));
    const far = Math.min(limit, Math.max(ax, bx), Math.max(ay, by), Math.max(az, bz));
    return near <= far + 1e-6;
  }
}

/**
 * A tree of boxes over the triangles of a mesh, so that the light under the pointer is found in microseconds: nodes
 * are split in the middle of their longest side until they hold few triangles.
 */

const leafSize = 8;

export interface TreeHit {
  readonly distance: number; // along the ray, in lengths of its direction
  readonly first: number; // place of the triangle's first vertex in the index
}

type Vec = readonly [number, number, number];

export class TriangleTree {
  #index: ArrayLike<number>;
  #positions: ArrayLike<number>; // xyz each
  #triangles: Uint32Array; // ordered by node
  #bounds: number[] = []; // six a node: low xyz, high xyz
  #start: number[] = []; // leaf: first of `triangles`; inner: the second child (the first one follows its parent)
  #count: number[] = []; // leaf: triangles; inner: 0

  constructor(index: ArrayLike<number>, positions: ArrayLike<number>) {
    this.#index = index;
    this.#positions = positions;
    this.#triangles = Uint32Array.from({ length: Math.floor(index.length / 3) }, (_, i) => i);
    const centers = this.#centers();
    if (this.#triangles.length > 0) this.#build(centers, 0, this.#triangles.length);
  }

  /** The nearest triangle that the ray meets, seen from its front unless `bothSides`; nearer than `limit`. */
  cast(origin: Vec, direction: Vec, bothSides = false, limit = Infinity): TreeHit | null {
    let best: TreeHit | null = null;
    const stack = this.#count.length > 0 ? [0] : [];
    while (stack.length > 0) {
      const node = stack.pop()!;
      if (!this.#meets(node, origin, direction, best?.distance ?? limit)) continue;
      const count = this.#count[node]!;
      const start = this.#start[node]!;
      if (count === 0) {
        stack.push(start, node + 1);
        continue;
      }
      for (let i = start; i < start + count; i++) {
        const first = 3 * this.#triangles[i]!;
        const distance = this.#distance(first, origin, direction, bothSides);
        if (distance < (best?.distance ?? limit)) best = { distance, first };
      }
    }
    return best;
  }

  #centers(): Float32Array {
    const centers = new Float32Array(this.#index.length);
    for (let corner = 0; corner < 3 * this.#triangles.length; corner++)
      for (let axis = 0; axis < 3; axis++)
        centers[corner - (corner % 3) + axis]! += this.#positions[3 * this.#index[corner]! + axis]! / 3;
    return centers;
  }

  /** Makes the node of triangles begin..end and, after it, its children. */
  #build(centers: Float32Array, begin: number, end: number): number {
    const node = this.#count.length;
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    const [from, to] = [[...low], [...high]]; // of the centers
    for (let i = begin; i < end; i++) {
      const first = 3 * this.#triangles[i]!;
      for (let axis = 0; axis < 3; axis++) {
        const center = centers[first + axis]!;
        from[axis] = Math.min(from[axis]!, center);
        to[axis] = Math.max(to[axis]!, center);
        for (let corner = first; corner < first + 3; corner++) {
          const value = this.#positions[3 * this.#index[corner]! + axis]!;
          low[axis] = Math.min(low[axis]!, value);
          high[axis] = Math.max(high[axis]!, value);
        }
      }
    }
    this.#bounds.push(...low, ...high);
    this.#start.push(begin);
    this.#count.push(end - begin);
    if (end - begin <= leafSize) return node;
    const sizes = to.map((value, axis) => value - from[axis]!);
    const axis = sizes.indexOf(Math.max(...sizes));
    const middle = this.#partition(centers, axis, (from[axis]! + to[axis]!) / 2, begin, end);
    if (middle === begin || middle === end) return node; // all in one place
    this.#build(centers, begin, middle);
    this.#start[node] = this.#build(centers, middle, end);
    this.#count[node] = 0;
    return node;
  }

  #partition(centers: Float32Array, axis: number, split: number, begin: number, end: number): number {
    let [i, j] = [begin, end];
    while (i < j) {
      const triangle = this.#triangles[i]!;
      if (centers[3 * triangle + axis]! < split) {
        i++;
        continue;
      }
      j--;
      this.#triangles[i] = this.#triangles[j]!;
      this.#triangles[j] = triangle;
    }
    return i;
  }

  #meets(node: number, origin: Vec, direction: Vec, limit: number): boolean {
    let [near, far] = [0, limit];
    for (let axis = 0; axis < 3; axis++) {
      const inverse = 1 / direction[axis]!;
      const low = this.#bounds[6 * node + axis]! - origin[axis]!;
      const high = this.#bounds[6 * node + 3 + axis]! - origin[axis]!;
      if (!Number.isFinite(inverse)) {
        if (low > 0 || high < 0) return false;
        continue;
      }
      near = Math.max(near, Math.min(low * inverse, high * inverse));
      far = Math.min(far, Math.max(low * inverse, high * inverse));
    }
    return near <= far + 1e-6;
  }

  /** Where the ray meets a triangle (Moeller and Trumbore), or Infinity. */
  #distance(first: number, origin: Vec, direction: Vec, bothSides: boolean): number {
    const p = this.#positions;
    const [a, b, c] = [3 * this.#index[first]!, 3 * this.#index[first + 1]!, 3 * this.#index[first + 2]!];
    const [ux, uy, uz] = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!];
    const [vx, vy, vz] = [p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!];
    const [dx, dy, dz] = direction;
    const [hx, hy, hz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
    const det = ux * hx + uy * hy + uz * hz; // > 0: seen from the front
    if (bothSides ? det === 0 : det <= 0) return Infinity;
    const [sx, sy, sz] = [origin[0] - p[a]!, origin[1] - p[a + 1]!, origin[2] - p[a + 2]!];
    const u = (sx * hx + sy * hy + sz * hz) / det;
    if (u < 0 || u > 1) return Infinity;
    const [qx, qy, qz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
    const v = (dx * qx + dy * qy + dz * qz) / det;
    if (v < 0 || u + v > 1) return Infinity;
    const distance = (vx * qx + vy * qy + vz * qz) / det;
    return distance > 0 ? distance : Infinity;
  }
}

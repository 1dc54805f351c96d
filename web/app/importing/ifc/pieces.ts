/** Triangles of one material in metres, y upwards, and what of them lies in a box: cut off at its sides. */

export type Vec = readonly [number, number, number];

export interface Box {
  readonly min: Vec;
  readonly max: Vec;
}

export interface Mesh {
  readonly positions: Float32Array<ArrayBuffer>;
  readonly indices: Uint32Array<ArrayBuffer>;
}

export const everywhere: Box = {
  min: [-Infinity, -Infinity, -Infinity],
  max: [Infinity, Infinity, Infinity],
};

/** Of nothing: turned inside out. */
export function boxOf(meshes: readonly Mesh[]): Box {
  const [min, max] = [[...everywhere.max], [...everywhere.min]];
  for (const { positions } of meshes)
    positions.forEach((value, i) => {
      min[i % 3] = Math.min(min[i % 3]!, value);
      max[i % 3] = Math.max(max[i % 3]!, value);
    });
  return { min: min as unknown as Vec, max: max as unknown as Vec };
}

export const meets = (one: Box, other: Box): boolean =>
  [0, 1, 2].every((axis) => one.min[axis]! < other.max[axis]! && other.min[axis]! < one.max[axis]!);

/** The part of a mesh in a box; null where there is none. */
export function within({ positions, indices }: Mesh, box: Box): Mesh | null {
  const points: number[] = [];
  const corners: number[] = [];
  const taken = new Map<number, number>(); // vertices that are kept as they are
  const at = (vertex: number): Vec => [
    positions[3 * vertex]!,
    positions[3 * vertex + 1]!,
    positions[3 * vertex + 2]!,
  ];
  const add = (point: Vec) => points.push(...point) / 3 - 1;
  const keep = (vertex: number) => {
    const index = taken.get(vertex) ?? add(at(vertex));
    taken.set(vertex, index);
    return index;
  };
  const isIn = (point: Vec) =>
    point.every((value, axis) => value >= box.min[axis]! && value <= box.max[axis]!);
  for (let first = 0; first < indices.length; first += 3) {
    const own = [indices[first]!, indices[first + 1]!, indices[first + 2]!];
    const triangle = own.map(at);
    if (triangle.every(isIn)) {
      corners.push(...own.map(keep));
      continue;
    }
    const [start, ...fan] = clipped(triangle, box).map(add);
    for (let i = 1; i < fan.length; i++) corners.push(start!, fan[i - 1]!, fan[i]!);
  }
  return corners.length > 0
    ? { positions: Float32Array.from(points), indices: Uint32Array.from(corners) }
    : null;
}

/** A convex polygon cut at the six sides of a box (Sutherland and Hodgman 1974); fewer than three points: nothing is left. */
function clipped(polygon: readonly Vec[], { min, max }: Box): readonly Vec[] {
  let left = polygon;
  for (const axis of [0, 1, 2])
    for (const [side, sign] of [
      [min[axis]!, 1],
      [max[axis]!, -1],
    ] as const)
      left = cut(left, (point) => sign * (point[axis]! - side));
  return left.length < 3 ? [] : left;
}

/** What of a polygon lies where `depth` is not negative. */
function cut(polygon: readonly Vec[], depth: (point: Vec) => number): readonly Vec[] {
  const result: Vec[] = [];
  polygon.forEach((point, i) => {
    const before = polygon.at(i - 1)!;
    const [from, to] = [depth(before), depth(point)];
    if (from < 0 !== to < 0) {
      const share = from / (from - to);
      const mixed = (axis: 0 | 1 | 2) => before[axis] + share * (point[axis] - before[axis]);
      result.push([mixed(0), mixed(1), mixed(2)]);
    }
    if (to >= 0) result.push(point);
  });
  return result;
}

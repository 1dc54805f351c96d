/**
 * Where numbers stand on a measuring plane: readings on a coarse grid, and the names of isolux lines on the lines
 * themselves. Pure; in metres and lux.
 */

/** The patches of one measuring plane. */
export interface Plane {
  readonly patches: readonly number[]; // rows of the scene
  readonly center: Float32Array; // 3 a row of the scene, m
  readonly area: Float32Array; // a row of the scene, m2
}

export interface Reading {
  readonly point: readonly [number, number, number]; // m
  readonly value: number; // lx
}

const pointOf = ({ center }: Plane, patch: number): [number, number, number] => [
  center[3 * patch]!,
  center[3 * patch + 1]!,
  center[3 * patch + 2]!,
];

/** One patch for each square of `step` metres of the plane: the one nearest to the square's middle. */
export function gridPatches(plane: Plane, step: number): number[] {
  const points = plane.patches.map((patch) => pointOf(plane, patch));
  const low = [0, 1, 2].map((axis) => Math.min(...points.map((point) => point[axis]!)));
  const nearest = new Map<string, { patch: number; distance: number }>();
  points.forEach((point, i) => {
    const cell = point.map((value, axis) => Math.floor((value - low[axis]!) / step + 1e-6));
    const distance = Math.hypot(
      ...point.map((value, axis) => (value - low[axis]!) / step - cell[axis]! - 0.5),
    );
    const key = cell.join(' ');
    const known = nearest.get(key);
    if (!known || distance < known.distance - 1e-6) nearest.set(key, { patch: plane.patches[i]!, distance });
  });
  return [...nearest.values()].map(({ patch }) => patch);
}

/** Pairs of patches that lie beside each other. */
export function neighbours(plane: Plane): [number, number][] {
  const edge = Math.sqrt(Math.max(...plane.patches.map((patch) => plane.area[patch]!)));
  const cells = new Map<string, number[]>();
  const cellOf = (point: readonly number[]) => point.map((value) => Math.floor(value / (1.3 * edge)));
  for (const patch of plane.patches) {
    const key = cellOf(pointOf(plane, patch)).join(' ');
    cells.set(key, [...(cells.get(key) ?? []), patch]);
  }
  const pairs: [number, number][] = [];
  for (const patch of plane.patches) {
    const here = pointOf(plane, patch);
    const [x, y, z] = cellOf(here) as [number, number, number];
    for (const dx of [-1, 0, 1])
      for (const dy of [-1, 0, 1])
        for (const dz of [-1, 0, 1])
          for (const other of cells.get(`${x + dx} ${y + dy} ${z + dz}`) ?? []) {
            const there = pointOf(plane, other);
            if (other > patch && Math.hypot(...here.map((v, i) => v - there[i]!)) < 1.3 * edge)
              pairs.push([patch, other]);
          }
  }
  return pairs;
}

/** Where lines of equal light pass between neighbours, at the levels that do. */
export function crossings(
  plane: Plane,
  pairs: readonly (readonly [number, number])[],
  light: ArrayLike<number>,
  levels: readonly number[],
): Reading[] {
  const found: Reading[] = [];
  for (const [a, b] of pairs) {
    const [low, high] = [light[a]!, light[b]!];
    for (const level of levels) {
      if (low < level === high < level) continue;
      const share = (level - low) / (high - low);
      const [from, to] = [pointOf(plane, a), pointOf(plane, b)];
      const at = (axis: 0 | 1 | 2) => from[axis] + share * (to[axis] - from[axis]);
      found.push({ point: [at(0), at(1), at(2)], value: level });
    }
  }
  return found;
}

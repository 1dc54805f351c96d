/** Connected parts of a triangle mesh: what touches at a vertex hangs together. Vertices within 0.1 mm are one. */

import { weldVertices } from './weld.ts';
import type { Pieces } from '../stage/breath.ts';

const weld = 1e-4; // m

/** Triangles (first index of each in `index`) of every connected part. */
export function* connectedParts(index: ArrayLike<number>, positions: ArrayLike<number>): Pieces<number[][]> {
  const vertices = yield* weldVertices(positions, weld);
  // Union-find with path halving.
  const parent = Int32Array.from(vertices.keys());
  const find = (v: number): number => {
    while (parent[v] !== v) v = parent[v] = parent[parent[v]!]!;
    return v;
  };
  const root = (corner: number) => find(vertices[index[corner]!]!);
  for (let i = 0; i + 2 < index.length; i += 3)
    for (const corner of [i + 1, i + 2]) parent[root(corner)] = root(i);
  const parts = new Map<number, number[]>();
  for (let i = 0; i + 2 < index.length; i += 3) {
    const part = parts.get(root(i));
    if (part) part.push(i);
    else parts.set(root(i), [i]);
  }
  return [...parts.values()];
}

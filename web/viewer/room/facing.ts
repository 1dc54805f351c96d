/** Which way a room's surfaces face, and so from which corner they are seen: an eye in front of them, not behind. */
import { Vector3 } from 'three';
import type { LitMesh } from './room-mesh.ts';

/** Of each leaf surface, the share of its area that faces an eye at azimuth 45, 135, 225 and 315 degrees. */
export type Facing = ReadonlyMap<number, readonly [number, number, number, number]>;

export function facingOf(lit: readonly LitMesh[]): Facing {
  const sums = new Map<number, [number, number, number, number, number]>();
  const [a, b, c, normal] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  for (const { mesh, surface, measuring } of lit) {
    const index = mesh.geometry.index;
    if (measuring || !index) continue;
    const sum = sums.get(surface) ?? [0, 0, 0, 0, 0];
    sums.set(surface, sum);
    const position = mesh.geometry.getAttribute('position');
    for (let i = 0; i + 2 < index.count; i += 3) {
      a.fromBufferAttribute(position, index.getX(i));
      b.fromBufferAttribute(position, index.getX(i + 1)).sub(a);
      c.fromBufferAttribute(position, index.getX(i + 2)).sub(a);
      normal.crossVectors(b, c).transformDirection(mesh.matrixWorld);
      const area = b.cross(c).length();
      if (!(area > 0)) continue;
      sum[4] += area;
      if (normal.x + normal.z > 0.1) sum[0] += area;
      if (normal.x - normal.z > 0.1) sum[1] += area;
      if (-normal.x - normal.z > 0.1) sum[2] += area;
      if (normal.z - normal.x > 0.1) sum[3] += area;
    }
  }
  return new Map(
    [...sums].map(([surface, [p, q, r, s, area]]) => {
      const share = (part: number) => (area > 0 ? part / area : 0);
      return [surface, [share(p), share(q), share(r), share(s)]];
    }),
  );
}

/** How much an eye in each quadrant sees: every surface counts 1, those in `aims` as much as all the others together. */
export function quadrantShares(facing: Facing, aims: readonly number[]): number[] {
  const shares = [0, 0, 0, 0];
  for (const [surface, own] of facing)
    own.forEach((share, q) => (shares[q]! += share * (aims.includes(surface) ? facing.size : 1)));
  return shares;
}

/**
 * The quadrant from which upright surfaces are seen, or null where they are seen already: an eye in `present` looks at
 * their fronts, or they are level.
 */
export function betterQuadrant(facing: Facing, surfaces: readonly number[], present: number): number | null {
  const seen = [0, 0, 0, 0];
  for (const surface of surfaces)
    facing.get(surface)?.forEach((share, q) => (seen[q]! += share / surfaces.length));
  const most = Math.max(...seen);
  if (most < 0.25 || seen[present]! > 0.5 * most) return null;
  return seen.indexOf(most);
}

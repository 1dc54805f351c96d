/** Which way a room's surfaces face, and so from which corner they are seen: an eye in front of them, not behind. */
import { Vector3 } from 'three';
import type { Destination, EyePlace } from '../eye/framing.ts';
import type { LitMesh } from './room-mesh.ts';
import type { Pieces } from '../stage/breath.ts';

/** Of a leaf surface, the shares of its area that face an eye at azimuth 45, 135, 225 and 315 degrees, and that look down. */
type Shares = readonly [number, number, number, number, number];
export type Facing = ReadonlyMap<number, Shares>;

export function* facingOf(lit: readonly LitMesh[]): Pieces<Facing> {
  const sums = new Map<number, [number, number, number, number, number, number]>();
  const [a, b, c, normal] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  for (const { mesh, surface, measuring } of lit) {
    const index = mesh.geometry.index;
    if (measuring || !index) continue;
    const sum = sums.get(surface) ?? [0, 0, 0, 0, 0, 0];
    sums.set(surface, sum);
    const position = mesh.geometry.getAttribute('position');
    for (let i = 0; i + 2 < index.count; i += 3) {
      a.fromBufferAttribute(position, index.getX(i));
      b.fromBufferAttribute(position, index.getX(i + 1)).sub(a);
      c.fromBufferAttribute(position, index.getX(i + 2)).sub(a);
      normal.crossVectors(b, c).transformDirection(mesh.matrixWorld);
      const area = b.cross(c).length();
      if (!(area > 0)) continue;
      sum[5] += area;
      if (normal.y < -0.7) sum[4] += area;
      if (normal.x + normal.z > 0.1) sum[0] += area;
      if (normal.x - normal.z > 0.1) sum[1] += area;
      if (-normal.x - normal.z > 0.1) sum[2] += area;
      if (normal.z - normal.x > 0.1) sum[3] += area;
    }
    yield;
  }
  return new Map(
    [...sums].map(([surface, [p, q, r, s, down, area]]) => {
      const share = (part: number) => (area > 0 ? part / area : 0);
      return [surface, [share(p), share(q), share(r), share(s), share(down)]];
    }),
  );
}

/** How much an eye in each quadrant sees: every surface counts 1, those in `aims` as much as all the others together. */
export function quadrantShares(facing: Facing, aims: readonly number[]): number[] {
  const shares = [0, 0, 0, 0];
  for (const [surface, own] of facing)
    for (let q = 0; q < 4; q++) shares[q]! += own[q]! * (aims.includes(surface) ? facing.size : 1);
  return shares;
}

/**
 * From where surfaces are seen: the quadrant of an eye before the fronts of upright ones, within the room for what looks
 * down, the whole room for what is level; null where they are seen already.
 */
export function betterPlace(
  facing: Facing,
  surfaces: readonly number[],
  { quadrant, isAbove, looksUp }: EyePlace,
): Destination | null {
  const seen = [0, 0, 0, 0, 0];
  for (const surface of surfaces)
    facing.get(surface)?.forEach((share, i) => (seen[i]! += share / surfaces.length));
  const down = seen.pop()!;
  if (down > 0.5) return isAbove ? 'within' : null;
  const most = Math.max(...seen);
  if (most < 0.25) return looksUp && surfaces.length > 0 ? 'home' : null;
  if (seen[quadrant]! <= 0.5 * most) return seen.indexOf(most);
  return looksUp ? quadrant : null;
}

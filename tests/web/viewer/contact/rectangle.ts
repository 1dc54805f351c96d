/** Made solids for the light near contacts. */
import type { SolidPart } from '../../../../web/viewer/contact/lattice.ts';

type Vec = readonly [number, number, number];

/** A rectangle as two triangles, lit by one patch. */
export function rectangle([corner, along, across]: readonly [Vec, Vec, Vec], patch: number): SolidPart {
  const at = (u: number, v: number) => corner.map((x, axis) => x + u * along[axis]! + v * across[axis]!);
  const [a, b] = [along, across];
  const normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const size = Math.hypot(...normal);
  return {
    index: Uint32Array.of(0, 1, 2, 3, 2, 1),
    positions: Float32Array.from([at(0, 0), at(1, 0), at(0, 1), at(1, 1)].flat()),
    normals: Float32Array.from({ length: 12 }, (_, i) => normal[i % 3]! / size),
    patches: Float32Array.from({ length: 16 }, () => patch),
    weights: Float32Array.from({ length: 16 }, (_, i) => Number(i % 4 === 0)),
    reflectance: 0,
  };
}

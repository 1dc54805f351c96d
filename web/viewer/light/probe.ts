/** The light under the pointer: what the shader interpolates, computed on the page for one point. */

/**
 * Light at a vertex: the weighted mean of up to four patches, lx, or lm/m2 where their reflectances are given.
 * `patches` and `weights` hold four entries a vertex.
 */
export function lightAtVertex(
  vertex: number,
  patches: ArrayLike<number>,
  weights: ArrayLike<number>,
  light: ArrayLike<number>,
  reflectance?: ArrayLike<number>,
): number {
  let sum = 0;
  let total = 0;
  for (let i = 4 * vertex; i < 4 * vertex + 4; i++) {
    const weight = weights[i]!;
    if (weight === 0) continue;
    const patch = Math.round(patches[i]!);
    sum += weight * (light[patch] ?? 0) * (reflectance ? (reflectance[patch] ?? 0) : 1);
    total += weight;
  }
  return total > 0 ? sum / total : 0;
}

/** Barycentric coordinates of a point (in the triangle's plane) from three corners, xyz each. */
export function barycentric(
  point: readonly number[],
  a: readonly number[],
  b: readonly number[],
  c: readonly number[],
): [number, number, number] {
  const minus = (p: readonly number[], q: readonly number[]) => p.map((value, i) => value - q[i]!);
  const dot = (p: readonly number[], q: readonly number[]) =>
    p.reduce((sum, value, i) => sum + value * q[i]!, 0);
  const [u, v, w] = [minus(b, a), minus(c, a), minus(point, a)];
  const [uu, uv, vv, wu, wv] = [dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v)];
  const area = uu * vv - uv * uv;
  if (!(area > 0)) return [1, 0, 0];
  const beta = (vv * wu - uv * wv) / area;
  const gamma = (uu * wv - uv * wu) / area;
  return [1 - beta - gamma, beta, gamma];
}

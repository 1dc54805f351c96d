/** Places in a grid of 0.6 m, 0.3 m from the walls: line by line along x, as files keep them. */
import type { SceneInfo } from '../../web/document/types.ts';

export function ceilingOf(columns: number, rows: number): SceneInfo['sites'] {
  const places = Array.from({ length: columns * rows }, (_, site) => [
    0.3 + 0.6 * (site % columns),
    2.8,
    0.3 + 0.6 * Math.floor(site / columns),
  ]);
  const each = (vector: readonly number[]) => new Float32Array(places.flatMap(() => vector));
  return {
    position: new Float32Array(places.flat()),
    normal: each([0, -1, 0]),
    axis: each([1, 0, 0]),
    size: each([0.6]),
  };
}

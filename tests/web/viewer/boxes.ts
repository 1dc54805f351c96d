// Meshes of axis-aligned boxes.
import { BoxGeometry } from 'three';
import type { Box } from '../../../web/viewer/eye/framing.ts';

/** Index and positions of several axis-aligned boxes in one mesh. */
export function boxes(...list: readonly Box[]) {
  const index: number[] = [];
  const positions: number[] = [];
  for (const { min, max } of list) {
    const size = max.map((high, i) => high - min[i]!) as [number, number, number];
    const box = new BoxGeometry(...size);
    box.translate((min[0] + max[0]) / 2, (min[1] + max[1]) / 2, (min[2] + max[2]) / 2);
    index.push(...[...box.index!.array].map((vertex) => vertex + positions.length / 3));
    positions.push(...box.getAttribute('position').array);
  }
  return { index, positions };
}

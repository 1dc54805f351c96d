/** Vertices at one place as one, by integer keys: a mesh of many thousand must not stop the picture. */

import type { Pieces } from '../stage/breath.ts';

const portion = 8192; // vertices that are looked at in one piece

/** The first vertex at the place of each, places being cells of `size` m. Positions xyz each, m. */
export function* weldVertices(positions: ArrayLike<number>, size: number): Pieces<Uint32Array> {
  const count = positions.length / 3;
  const capacity = 1 << Math.max(4, Math.ceil(Math.log2(2 * count)));
  const slots = new Int32Array(capacity).fill(-1); // open addressing: the first vertex of each place
  const welded = new Uint32Array(count);
  const cells = new Int32Array(3 * count);
  for (let i = 0; i < cells.length; i++) cells[i] = Math.round(positions[i]! / size);
  for (let v = 0; v < count; v++) {
    if (v % portion === 0) yield;
    const x = cells[3 * v]!;
    const y = cells[3 * v + 1]!;
    const z = cells[3 * v + 2]!;
    let slot = (Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791)) & (capacity - 1);
    for (;;) {
      const other = slots[slot]!;
      if (other < 0) {
        slots[slot] = v;
        welded[v] = v;
        break;
      }
      if (cells[3 * other] === x && cells[3 * other + 1] === y && cells[3 * other + 2] === z) {
        welded[v] = other;
        break;
      }
      slot = (slot + 1) & (capacity - 1);
    }
  }
  return welded;
}

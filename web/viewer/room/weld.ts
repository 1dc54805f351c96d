/** Vertices at one place as one, by integer keys: a mesh of many thousand must not stop the picture. */

/** The first vertex at the place of each, places being cells of `size` m. Positions xyz each, m. */
export function weldVertices(positions: ArrayLike<number>, size: number): Uint32Array {
  const count = positions.length / 3;
  const capacity = 1 << Math.max(4, Math.ceil(Math.log2(2 * count)));
  const slots = new Int32Array(capacity).fill(-1); // open addressing: the first vertex of each place
  const welded = new Uint32Array(count);
  const cell = (v: number, axis: number) => Math.round(positions[3 * v + axis]! / size);
  for (let v = 0; v < count; v++) {
    const [x, y, z] = [cell(v, 0), cell(v, 1), cell(v, 2)];
    let slot = (Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791)) & (capacity - 1);
    for (;;) {
      const other = slots[slot]!;
      if (other < 0) {
        slots[slot] = v;
        welded[v] = v;
        break;
      }
      if (cell(other, 0) === x && cell(other, 1) === y && cell(other, 2) === z) {
        welded[v] = other;
        break;
      }
      slot = (slot + 1) & (capacity - 1);
    }
  }
  return welded;
}

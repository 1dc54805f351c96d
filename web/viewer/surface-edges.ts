/**
 * Edges of a surface's mesh: where it ends, and where it bends by more than a crease angle. The same as three's
 * EdgesGeometry, but with integer keys, so that a wall of many thousand triangles does not stop the picture.
 */

const weld = 2e3; // 1 / m: vertices within half a millimetre are one

/** Numbers welded vertices 0, 1, ... Positions xyz each, m. */
function weldVertices(positions: ArrayLike<number>): Uint32Array {
  const count = positions.length / 3;
  const size = 1 << Math.max(4, Math.ceil(Math.log2(2 * count)));
  const slots = new Int32Array(size).fill(-1); // open addressing: the first vertex of each place
  const welded = new Uint32Array(count);
  const cell = (v: number, axis: number) => Math.round(positions[3 * v + axis]! * weld);
  for (let v = 0; v < count; v++) {
    const [x, y, z] = [cell(v, 0), cell(v, 1), cell(v, 2)];
    let slot = (Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791)) & (size - 1);
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
      slot = (slot + 1) & (size - 1);
    }
  }
  return welded;
}

/** Unit normal of a triangle, or null where it has no area. */
function normalOf(
  positions: ArrayLike<number>,
  a: number,
  b: number,
  c: number,
): [number, number, number] | null {
  const at = (v: number, axis: number) => positions[3 * v + axis]!;
  const [ux, uy, uz] = [at(b, 0) - at(a, 0), at(b, 1) - at(a, 1), at(b, 2) - at(a, 2)];
  const [vx, vy, vz] = [at(c, 0) - at(a, 0), at(c, 1) - at(a, 1), at(c, 2) - at(a, 2)];
  const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(x, y, z);
  return length > 1e-12 ? [x / length, y / length, z / length] : null;
}

/** Ends of the edges, xyz each, two ends an edge. `crease` in degrees. */
export function surfaceEdges(
  index: ArrayLike<number>,
  positions: ArrayLike<number>,
  crease: number,
): Float32Array {
  const welded = weldVertices(positions);
  const vertices = positions.length / 3;
  const cosine = Math.cos((crease * Math.PI) / 180);
  const open = new Map<number, [number, number, number]>(); // directed edge -> normal of its triangle
  const drawn: number[] = [];
  for (let i = 0; i + 2 < index.length; i += 3) {
    const corner = [welded[index[i]!]!, welded[index[i + 1]!]!, welded[index[i + 2]!]!] as const;
    const normal = normalOf(positions, ...corner);
    if (!normal) continue;
    for (let side = 0; side < 3; side++) {
      const [from, to] = [corner[side]!, corner[(side + 1) % 3]!];
      const twin = open.get(to * vertices + from);
      if (!twin) {
        open.set(from * vertices + to, normal);
        continue;
      }
      open.delete(to * vertices + from);
      if (normal[0] * twin[0] + normal[1] * twin[1] + normal[2] * twin[2] < cosine) drawn.push(from, to);
    }
  }
  for (const edge of open.keys()) drawn.push(Math.floor(edge / vertices), edge % vertices);
  const ends = new Float32Array(3 * drawn.length);
  drawn.forEach((vertex, i) => {
    for (let axis = 0; axis < 3; axis++) ends[3 * i + axis] = positions[3 * vertex + axis]!;
  });
  return ends;
}

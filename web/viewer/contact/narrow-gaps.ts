/**
 * Gaps that are narrower than any pixel: furniture stands a millimetre apart, so that no ray is asked of two faces in one
 * place, and single samples of a picture fall between them and are black dots on a bright edge. On the screen the two faces
 * meet: what looks at another face at less than `widest` comes half way towards it, with all that ends on it, and is not
 * drawn where nothing of it can be seen any more.
 */
import {
  distance,
  faceOf,
  pointOf,
  type Face,
  type SolidPart,
  type Solids,
  type Triple,
  type Vec,
} from './lattice.ts';

/** Of one part. */
export interface ClosedGaps {
  readonly vertices: Uint32Array; // that are elsewhere
  readonly positions: Float32Array; // where, in room coordinates, xyz each, m
  readonly hidden: Uint32Array; // triangles
}

const widest = 2.5e-3; // m; joints that are to be seen are wider
const share = 0.55; // of a gap, from either side: what only just met would let samples through again
const lift = 1e-4; // m before a face, where looking begins
const same = 1e-4; // m
const places = [
  [1 / 3, 1 / 3],
  [0.1, 0.1],
  [0.8, 0.1],
  [0.1, 0.8],
  [0.45, 0.45],
  [0.1, 0.45],
  [0.45, 0.1],
] as const;
const rim = [
  [0.002, 0.002],
  [0.996, 0.002],
  [0.002, 0.996],
  [0.499, 0.499],
  [0.002, 0.499],
  [0.499, 0.002],
] as const;

export function closeNarrowGaps(solids: Solids): ClosedGaps[] {
  const moves = new Map<number, Triple>(); // of vertices of all parts
  const hidden = solids.room.parts.map((part) => {
    const found: number[] = [];
    for (const sides of planesOf(part).values()) {
      const gaps = sides.map(({ face }) => gapBefore(solids, face));
      // Of a wall behind a picture some would move and some not, and its edges would open.
      if (gaps.some(({ gap }) => gap === 0)) continue;
      sides.forEach(({ face, triangle }, i) => {
        move(solids, face, share * gaps[i]!.gap, moves);
        if (gaps[i]!.isWhole) found.push(triangle);
      });
    }
    return Uint32Array.from(found);
  });
  return movedByPart(solids, moves).map((moved, part) => ({ ...moved, hidden: hidden[part]! }));
}

interface Side {
  readonly face: Face;
  readonly triangle: number;
}

/** The triangles of a part by the planes that they lie in. */
function planesOf(part: SolidPart): Map<string, Side[]> {
  const planes = new Map<string, Side[]>();
  for (let first = 0; first < part.index.length; first += 3) {
    const face = faceOf(part, first);
    if (!face) continue;
    const [x, y, z] = face.normal.map((value) => Math.round(100 * value));
    const plane = `${x} ${y} ${z} ${Math.round(dot(face.normal, face.corners[0]) / (2 * same))}`;
    const sides = planes.get(plane) ?? [];
    sides.push({ face, triangle: first / 3 });
    planes.set(plane, sides);
  }
  return planes;
}

const noGap = { gap: 0, isWhole: false };

/** How wide the gap is that most of a face looks into, m; 0: none, or a wider one. And whether all of it does. */
function gapBefore(solids: Solids, face: Face): { gap: number; isWhole: boolean } {
  let met = 0;
  let least = widest;
  for (const [k, place] of places.entries()) {
    if (met + places.length - k <= places.length / 2) return noGap; // most see further already
    const far = gapAt(solids, face, place);
    if (far === 0) continue;
    met++;
    least = Math.min(least, far);
  }
  if (met <= places.length / 2) return noGap;
  const isWhole = met === places.length && rim.every((place) => gapAt(solids, face, place) > 0);
  return { gap: least, isWhole };
}

function gapAt({ tree }: Solids, face: Face, [u, v]: readonly [number, number]): number {
  const [nx, ny, nz] = face.normal;
  const [x, y, z] = pointOf(face, u, v);
  const far = tree.reach(x + lift * nx, y + lift * ny, z + lift * nz, nx, ny, nz, true, widest);
  return tree.met < 0 || tree.isBack ? 0 : far + lift;
}

/** Moves all vertices that lie on a face along its normal: those of other meshes that end there, too. */
function move(solids: Solids, face: Face, by: number, moves: Map<number, Triple>): void {
  const bound = (pick: (...values: number[]) => number, margin: number) =>
    [0, 1, 2].map((axis) => pick(...face.corners.map((corner) => corner[axis]!)) + margin) as Triple;
  solids.tree.some(bound(Math.min, -same), bound(Math.max, same), (first) => {
    for (const vertex of solids.index.subarray(first, first + 3)) {
      const at = [...solids.positions.subarray(3 * vertex, 3 * vertex + 3)] as Triple;
      if (!isOn(face, at)) continue;
      const moved = moves.get(vertex) ?? [0, 0, 0];
      const more = Math.max(0, by - dot(moved, face.normal));
      moves.set(vertex, moved.map((x, axis) => x + more * face.normal[axis]!) as Triple);
    }
    return false;
  });
}

/** On a triangle or its border. */
function isOn({ corners: [a, b, c], normal }: Face, at: Vec): boolean {
  const from = (o: Vec): Vec => [at[0] - o[0], at[1] - o[1], at[2] - o[2]];
  if (Math.abs(dot(from(a), normal)) > same) return false;
  for (const [p, q] of [
    [a, b],
    [b, c],
    [c, a],
  ] as const) {
    const [ex, ey, ez]: Vec = [q[0] - p[0], q[1] - p[1], q[2] - p[2]];
    const [nx, ny, nz] = normal;
    const inward: Vec = [ny * ez - nz * ey, nz * ex - nx * ez, nx * ey - ny * ex];
    if (dot(from(p), inward) < -same * distance(p, q)) return false;
  }
  return true;
}

function movedByPart(
  { room, positions }: Solids,
  moves: ReadonlyMap<number, Triple>,
): Omit<ClosedGaps, 'hidden'>[] {
  let start = 0;
  return room.parts.map((part) => {
    const end = start + part.positions.length / 3;
    const vertices = Uint32Array.from({ length: end - start }, (_, v) => start + v).filter((v) =>
      moves.has(v),
    );
    const moved = Float32Array.from({ length: 3 * vertices.length }, (_, i) => {
      const vertex = vertices[Math.floor(i / 3)]!;
      return positions[3 * vertex + (i % 3)]! + moves.get(vertex)![i % 3]!;
    });
    const found = { vertices: vertices.map((v) => v - start), positions: moved };
    start = end;
    return found;
  });
}

const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

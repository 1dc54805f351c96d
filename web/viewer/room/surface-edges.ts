/**
 * Edges of a surface's mesh: where it ends, and where it bends by more than a crease angle. The same as three's
 * EdgesGeometry, but with integer keys, so that a wall of many thousand triangles does not stop the picture, and
 * without the seams of flat neighbours that are cut differently.
 */

import { weldVertices } from './weld.ts';

const weld = 5e-4; // m: vertices as near as this are one
const shortest = 1e-4; // m: less is no edge

type Triple = readonly [number, number, number];

/** Unit normal of a triangle, or null where it has no area. */
function normalOf(positions: ArrayLike<number>, a: number, b: number, c: number): Triple | null {
  const at = (v: number, axis: number) => positions[3 * v + axis]!;
  const [ux, uy, uz] = [at(b, 0) - at(a, 0), at(b, 1) - at(a, 1), at(b, 2) - at(a, 2)];
  const [vx, vy, vz] = [at(c, 0) - at(a, 0), at(c, 1) - at(a, 1), at(c, 2) - at(a, 2)];
  const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(x, y, z);
  return length > 1e-12 ? [x / length, y / length, z / length] : null;
}

/** Open edges that lie on one line and belong to triangles of one plane: a place on it and the steps of what is left of it. */
interface Line {
  readonly foot: Triple;
  readonly direction: Triple;
  readonly steps: { readonly at: number; readonly change: 1 | -1 }[];
}

const dot = (a: Triple, b: Triple): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const along = (a: Triple, b: Triple, t: number): Triple => [
  a[0] + t * b[0],
  a[1] + t * b[1],
  a[2] + t * b[2],
];

/** Odd scales and an offset, so that round measures of a room do not fall between two keys. */
const keyOf = (triple: Triple, scale: number): string =>
  triple.map((value) => Math.round(value * scale + 0.317)).join(' ');

/**
 * Where flat neighbours are cut differently (T-junctions), both sides have open edges that run against each other on
 * one line. They cancel; what remains is the boundary. `open`: ends and normal of each open edge.
 */
function cancelOpposed(open: readonly { from: Triple; to: Triple; normal: Triple }[]): [Triple, Triple][] {
  const lines = new Map<string, Line>();
  for (const { from, to, normal } of open) {
    const span = along(to, from, -1);
    const length = Math.hypot(...span);
    if (length < shortest) continue;
    const leading = span.find((value) => Math.abs(value) > 0.5 * length)!;
    const direction = span.map((value) => (Math.sign(leading) * value) / length) as unknown as Triple;
    const foot = along(from, direction, -dot(from, direction));
    const key = `${keyOf(direction, 197.3)}|${keyOf(foot, 197.3)}|${keyOf(normal, 19.7)}`;
    let line = lines.get(key);
    if (!line) lines.set(key, (line = { foot, direction, steps: [] }));
    line.steps.push(
      { at: dot(from, line.direction), change: 1 },
      { at: dot(to, line.direction), change: -1 },
    );
  }
  const left: [Triple, Triple][] = [];
  for (const { foot, direction, steps } of lines.values()) {
    steps.sort((a, b) => a.at - b.at);
    let covered = 0;
    steps.forEach(({ at, change }, i) => {
      covered += change;
      const next = steps[i + 1]?.at ?? at;
      if (covered !== 0 && next - at > shortest)
        left.push([along(foot, direction, at), along(foot, direction, next)]);
    });
  }
  return left;
}

/** Ends of the edges, xyz each, two ends an edge. `crease` in degrees. */
export function surfaceEdges(
  index: ArrayLike<number>,
  positions: ArrayLike<number>,
  crease: number,
): Float32Array {
  const welded = weldVertices(positions, weld);
  const vertices = positions.length / 3;
  const cosine = Math.cos((crease * Math.PI) / 180);
  const open = new Map<number, Triple>(); // directed edge -> normal of its triangle
  const at = (v: number): Triple => [positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!];
  const drawn: [Triple, Triple][] = [];
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
      if (dot(normal, twin) < cosine) drawn.push([at(from), at(to)]);
    }
  }
  const ends = [...open].map(([edge, normal]) => ({
    from: at(Math.floor(edge / vertices)),
    to: at(edge % vertices),
    normal,
  }));
  drawn.push(...cancelOpposed(ends));
  return Float32Array.from(drawn.flat(2));
}

/**
 * The room in plan, out of its display mesh: the floor is what faces up at the lowest height, its open edges are chained
 * to loops; furniture is drawn by its edges as seen from above.
 */
import { Box3, Vector3 } from 'three';
import {
  inPlan,
  twiceArea,
  type PlanFrame,
  type Point2,
  type Point3,
  type RoomPlan,
} from '../../document/plan-frame.ts';
import type { RoomMesh } from './room-mesh.ts';
import { surfaceEdges } from './surface-edges.ts';

const level = 0.05; // m above the lowest place: still floor
const upright = 0.99; // cosine of the slope that a floor may have
const shortest = 0.04; // m: shorter edges of furniture are not drawn
const crease = 35; // degrees
const aPart = 0.03; // of the largest surface underfoot: what is smaller belongs to something else
const smallest = 0.05; // m2: a smaller loop is a gap between things

/** Corners of triangles in world space, 9 numbers each. */
type Triangles = ArrayLike<number>;

/** The triangles of the floor: those that face up at the `lowest` height (by default that of the lowest of them). */
export function floorTriangles(all: Triangles, lowest?: number): number[] {
  const heights = new Float64Array(Math.floor(all.length / 9)).fill(Infinity); // of those that face up
  let bottom = Infinity;
  for (let i = 0, at = 0; i < heights.length; i++, at += 9) {
    const [ax, ay, az] = [all[at]!, all[at + 1]!, all[at + 2]!];
    const [ux, uy, uz] = [all[at + 3]! - ax, all[at + 4]! - ay, all[at + 5]! - az];
    const [vx, vy, vz] = [all[at + 6]! - ax, all[at + 7]! - ay, all[at + 8]! - az];
    const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
    if (length <= 1e-12 || ny <= upright * length) continue;
    heights[i] = ay + (uy + vy) / 3;
    bottom = Math.min(bottom, heights[i]!);
  }
  const floor: number[] = [];
  heights.forEach((height, i) => {
    if (height >= (lowest ?? bottom) + level) return;
    for (let at = 9 * i; at < 9 * i + 9; at++) floor.push(all[at]!);
  });
  return floor;
}

/** The frame that a floor spans; `top`: the highest place of the room, m. */
export function frameOf(floor: Triangles, top: number): PlanFrame {
  const [low, high] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  for (let i = 0; i < floor.length; i++) {
    low[i % 3] = Math.min(low[i % 3]!, floor[i]!);
    high[i % 3] = Math.max(high[i % 3]!, floor[i]!);
  }
  const [west, bottom, north] = low as [number, number, number];
  const [east, , south] = high as [number, number, number];
  return { west, south, floor: bottom, size: [east - west, south - north, top - bottom] };
}

/** Closed loops of the open edges of some triangles, in plan, the largest first; what runs straight has no corner. */
export function outlinesOf(floor: Triangles, frame: PlanFrame): Point2[][] {
  const index = Array.from({ length: floor.length / 3 }, (_, i) => i);
  const segments = inSegments(surfaceEdges(index, floor, 180), frame);
  return chained(segments)
    .map(straightened)
    .filter((loop) => loop.length > 2 && Math.abs(twiceArea(loop)) > 2 * smallest)
    .sort((a, b) => Math.abs(twiceArea(b)) - Math.abs(twiceArea(a)));
}

/** The plan of a room that is displayed. Its furniture takes long, and is found when it is drawn for the first time. */
export function planOf(room: RoomMesh, frame: PlanFrame): RoomPlan {
  let furniture: RoomPlan['furniture'] | null = null;
  return {
    frame,
    outlines: outlinesOf(floorOf(room), frame),
    get furniture() {
      return (furniture ??= furnitureOf(room, frame));
    },
  };
}

function furnitureOf(room: RoomMesh, frame: PlanFrame): RoomPlan['furniture'] {
  const edges = new Map<string, readonly [Point2, Point2]>();
  for (const { mesh, measuring } of room.lit) {
    if (measuring || !room.standing.has(mesh)) continue;
    const corners = trianglesOf(mesh);
    const index = Array.from({ length: corners.length / 3 }, (_, i) => i);
    for (const [a, b] of inSegments(surfaceEdges(index, corners, crease), frame)) {
      if (Math.hypot(b[0] - a[0], b[1] - a[1]) < shortest) continue;
      const ends = [keyOf(a), keyOf(b)].sort().join('|');
      edges.set(ends, [a, b]);
    }
  }
  return [...edges.values()];
}

/** The frame of a room that is displayed; where nothing faces up, that of its box. */
export function roomFrame(room: RoomMesh): PlanFrame {
  const floor = floorOf(room);
  const { min, max } = room.box;
  return frameOf(floor.length > 0 ? floor : [...min, ...max], max[1]);
}

/** The floor of a room that is displayed, without the sills of doors and what else is low and small. */
function floorOf({ lit }: RoomMesh): number[] {
  const solid = lit.filter(({ measuring }) => !measuring);
  const bottoms = solid.map(({ mesh }) => new Box3().setFromObject(mesh).min.y);
  const lowest = Math.min(...bottoms);
  const floors = new Map<number, number[][]>(); // by surface
  for (const { mesh, surface } of solid.filter((_, i) => bottoms[i]! < lowest + level)) {
    const faces = floorTriangles(trianglesOf(mesh, lowest + level), lowest);
    floors.set(surface, [...(floors.get(surface) ?? []), faces]);
  }
  const areas = [...floors.values()].map((parts) => parts.reduce((sum, faces) => sum + levelArea(faces), 0));
  const most = Math.max(0, ...areas);
  return [...floors.values()].filter((_, i) => areas[i]! > aPart * most).flat(2);
}

/** Seen from above, m2. */
function levelArea(faces: Triangles): number {
  let sum = 0;
  for (let at = 0; at + 8 < faces.length; at += 9) {
    const p = (i: number) => faces[at + i]!;
    sum += Math.abs((p(3) - p(0)) * (p(8) - p(2)) - (p(5) - p(2)) * (p(6) - p(0))) / 2;
  }
  return sum;
}

/** In world space; only those whose middle lies below a height, where one is given. */
function trianglesOf({ geometry, matrixWorld }: RoomMesh['lit'][number]['mesh'], below = Infinity): number[] {
  const position = geometry.getAttribute('position');
  const places = new Float64Array(3 * position.count);
  const point = new Vector3();
  for (let i = 0; i < position.count; i++)
    point
      .fromBufferAttribute(position, i)
      .applyMatrix4(matrixWorld)
      .toArray(places, 3 * i);
  const { index } = geometry;
  const corners: number[] = [];
  for (let first = 0; first + 2 < (index?.count ?? position.count); first += 3) {
    const at = [first, first + 1, first + 2].map((k) => 3 * (index?.getX(k) ?? k));
    if (at.reduce((sum, k) => sum + places[k + 1]!, 0) / 3 >= below) continue;
    for (const k of at) corners.push(places[k]!, places[k + 1]!, places[k + 2]!);
  }
  return corners;
}

function inSegments(ends: Float32Array, frame: PlanFrame): [Point2, Point2][] {
  const segments: [Point2, Point2][] = [];
  const at = (i: number): Point2 => {
    const place = inPlan(frame, [ends[i]!, ends[i + 1]!, ends[i + 2]!] satisfies Point3);
    return [place[0], place[1]];
  };
  for (let i = 0; i + 5 < ends.length; i += 6) segments.push([at(i), at(i + 3)]);
  return segments;
}

/** Ends within about a millimetre are one; an odd offset keeps round measures off the borders of the cells. */
const keyOf = ([x, y]: Point2): string => `${Math.round(x * 997 + 0.317)} ${Math.round(y * 997 + 0.317)}`;

/** Loops along segments that share their ends; a chain that does not return to its beginning is left out. */
function chained(segments: readonly (readonly [Point2, Point2])[]): Point2[][] {
  const meeting = new Map<string, number[]>();
  segments.forEach((ends, i) => {
    for (const end of ends) meeting.set(keyOf(end), [...(meeting.get(keyOf(end)) ?? []), i]);
  });
  const used = new Set<number>();
  const loops: Point2[][] = [];
  for (const [first, [start, second]] of segments.entries()) {
    if (used.has(first)) continue;
    used.add(first);
    const loop = [start];
    let at = second;
    while (keyOf(at) !== keyOf(start)) {
      const next = meeting.get(keyOf(at))?.find((i) => !used.has(i));
      if (next === undefined) break;
      used.add(next);
      loop.push(at);
      const [a, b] = segments[next]!;
      at = keyOf(a) === keyOf(at) ? b : a;
    }
    if (keyOf(at) === keyOf(start)) loops.push(loop);
  }
  return loops;
}

/** A loop without the points that lie on a straight line between their neighbours. */
function straightened(loop: readonly Point2[]): Point2[] {
  return loop.filter(([x, y], i) => {
    const [beforeX, beforeY] = loop[(i + loop.length - 1) % loop.length]!;
    const [nextX, nextY] = loop[(i + 1) % loop.length]!;
    const [ux, uy, vx, vy] = [x - beforeX, y - beforeY, nextX - x, nextY - y];
    return Math.abs(ux * vy - uy * vx) > 1e-3 * Math.hypot(ux, uy) * Math.hypot(vx, vy);
  });
}

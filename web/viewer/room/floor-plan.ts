/**
 * The room in plan, out of its display mesh: the floor is what faces up at the lowest height where much of the room does, its
 * open edges are chained to loops; furniture is drawn by its edges as seen from above.
 */
import { Box3, type Mesh } from 'three';
import { joined } from '../../document/joined.ts';
import {
  inPlan,
  twiceArea,
  type PlanFrame,
  type Point2,
  type Point3,
  type RoomPlan,
} from '../../document/plan-frame.ts';
import { inWorld } from './in-world.ts';
import type { RoomMesh } from './room-mesh.ts';
import { surfaceEdges } from './surface-edges.ts';
import { atOnce, type Pieces } from '../stage/breath.ts';

const level = 0.05; // m above the lowest place: still floor
const rounding = 1e-4; // m
const upright = 0.99; // cosine of the slope that a floor may have
const shortest = 0.04; // m: shorter edges of furniture are not drawn
const crease = 35; // degrees
const portion = 3 * 4096; // corners of triangles that are looked at in one piece
const aPart = 0.03; // of the largest surface underfoot: what is smaller belongs to something else
const surely = 0.4; // of the room's box in plan: what faces up at the bottom and is as large is its floor
const mainly = 0.5; // of the largest level: a lower one of this size is the floor
const smallest = 0.05; // m2: a smaller loop is a gap between things

/** Corners of triangles in world space, 9 numbers each. */
type Triangles = ArrayLike<number>;

/** The heights of triangles that face up; infinite of others. */
function levelHeights(all: Triangles): Float64Array {
  const heights = new Float64Array(Math.floor(all.length / 9)).fill(Infinity);
  // note: plain numbers, for this runs before the browser has compiled it well.
  for (let i = 0, at = 0; i < heights.length; i++, at += 9) {
    const ux = all[at + 3]! - all[at]!;
    const uy = all[at + 4]! - all[at + 1]!;
    const uz = all[at + 5]! - all[at + 2]!;
    const vx = all[at + 6]! - all[at]!;
    const vy = all[at + 7]! - all[at + 1]!;
    const vz = all[at + 8]! - all[at + 2]!;
    const nx = uy * vz - uz * vy;
    const ny = uz * vx - ux * vz;
    const nz = ux * vy - uy * vx;
    const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
    if (length <= 1e-12 || ny <= upright * length) continue;
    heights[i] = all[at + 1]! + (uy + vy) / 3;
  }
  return heights;
}

/** The triangles of the floor: those that face up at the `lowest` height (by default that of the lowest of them). */
export function floorTriangles(all: Triangles, lowest?: number): Float64Array {
  const heights = levelHeights(all);
  const floor = new Float64Array(9 * heights.length);
  const least = lowest ?? heights.reduce((low, height) => Math.min(low, height), Infinity);
  let end = 0;
  for (let i = 0; i < heights.length; i++) {
    if (heights[i]! < least - rounding || heights[i]! >= least + level) continue;
    for (let at = 9 * i; at < 9 * i + 9; at++) floor[end++] = all[at]!;
  }
  return floor.slice(0, end);
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
export function* outlinesOf(floor: Triangles, frame: PlanFrame): Pieces<Point2[][]> {
  const index = Uint32Array.from({ length: floor.length / 3 }, (_, i) => i);
  const segments = inSegments(yield* surfaceEdges(index, floor, 180), frame);
  yield;
  return chained(segments)
    .map(straightened)
    .filter((loop) => loop.length > 2 && Math.abs(twiceArea(loop)) > 2 * smallest)
    .sort((a, b) => Math.abs(twiceArea(b)) - Math.abs(twiceArea(a)));
}

/**
 * The plan of a room that is displayed; where nothing faces up, in the frame of its box. Its furniture takes long, and is
 * found when it is drawn for the first time.
 */
export function* planOf(room: RoomMesh): Pieces<RoomPlan> {
  const floor = yield* floorOf(room);
  yield;
  const { min, max } = room.box;
  const frame = frameOf(floor.length > 0 ? floor : [...min, ...max], max[1]);
  yield;
  const outlines = yield* outlinesOf(floor, frame);
  let furniture: RoomPlan['furniture'] | null = null;
  return {
    frame,
    outlines,
    get furniture() {
      return (furniture ??= furnitureOf(room, frame));
    },
  };
}

function furnitureOf(room: RoomMesh, frame: PlanFrame): RoomPlan['furniture'] {
  const edges = new Map<string, readonly [Point2, Point2]>();
  for (const { mesh, measuring } of room.lit) {
    if (measuring || !room.standing.has(mesh)) continue;
    const corners = atOnce(trianglesOf(mesh));
    const index = Uint32Array.from({ length: corners.length / 3 }, (_, i) => i);
    for (const [a, b] of inSegments(atOnce(surfaceEdges(index, corners, crease)), frame)) {
      if (Math.hypot(b[0] - a[0], b[1] - a[1]) < shortest) continue;
      const ends = [keyOf(a), keyOf(b)].sort().join('|');
      edges.set(ends, [a, b]);
    }
  }
  return [...edges.values()];
}

/** The floor of a room that is displayed: at the bottom, unless only something small faces up there. */
function* floorOf({ lit, box: { min, max } }: RoomMesh): Pieces<Float64Array> {
  const solid = lit
    .filter(({ measuring }) => !measuring)
    .map(({ mesh, surface }) => ({ mesh, surface, bottom: new Box3().setFromObject(mesh).min.y }));
  const lowest = Math.min(...solid.map(({ bottom }) => bottom));
  const floor = yield* floorAt(solid, lowest);
  if (levelArea(floor) >= surely * (max[0] - min[0]) * (max[2] - min[2])) return floor;
  const main = mainLevel(yield* levelsOf(solid));
  return main < lowest + level ? floor : yield* floorAt(solid, main);
}

interface Solid {
  readonly mesh: Mesh;
  readonly surface: number;
  readonly bottom: number; // m
}

/** What faces up, m2, by its height in steps of `level`. */
function* levelsOf(solid: readonly Solid[]): Pieces<Map<number, number>> {
  const levels = new Map<number, number>();
  for (const { mesh } of solid) {
    const corners = yield* trianglesOf(mesh);
    const heights = levelHeights(corners);
    for (let i = 0; i < heights.length; i++) {
      if (i % portion === 0) yield;
      const step = Math.floor(heights[i]! / level + rounding);
      if (Number.isFinite(step)) levels.set(step, (levels.get(step) ?? 0) + areaInPlan(corners, 9 * i));
    }
  }
  return levels;
}

/** The lowest height, m, where as much faces up as at half the best; -Infinity where nothing does. */
function mainLevel(levels: ReadonlyMap<number, number>): number {
  const steps = [...levels.keys()].sort((a, b) => a - b);
  const most = Math.max(0, ...levels.values());
  const main = steps.find((step) => levels.get(step)! >= mainly * most);
  return main === undefined ? -Infinity : main * level;
}

/** What faces up at a height, without the sills of doors and what else is low and small. */
function* floorAt(solid: readonly Solid[], height: number): Pieces<Float64Array> {
  const floors = new Map<number, Float64Array[]>(); // by surface
  for (const { mesh, surface } of solid.filter(({ bottom }) => bottom < height + level)) {
    const faces = floorTriangles(yield* trianglesOf(mesh, height + level), height);
    floors.set(surface, [...(floors.get(surface) ?? []), faces]);
    yield;
  }
  const areas: number[] = [];
  for (const parts of floors.values()) {
    areas.push(parts.reduce((sum, faces) => sum + levelArea(faces), 0));
    yield;
  }
  const most = Math.max(0, ...areas);
  const kept = [...floors.values()].filter((_, i) => areas[i]! > aPart * most).flat();
  return joined(kept, Float64Array);
}

/** Seen from above, m2. */
function levelArea(faces: Triangles): number {
  let sum = 0;
  for (let at = 0; at + 8 < faces.length; at += 9) sum += areaInPlan(faces, at);
  return sum;
}

/** Of the triangle that begins there, m2. */
function areaInPlan(corners: Triangles, at: number): number {
  const p = (i: number) => corners[at + i]!;
  return Math.abs((p(3) - p(0)) * (p(8) - p(2)) - (p(5) - p(2)) * (p(6) - p(0))) / 2;
}

/** In world space; only those whose middle lies below a height, where one is given. */
function* trianglesOf(mesh: Mesh, below = Infinity): Pieces<Triangles> {
  const { index, positions } = inWorld(mesh);
  const corners = new Float64Array(3 * index.length);
  let end = 0;
  for (let first = 0; first + 2 < index.length; first += 3) {
    if (first % portion === 0) yield;
    let heights = 0;
    for (let corner = first; corner < first + 3; corner++) {
      const at = 3 * index[corner]!;
      for (let axis = 0; axis < 3; axis++) corners[end++] = positions[at + axis]!;
      heights += positions[at + 1]!;
    }
    if (heights / 3 >= below) end -= 9;
  }
  return corners.subarray(0, end);
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

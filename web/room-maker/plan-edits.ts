/** Changes of a plan by hand: pure functions, a new plan each. Where a change would break the outline it is null. */
import { reachOf } from './items.mjs';
import { contains, distance, holds, isSimple } from './polygon.mjs';
import { mostCorners, mostItems, type Item, type Opening, type Point, type RoomPlan } from './room-plan.mjs';

const leastWall = 0.05; // m
const wallGap = 0.02; // m between a wall and rows that had to move
const midSteps = 50; // mm, and how many of them at most, of the way to the middle
const mostMidSteps = 400;
const mostSteps = 40; // each way, of the places that are tried for them

const at = <T>(list: readonly T[], index: number): T => list[(index + list.length) % list.length] as T;

/** Whole millimetres. */
export const toMillimetres = (value: number): number => Math.round(value * 1000) / 1000 || 0;

export const snapped = (value: number, step: number): number =>
  toMillimetres(Math.round(value / step) * step);

export function wallLength({ outline }: RoomPlan, wall: number): number {
  return distance(at(outline, wall), at(outline, wall + 1));
}

function withOutline(plan: RoomPlan, outline: readonly Point[]): RoomPlan | null {
  const isLong = outline.every((corner, i) => distance(corner, at(outline, i + 1)) >= leastWall);
  return isLong && isSimple(outline) ? { ...plan, outline } : null;
}

export function withCorner(plan: RoomPlan, corner: number, [x, z]: Point): RoomPlan | null {
  const moved: Point = [toMillimetres(x), toMillimetres(z)];
  return withOutline(
    plan,
    plan.outline.map((each, i) => (i === corner ? moved : each)),
  );
}

/** A wall moved sideways by (dx, dz): both its corners. */
export function withWallMoved(plan: RoomPlan, wall: number, [dx, dz]: Point): RoomPlan | null {
  const next = (wall + 1) % plan.outline.length;
  const move = ([x, z]: Point): Point => [toMillimetres(x + dx), toMillimetres(z + dz)];
  return withOutline(
    plan,
    plan.outline.map((each, i) => (i === wall || i === next ? move(each) : each)),
  );
}

/** The wall gets a length; the next wall moves along, so that right angles stay. */
export function withWallLength(plan: RoomPlan, wall: number, length: number): RoomPlan | null {
  const [a, b] = [at(plan.outline, wall), at(plan.outline, wall + 1)];
  const old = distance(a, b);
  if (!(length >= leastWall)) return null;
  const by: Point = [((b[0] - a[0]) / old) * (length - old), ((b[1] - a[1]) / old) * (length - old)];
  return withWallMoved(plan, (wall + 1) % plan.outline.length, by);
}

/** A new corner in the middle of a wall; openings go with the part that they begin in. */
export function withWallSplit(plan: RoomPlan, wall: number): RoomPlan | null {
  if (plan.outline.length >= mostCorners) return null;
  const [a, b] = [at(plan.outline, wall), at(plan.outline, wall + 1)];
  const middle: Point = [toMillimetres((a[0] + b[0]) / 2), toMillimetres((a[1] + b[1]) / 2)];
  const half = distance(a, middle);
  const openings = plan.openings.map((opening) => {
    if (opening.wall > wall) return { ...opening, wall: opening.wall + 1 };
    if (opening.wall < wall || opening.at < half) return opening;
    return { ...opening, wall: wall + 1, at: toMillimetres(opening.at - half) };
  });
  const outline = [...plan.outline.slice(0, wall + 1), middle, ...plan.outline.slice(wall + 1)];
  return { ...plan, outline, openings };
}

/** Without a corner; openings of the two walls that become one keep their places as far as they can. */
export function withoutCorner(plan: RoomPlan, corner: number): RoomPlan | null {
  const count = plan.outline.length;
  if (count <= 3) return null;
  const before = (corner + count - 1) % count;
  const first = wallLength(plan, before);
  const openings = plan.openings.map((opening) => {
    const joined = opening.wall === corner ? { ...opening, wall: before, at: first + opening.at } : opening;
    return joined.wall > corner ? { ...joined, wall: joined.wall - 1 } : joined;
  });
  return withOutline(
    { ...plan, openings },
    plan.outline.filter((_, i) => i !== corner),
  );
}

/** Width and depth, m. */
export function extentOf(outline: RoomPlan['outline']): Point {
  const along = (axis: 0 | 1) => outline.map((corner) => corner[axis]);
  return [Math.max(...along(0)) - Math.min(...along(0)), Math.max(...along(1)) - Math.min(...along(1))];
}

/** The same shape, so wide and deep, m. */
export function resized(outline: RoomPlan['outline'], [width, depth]: Point): Point[] {
  const [w, d] = extentOf(outline);
  const [x0, z0] = [Math.min(...outline.map(([x]) => x)), Math.min(...outline.map(([, z]) => z))];
  return outline.map(([x, z]) => [
    toMillimetres(x0 + ((x - x0) * width) / w),
    toMillimetres(z0 + ((z - z0) * depth) / d),
  ]);
}

/** Another outline: openings whose wall is gone go, too. */
export function withNewOutline(plan: RoomPlan, outline: readonly Point[]): RoomPlan {
  return { ...plan, outline, openings: plan.openings.filter(({ wall }) => wall < outline.length) };
}

export function withItem(plan: RoomPlan, index: number, change: Partial<Item>): RoomPlan {
  return { ...plan, items: plan.items.map((item, i) => (i === index ? { ...item, ...change } : item)) };
}

export function withOpening(plan: RoomPlan, index: number, change: Partial<Opening>): RoomPlan {
  return { ...plan, openings: plan.openings.map((each, i) => (i === index ? { ...each, ...change } : each)) };
}

/** A free stretch of a wall for an opening of this width: its middle if it can be, else where there is room; m or null. */
export function freePlace(plan: RoomPlan, wall: number, width: number): number | null {
  const margin = 0.15; // m, of frames and a little wall
  const length = wallLength(plan, wall);
  const taken = plan.openings.filter((each) => each.wall === wall);
  const isFree = (from: number) =>
    from >= margin - 1e-9 &&
    from + width <= length - margin + 1e-9 &&
    taken.every((each) => from + width + margin <= each.at || each.at + each.width + margin <= from);
  const places = [(length - width) / 2, margin, length - margin - width];
  for (const each of taken) places.push(each.at + each.width + 2 * margin, each.at - 2 * margin - width);
  const free = places.find(isFree);
  return free === undefined ? null : toMillimetres(free);
}

export interface Rows {
  readonly across: number; // how many along the item's width
  readonly down: number; // how many along its depth
  readonly acrossPitch: number; // m from centre to centre
  readonly downPitch: number; // m
}

/** An item repeated in rows that begin with it, turned as it is; rows that would leave the room move into it as one. */
export function withRows(plan: RoomPlan, index: number, rows: Rows): RoomPlan {
  const begin = plan.items[index];
  if (!begin) return plan;
  const turned = turnedBy(begin.turn);
  const [dx, dz] = wayIntoRoom(plan, begin, rows);
  const first: Item = { ...begin, x: toMillimetres(begin.x + dx), z: toMillimetres(begin.z + dz) };
  const more: Item[] = [];
  for (let j = 0; j < rows.down; j++)
    for (let i = 0; i < rows.across; i++) {
      const [x, z] = turned([i * rows.acrossPitch, j * rows.downPitch]);
      if (i + j > 0) more.push({ ...first, x: toMillimetres(first.x + x), z: toMillimetres(first.z + z) });
    }
  const items = plan.items.map((item, i) => (i === index ? first : item));
  return { ...plan, items: [...items, ...more].slice(0, mostItems) };
}

/** From an item's own axes to the plan's. */
function turnedBy(turn: number): (point: Point) => Point {
  const [c, s] = [Math.cos((turn * Math.PI) / 180), Math.sin((turn * Math.PI) / 180)];
  return ([u, v]) => [c * u + s * v, -s * u + c * v];
}

/** The middle of all that fits along a direction around `from`, which does. */
function midway(from: Point, [u, v]: Point, fits: (way: Point) => boolean): Point {
  const at = (step: number): Point => [
    toMillimetres(from[0] + (step * u * midSteps) / 1000),
    toMillimetres(from[1] + (step * v * midSteps) / 1000),
  ];
  let [low, high] = [0, 0];
  while (low > -mostMidSteps && fits(at(low - 1))) low--;
  while (high < mostMidSteps && fits(at(high + 1))) high++;
  return at(Math.round((low + high) / 2));
}

/** The shortest way by which rows come to stand in the room, midway between its walls; none where they do, or cannot. */
function wayIntoRoom({ outline }: RoomPlan, item: Item, rows: Rows): Point {
  const { x, z, turn } = item;
  const [left, far, firstRight, firstNear] = reachOf(item);
  const right = (rows.across - 1) * rows.acrossPitch + firstRight;
  const near = (rows.down - 1) * rows.downPitch + firstNear;
  const corners: Point[] = [[left, far], [right, far], [right, near], [left, near]]; // prettier-ignore
  const block = corners.map(turnedBy(turn));
  if (block.every(([u, v]) => contains(outline, [x + u, z + v]))) return [0, 0];
  const fits = ([dx, dz]: Point) => {
    const moved = block.map(([u, v]): Point => [x + u + dx, z + v + dz]);
    return holds(outline, moved, wallGap);
  };
  const reach = [0, 1].map((axis) =>
    Math.max(...outline.map((corner) => Math.abs(corner[axis]! - [x, z][axis]!))),
  );
  const steps = (most: number) => {
    const step = Math.max(0.05, snapped(most / mostSteps, 0.05));
    const count = Math.ceil(most / step);
    return Array.from({ length: 2 * count + 1 }, (_, i) => toMillimetres((i - count) * step));
  };
  const ways = steps(reach[0]!).flatMap((dx) => steps(reach[1]!).map((dz): Point => [dx, dz]));
  const shortest = ways.sort((a, b) => Math.hypot(...a) - Math.hypot(...b)).find(fits);
  if (!shortest) return [0, 0];
  const across = shortest[0] === 0 ? shortest : midway(shortest, [1, 0], fits);
  return shortest[1] === 0 ? across : midway(across, [0, 1], fits);
}

/** With one more measuring plane around a point, as high as the working plane. */
export function withTask(plan: RoomPlan, [x, z]: Point, [width, depth]: Point): RoomPlan {
  const task = { x, z, width, depth, height: plan.plane?.height ?? 0.75, turn: 0 };
  return { ...plan, tasks: [...plan.tasks, task] };
}

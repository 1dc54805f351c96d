/** What dragging and arrow keys do to whatever is held in the plan. */
import type { Selected } from '../../app/making.ts';
import {
  snapped,
  toMillimetres,
  withCorner,
  withItem,
  withOpening,
  withWallMoved,
} from '../../room-maker/plan-edits.ts';
import { distance, distanceToOutline } from '../../room-maker/polygon.mjs';
import type { Point, RoomPlan } from '../../room-maker/room-plan.mjs';

const grid = 0.05; // m that dragging snaps to; Alt: a millimetre
const align = 0.12; // m within which a corner lines up with another

/** The plan after a drag of `selected` from one point to another, from the plan when it was grabbed. */
export function dragged(
  plan: RoomPlan,
  selected: Selected,
  from: Point,
  to: Point,
  isFree: boolean,
): RoomPlan | null {
  const step = isFree ? 0.001 : grid;
  const by: Point = [to[0] - from[0], to[1] - from[1]];
  if (selected.what === 'opening') return openingDragged(plan, selected.index, from, to, step);
  if (selected.what === 'wall') return wallDragged(plan, selected.index, by, step);
  const at = placeOf(plan, selected);
  if (!at) return null;
  const next: Point = [snapped(at[0] + by[0], step), snapped(at[1] + by[1], step)];
  return placed(plan, selected, selected.what === 'corner' && !isFree ? aligned(plan, selected.index, next) : next);
} // prettier-ignore

/** The plan after a step of the arrow keys. */
export function moved(plan: RoomPlan, selected: Selected, by: Point): RoomPlan | null {
  if (selected.what === 'wall') return withWallMoved(plan, selected.index, by);
  if (selected.what === 'opening') {
    const opening = plan.openings[selected.index];
    if (!opening) return null;
    const { along } = wallOf(plan, opening.wall);
    const way = by[0] * along[0] + by[1] * along[1];
    return withOpening(plan, selected.index, { at: toMillimetres(Math.max(0, opening.at + way)) });
  }
  const at = placeOf(plan, selected);
  return at && placed(plan, selected, [toMillimetres(at[0] + by[0]), toMillimetres(at[1] + by[1])]);
}

function placeOf(plan: RoomPlan, { what, index }: Selected): Point | null {
  if (what === 'corner') return plan.outline[index] ?? null;
  const thing = what === 'item' ? plan.items[index] : plan.tasks[index];
  return thing ? [thing.x, thing.z] : null;
}

function placed(plan: RoomPlan, { what, index }: Selected, [x, z]: Point): RoomPlan | null {
  if (what === 'corner') return withCorner(plan, index, [x, z]);
  if (what === 'item') return withItem(plan, index, { x, z });
  return { ...plan, tasks: plan.tasks.map((task, i) => (i === index ? { ...task, x, z } : task)) };
}

/** A corner lines up with its neighbours where it is nearly in line, so that right angles are found by hand. */
function aligned({ outline }: RoomPlan, corner: number, [x, z]: Point): Point {
  const count = outline.length;
  const neighbours = [outline[(corner + count - 1) % count], outline[(corner + 1) % count]];
  const near = (value: number, axis: 0 | 1) =>
    neighbours.find((other) => other && Math.abs(other[axis] - value) < align)?.[axis] ?? value;
  return [near(x, 0), near(z, 1)];
}

function wallOf({ outline }: RoomPlan, wall: number) {
  const [a, b] = [outline[wall]!, outline[(wall + 1) % outline.length]!];
  const length = distance(a, b);
  const along: Point = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
  return { a, length, along };
}

/** A wall goes sideways only. */
function wallDragged(plan: RoomPlan, wall: number, by: Point, step: number): RoomPlan | null {
  const { along } = wallOf(plan, wall);
  const sideways = snapped(-by[0] * along[1] + by[1] * along[0], step);
  return withWallMoved(plan, wall, [-along[1] * sideways, along[0] * sideways]);
}

/** An opening goes along its wall, or to the wall nearest to the pointer. */
function openingDragged(
  plan: RoomPlan,
  index: number,
  from: Point,
  to: Point,
  step: number,
): RoomPlan | null {
  const opening = plan.openings[index];
  if (!opening || opening.wall >= plan.outline.length) return null;
  const away = (wall: number) => {
    const { a, along, length } = wallOf(plan, wall);
    const end: Point = [a[0] + along[0] * length, a[1] + along[1] * length];
    return distanceToOutline([a, end], to);
  };
  const walls = plan.outline.map((_, wall) => wall);
  const nearest = walls.reduce((best, wall) => (away(wall) < away(best) - 0.01 ? wall : best), opening.wall);
  const { a, along, length } = wallOf(plan, nearest);
  const u = (p: Point) => (p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1];
  const grabbed = nearest === opening.wall ? u(from) - opening.at : opening.width / 2;
  const at = Math.max(0, Math.min(length - opening.width, snapped(u(to) - grabbed, step)));
  return withOpening(plan, index, { wall: nearest, at: toMillimetres(at) });
}

/**
 * Where in plan luminaires may hang: which sites a document's areas and its distance to walls leave out. What is pinned by
 * hand stays where it is.
 */
import { inPlan, type Point2, type RoomPlan } from './plan-frame.ts';
import { positionOf, siteCount } from './sites.ts';
import type { Areas, Layout, Luminaires, PlanArea, PlanOutline, SceneInfo } from './types.ts';

/** What an area in plan is for: where luminaires may hang, which of them are meant, what is lit, or where is measured. */
export type AreaKind = 'keepOut' | 'keepIn' | 'select' | 'task' | 'plane';

/** An area as it is drawn in the picture. */
export interface MarkedArea {
  readonly kind: AreaKind;
  readonly outline: readonly Point2[]; // the room's x and z, m
  readonly height: number | null; // m, the room's y; null: just below the luminaires
  readonly isStrong?: boolean; // it stands out
}

export const noAreas: Areas = { keepOut: [], keepIn: [], fromWalls: 0 };

const edge = 1e-6; // m: on the line is inside

const holds = ([x, z, farX, farZ]: PlanArea, px: number, pz: number): boolean =>
  px >= x - edge && px <= farX + edge && pz >= z - edge && pz <= farZ + edge;

/** Whether a point lies in an outline; on its edge it may. */
export function isInside(outline: readonly Point2[], [x, z]: Point2): boolean {
  let isIn = false;
  outline.forEach(([ax, az], i) => {
    const [bx, bz] = outline[(i + 1) % outline.length]!;
    if (az > z !== bz > z && x < ax + ((z - az) / (bz - az)) * (bx - ax)) isIn = !isIn;
  });
  return isIn;
}

/** The rectangle that an area is; null where it was drawn by its corners. */
export function asRectangle(area: PlanArea | PlanOutline): PlanArea | null {
  return typeof area[0] === 'number' ? (area as PlanArea) : null;
}

/** The corners of an area. */
export function cornersOf(area: PlanArea | PlanOutline): PlanOutline {
  const rectangle = asRectangle(area);
  return rectangle ? outlineOf(rectangle) : (area as PlanOutline);
}

/** What of an outline lies in a rectangle (Sutherland and Hodgman); no corners where nothing does. */
export function clippedTo(outline: PlanOutline, [x, z, farX, farZ]: PlanArea): PlanOutline {
  const sides = [[0, x, 1], [0, farX, -1], [1, z, 1], [1, farZ, -1]] as const; // prettier-ignore
  return sides.reduce<PlanOutline>(
    (corners, [axis, at, way]) =>
      corners.flatMap((corner, i) => {
        const before = corners.at(i - 1)!;
        const [to, from] = [corner, before].map((each) => way * (each[axis]! - at)) as [number, number];
        const share = from / (from - to);
        const cut = [0, 1].map((k) => before[k]! + share * (corner[k]! - before[k]!)) as [number, number];
        return [...(to * from < 0 ? [cut] : []), ...(to >= 0 ? [corner] : [])];
      }),
    outline,
  );
}

/** Whether a place is in an area; on its edge it is. */
function isWithin(area: PlanArea | PlanOutline, x: number, z: number): boolean {
  const rectangle = asRectangle(area);
  if (rectangle) return holds(rectangle, x, z);
  const outline = cornersOf(area);
  return isInside(outline, [x, z]) || wallDistance([x, z], [outline]) < edge;
}

/** The rectangle between two corners. */
export function areaBetween(a: Point2, b: Point2): PlanArea {
  return [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.max(a[0], b[0]), Math.max(a[1], b[1])];
}

/** The areas where luminaires may or may not hang, to be drawn. */
export function markedAreas(areas: Areas | undefined): MarkedArea[] {
  return (['keepOut', 'keepIn'] as const).flatMap((kind) =>
    (areas?.[kind] ?? []).map((area) => ({ kind, outline: cornersOf(area), height: null })),
  );
}

/** The luminaires of a layout that hang in an area. */
export function luminairesIn(area: PlanArea, { sites: hung }: Layout, sites: SceneInfo['sites']): number[] {
  return [...hung.keys()].filter((luminaire) => {
    const [x, , z] = positionOf(sites, hung[luminaire] ?? -1);
    return holds(area, x, z);
  });
}

/** The corners of a rectangle. */
export function outlineOf([x, z, farX, farZ]: PlanArea): [number, number][] {
  return [
    [x, z],
    [farX, z],
    [farX, farZ],
    [x, farZ],
  ];
}

/** From a point to the nearest wall of a plan, m; infinite where it has none. */
export function wallDistance(point: Point2, outlines: RoomPlan['outlines']): number {
  let least = Infinity;
  for (const loop of outlines)
    loop.forEach((from, i) => {
      const to = loop[(i + 1) % loop.length]!;
      const [x, y] = [to[0] - from[0], to[1] - from[1]];
      const along = ((point[0] - from[0]) * x + (point[1] - from[1]) * y) / (x * x + y * y || 1);
      const share = Math.min(1, Math.max(0, along));
      least = Math.min(least, Math.hypot(from[0] + share * x - point[0], from[1] + share * y - point[1]));
    });
  return least;
}

/**
 * Sites where no luminaire may hang: the excluded ones and those that the areas leave out, but for pinned ones. Without a
 * plan nothing is known of walls.
 */
export function barredSites(
  { excluded, areas, pinned }: Pick<Luminaires, 'excluded' | 'areas' | 'pinned'>,
  sites: SceneInfo['sites'],
  plan: RoomPlan | null,
): readonly number[] {
  if (!areas) return excluded;
  const { keepOut, keepIn, fromWalls } = areas;
  const isNearWall = (place: readonly [number, number, number]) => {
    if (!plan || fromWalls <= 0) return false;
    const [x, y] = inPlan(plan.frame, place);
    return wallDistance([x, y], plan.outlines) < fromWalls - edge;
  };
  const kept = new Set(pinned);
  const barred = new Set(excluded);
  for (let site = 0; site < siteCount(sites); site++) {
    const place = positionOf(sites, site);
    const [x, , z] = place;
    const isIn = keepIn.length === 0 || keepIn.some((area) => isWithin(area, x, z));
    const isOut = keepOut.some((area) => isWithin(area, x, z));
    if ((!isIn || isOut || isNearWall(place)) && !kept.has(site)) barred.add(site);
  }
  return [...barred];
}

/**
 * Task areas (EN 12464-1): parts of a measuring plane or of a floor by their outlines in plan, with a band around each and
 * the rest of the plane as its background. Each counts as a leaf surface of its own, made of the points of the plane in it.
 */
import { countedRows } from './counted-rows.ts';
import { isInside, outlineOf, wallDistance, type MarkedArea } from './areas.ts';
import type { Point2 } from './plan-frame.ts';
import type { Card, PlanArea, SceneInfo, TaskArea } from './types.ts';

export const surroundWidth = 0.5; // m
const level = 0.02; // m: what is as flat as that is level
const [lowest, highest] = [0.3, 1.4]; // m above the lowest patch: where somebody works

export const surroundOf = (name: string): string => `${name} surround`;
export const backgroundOf = (surface: string): string => `${surface} background`;

/** The rectangle that an outline is; null where it is none. */
export function rectangleOf(outline: readonly Point2[]): PlanArea | null {
  const area = boxOf(outline);
  const isCorner = ([x, z]: Point2) => (x === area[0] || x === area[2]) && (z === area[1] || z === area[3]);
  const corners = new Set(outline.map(([x, z]) => `${x} ${z}`));
  return outline.length === 4 && corners.size === 4 && outline.every(isCorner) ? area : null;
}

function boxOf(outline: readonly Point2[]): PlanArea {
  const [xs, zs] = [outline.map(([x]) => x), outline.map(([, z]) => z)];
  return [Math.min(...xs), Math.min(...zs), Math.max(...xs), Math.max(...zs)];
}

type Surface = SceneInfo['surfaces'][number];

const placeOf = ({ patchCenter }: SceneInfo, row: number): Point2 => [
  patchCenter[3 * row]!,
  patchCenter[3 * row + 2]!,
];

function partOf(scene: SceneInfo, name: string, leaf: number, rows: readonly number[]): Surface[] {
  if (rows.length === 0) return [];
  const area = rows.reduce((sum, row) => sum + (scene.patchArea[row] ?? 0), 0);
  const { lost } = scene.surfaces[leaf]!;
  const part = { leaf, rows: Uint32Array.from(rows) };
  return [{ name, area, patches: rows.length, reflectance: 0, measuring: true, lost, part }];
}

/** The surfaces that the areas on one leaf make: themselves, their bands, and what is left. */
function partsOn(scene: SceneInfo, leaf: number, areas: readonly TaskArea[]): Surface[] {
  const tasks = areas.map((): number[] => []);
  const bands = areas.map((): number[] => []);
  const rest: number[] = [];
  for (const row of countedRows(scene, leaf)) {
    const place = placeOf(scene, row);
    const inside = areas.flatMap(({ outline }, i) => (isInside(outline, place) ? [i] : []));
    for (const i of inside) tasks[i]!.push(row);
    if (inside.length > 0) continue;
    const near = areas.findIndex(({ outline }) => wallDistance(place, [outline]) <= surroundWidth);
    (bands[near] ?? rest).push(row);
  }
  return [
    ...areas.flatMap(({ name }, i) => partOf(scene, name, leaf, tasks[i]!)),
    ...areas.flatMap(({ name }, i) => partOf(scene, surroundOf(name), leaf, bands[i]!)),
    ...partOf(scene, backgroundOf(scene.surfaces[leaf]!.name), leaf, rest),
  ];
}

const latest = new WeakMap<SceneInfo, { readonly areas: readonly TaskArea[]; readonly scene: SceneInfo }>();

/** A room with its task areas as its last surfaces; those that hold no point of it are left out. */
export function withTaskAreas(scene: SceneInfo, areas: readonly TaskArea[] | undefined): SceneInfo {
  if (!areas || areas.length === 0) return scene;
  const known = latest.get(scene);
  if (known && (known.areas === areas || JSON.stringify(known.areas) === JSON.stringify(areas)))
    return known.scene;
  const leaves = scene.surfaces.flatMap((_, leaf) => {
    const own = areas.filter(({ surface }) => surface === scene.surfaces[leaf]!.name);
    return own.length > 0 ? [{ leaf, own }] : [];
  });
  const parts = leaves.flatMap(({ leaf, own }) => partsOn(scene, leaf, own));
  const whole = { ...scene, surfaces: [...scene.surfaces, ...parts] };
  latest.set(scene, { areas, scene: whole });
  return whole;
}

/** The leaf of the file that a surface is, or is part of. */
export function leafBehind({ surfaces }: Pick<SceneInfo, 'surfaces'>, leaf: number): number {
  return surfaces[leaf]?.part?.leaf ?? leaf;
}

interface Level {
  readonly leaf: number;
  readonly height: number; // m
}

/** What tells which surfaces are level. */
export type Levels = Pick<SceneInfo, 'surfaces' | 'surfaceOfPatch' | 'patchCenter' | 'patchCovered'>;

const knownLevels = new WeakMap<Levels['surfaces'], readonly Level[]>();

/** The leaves that are level, from the lowest up. */
export function levelsOf(scene: Levels): readonly Level[] {
  const known = knownLevels.get(scene.surfaces);
  if (known) return known;
  const levels = findLevels(scene);
  knownLevels.set(scene.surfaces, levels);
  return levels;
}

function findLevels(scene: Levels): Level[] {
  const ranges = scene.surfaces.map(() => [Infinity, -Infinity] as [number, number]);
  const { surfaceOfPatch, patchCenter } = scene;
  for (let row = 0; row < surfaceOfPatch.length; row++) {
    const height = patchCenter[3 * row + 1]!;
    const range = ranges[surfaceOfPatch[row]!]!;
    range[0] = Math.min(range[0], height);
    range[1] = Math.max(range[1], height);
  }
  return ranges
    .flatMap(([low, high], leaf) => (high - low <= level ? [{ leaf, height: (low + high) / 2 }] : []))
    .sort((a, b) => a.height - b.height);
}

/**
 * The name of the surface that an area in plan is meant on: the measuring plane with points in it whose height is nearest to
 * `height` where that is given, else with most points; else the lowest level surface. null where it holds no point of any.
 */
export function surfaceUnder(
  scene: SceneInfo,
  outline: readonly Point2[],
  height: number | null = null,
): string | null {
  const found = levelsOf(scene)
    .map((each) => ({
      ...each,
      points: countedRows(scene, each.leaf).filter((row) => isInside(outline, placeOf(scene, row))).length,
    }))
    .filter(({ points }) => points > 0);
  const planes = found.filter(({ leaf }) => scene.surfaces[leaf]!.measuring);
  const cost = (each: (typeof found)[number]) =>
    height === null ? -each.points : Math.abs(each.height - height);
  const best = [...planes].sort((a, b) => cost(a) - cost(b))[0] ?? found[0];
  return best ? scene.surfaces[best.leaf]!.name : null;
}

/** What somebody may work at: level surfaces of furniture, by their names, with their heights and outlines. */
export function worktopsOf(
  scene: SceneInfo,
): { readonly name: string; readonly height: number; readonly outline: [number, number][] }[] {
  const levels = levelsOf(scene);
  const floor = levels[0]?.height ?? 0;
  return levels
    .filter(({ leaf, height }) => {
      const { measuring, area } = scene.surfaces[leaf]!;
      return !measuring && area < 12 && height - floor > lowest && height - floor < highest;
    })
    .map(({ leaf, height }) => ({
      name: scene.surfaces[leaf]!.name,
      height,
      outline: hullOf(scene, countedRows(scene, leaf)),
    }))
    .filter(({ outline }) => outline.length >= 3);
}

/** The convex outline of square patches, to the millimetre. */
function hullOf(scene: SceneInfo, rows: Uint32Array): [number, number][] {
  const round = (value: number) => Math.round(1000 * value) / 1000;
  const points = [...rows]
    .flatMap((row) => {
      const [x, z] = placeOf(scene, row);
      const half = Math.sqrt(scene.patchArea[row] ?? 0) / 2;
      return outlineOf([x - half, z - half, x + half, z + half]);
    })
    .map(([x, z]): [number, number] => [round(x), round(z)])
    .sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const chain = (list: readonly [number, number][]) => {
    const kept: [number, number][] = [];
    for (const point of list) {
      while (kept.length > 1 && turn(kept.at(-2)!, kept.at(-1)!, point) <= 1e-6) kept.pop();
      kept.push(point);
    }
    return kept.slice(0, -1);
  };
  return [...chain(points), ...chain(points.reverse())];
}

const turn = (a: Point2, b: Point2, c: Point2): number =>
  (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

/** "task 3": a name that neither a surface nor an area has. */
export function freeName(scene: SceneInfo, areas: readonly TaskArea[], wish = 'task'): string {
  const taken = new Set([...scene.surfaces, ...areas].map(({ name }) => name));
  for (let number = 1; ; number++) {
    const name = `${wish} ${number}`;
    if (!taken.has(name) && !taken.has(surroundOf(name))) return name;
  }
}

/** Cards that speak of none but the surfaces that there are after an area has gone. */
export function cardsWithout(cards: readonly Card[], gone: readonly string[]): Card[] {
  return cards.flatMap((card) => {
    const surfaces = card.surfaces.filter((name) => !gone.includes(name));
    if (surfaces.length === card.surfaces.length && !card.contrast?.over.some((name) => gone.includes(name)))
      return [card];
    const { contrast: _, ...rest } = card;
    return surfaces.length > 0 ? [{ ...rest, surfaces }] : [];
  });
}

/** Cards that speak of surfaces by their new names. */
export function cardsRenamed(cards: readonly Card[], names: ReadonlyMap<string, string>): Card[] {
  const renamed = (list: readonly string[]) => list.map((name) => names.get(name) ?? name);
  return cards.map(({ contrast, ...card }) => ({
    ...card,
    surfaces: renamed(card.surfaces),
    ...(contrast && { contrast: { ...contrast, over: renamed(contrast.over) } }),
  }));
}

/** U_o of a task, the band around it and the background (EN 12464-1). */
export const evenness = { task: 0.6, surround: 0.4, background: 0.1 };

/** lx of the band around a task and of the background (EN 12464-1): a step below the task, and a third of that. */
export function aroundTask(task: number): { readonly surround: number; readonly background: number } {
  const surround = task >= 750 ? 500 : task >= 500 ? 300 : task >= 300 ? 200 : Math.min(task, 200);
  return { surround, background: Math.round(surround / 3) };
}

/** The task areas of a room, to be drawn on what they are part of; `chosen`: the one of that name stands out. */
export function markedTasks(
  scene: SceneInfo,
  areas: readonly TaskArea[],
  chosen: string | null,
): MarkedArea[] {
  const heights = new Map(levelsOf(scene).map(({ leaf, height }) => [scene.surfaces[leaf]!.name, height]));
  return areas.map(({ name, surface, outline }) => ({
    kind: 'task',
    outline,
    height: heights.get(surface) ?? null,
    isStrong: name === chosen,
  }));
}

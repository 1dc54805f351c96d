/**
 * The light on a level surface as a raster: one value a cell of the lattice that its patches were cut by, read between
 * the cells by bilinear interpolation. Metres in plan (plan-frame.ts), lux.
 */
import { inPlan, type PlanFrame, type Point2 } from './plan-frame.ts';
import type { SceneInfo } from './types.ts';

export interface LightField {
  readonly origin: Point2; // middle of the first cell
  readonly pitch: Point2; // of the cells
  readonly columns: number; // to the east
  readonly rows: number; // to the north
  readonly height: number; // above the floor
  readonly values: Float32Array; // row by row from the south-west; NaN where no patch is, or something covers it
}

type Geometry = Pick<SceneInfo, 'surfaceOfPatch' | 'patchCenter' | 'patchArea' | 'patchCovered'>;

const flat = 0.01; // m: what differs less in height is level

/** null where the surface is not level, or too small to have a lattice. */
export function lightField(
  scene: Geometry,
  surface: number,
  light: ArrayLike<number>,
  frame: PlanFrame,
): LightField | null {
  const patches = [...scene.surfaceOfPatch.keys()].filter((row) => scene.surfaceOfPatch[row] === surface);
  const at = (row: number, axis: number) => scene.patchCenter[3 * row + axis] ?? Number.NaN;
  const places = patches.map((row) => inPlan(frame, [at(row, 0), at(row, 1), at(row, 2)]));
  if (places.length < 4) return null;
  const range = (axis: 0 | 1 | 2) =>
    places.reduce(
      ([low, high], place) => [Math.min(low, place[axis]), Math.max(high, place[axis])] as const,
      [Infinity, -Infinity] as const,
    );
  const [[west, east], [south, north], [bottom, top]] = [range(0), range(1), range(2)];
  if (top - bottom > flat) return null;
  const cell = Math.sqrt(median(patches.map((row) => scene.patchArea[row] ?? 0)));
  const count = (from: number, to: number) => Math.max(1, Math.round((to - from) / cell)) + 1;
  const [columns, rows] = [count(west, east), count(south, north)];
  const pitch: Point2 = [(east - west) / (columns - 1) || cell, (north - south) / (rows - 1) || cell];
  const sums = new Float64Array(columns * rows);
  const areas = new Float64Array(columns * rows);
  places.forEach(([x, y], i) => {
    const into = Math.round((y - south) / pitch[1]) * columns + Math.round((x - west) / pitch[0]);
    const area = scene.patchCovered[patches[i]!] === 1 ? 0 : (scene.patchArea[patches[i]!] ?? 0);
    sums[into] = sums[into]! + area * (light[patches[i]!] ?? 0);
    areas[into] = areas[into]! + area;
  });
  const values = Float32Array.from(sums, (sum, i) => (areas[i]! > 0 ? sum / areas[i]! : Number.NaN));
  return { origin: [west, south], pitch, columns, rows, height: (bottom + top) / 2, values };
}

/** Bilinear between the four cells around a place, of those that there are; NaN where there is none. */
export function lightAt({ origin, pitch, columns, rows, values }: LightField, [x, y]: Point2): number {
  const u = Math.min(columns - 1, Math.max(0, (x - origin[0]) / pitch[0]));
  const v = Math.min(rows - 1, Math.max(0, (y - origin[1]) / pitch[1]));
  const [column, row] = [Math.min(Math.floor(u), columns - 2), Math.min(Math.floor(v), rows - 2)].map((i) =>
    Math.max(0, i),
  ) as [number, number];
  let [sum, weights] = [0, 0];
  for (const [i, j] of [
    [0, 0],
    [1, 0],
    [0, 1],
    [1, 1],
  ] as const) {
    const value = values[Math.min(rows - 1, row + j) * columns + Math.min(columns - 1, column + i)]!;
    const weight = Math.abs(1 - i - (u - column)) * Math.abs(1 - j - (v - row));
    if (Number.isNaN(value) || weight === 0) continue;
    sum += weight * value;
    weights += weight;
  }
  return weights > 0 ? sum / weights : Number.NaN;
}

function median(values: readonly number[]): number {
  return [...values].sort((a, b) => a - b)[values.length >> 1] ?? 0;
}

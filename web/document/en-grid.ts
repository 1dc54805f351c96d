/**
 * The calculation grid of EN 12464-1 on a level rectangle: a rim is left out (0.5 m, or 15 % of the shorter side where
 * that is less), and points are at most p = 0.2 x 5^log10(d) m apart, d the longer side of what is left, or the shorter
 * one where they differ by a factor of two or more.
 */
import { lightAt, type LightField } from './light-field.ts';
import type { Point2 } from './plan-frame.ts';

const widestRim = 0.5; // m
const rimShare = 0.15; // of the shorter side
const widestSpacing = 10; // m

export interface EnGrid {
  readonly rim: number; // m
  readonly spacing: number; // m, the largest allowed
  readonly columns: number;
  readonly rows: number;
  readonly points: readonly Point2[]; // m from the corner of the rectangle
}

export function enGrid(length: number, width: number): EnGrid {
  const rim = Math.min(widestRim, rimShare * Math.min(length, width));
  const [inner, across] = [length - 2 * rim, width - 2 * rim];
  const [shorter, longer] = [Math.min(inner, across), Math.max(inner, across)];
  const d = longer >= 2 * shorter ? shorter : longer;
  const spacing = Math.min(widestSpacing, 0.2 * 5 ** Math.log10(d));
  const [columns, rows] = [inner, across].map((side) => Math.max(1, Math.ceil(side / spacing))) as [
    number,
    number,
  ];
  const points = Array.from({ length: columns * rows }, (_, i): Point2 => {
    const [column, row] = [i % columns, Math.floor(i / columns)];
    return [rim + ((column + 0.5) * inner) / columns, rim + ((row + 0.5) * across) / rows];
  });
  return { rim, spacing, columns, rows, points };
}

export interface GridReading {
  readonly grid: EnGrid;
  readonly mean: number; // E_m, lx
  readonly least: number; // E_min, lx
  readonly uniformity: number; // U_o
}

/** What the grid of a surface reads, bilinear from its patches; points without a patch are left out. null: no point. */
export function readGrid(field: LightField): GridReading | null {
  const { origin, pitch, columns, rows } = field;
  const grid = enGrid(columns * pitch[0], rows * pitch[1]);
  const corner = [origin[0] - pitch[0] / 2, origin[1] - pitch[1] / 2] as const;
  const values = grid.points
    .map(([x, y]) => lightAt(field, [corner[0] + x, corner[1] + y]))
    .filter((value) => !Number.isNaN(value));
  if (values.length === 0) return null;
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  const least = Math.min(...values);
  return { grid, mean, least, uniformity: mean > 0 ? least / mean : 0 };
}

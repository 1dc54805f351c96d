/** The calculation grid of EN 12464-1 and what it reads. */
import { describe, expect, test } from '@jest/globals';
import { enGrid, readGrid } from '../../../web/document/en-grid.ts';
import type { LightField } from '../../../web/document/light-field.ts';

/** A field of 5 x 4 m in cells of 0.25 m. */
function fieldOf(light: (x: number, y: number) => number): LightField {
  const [columns, rows, pitch] = [20, 16, 0.25];
  const values = Float32Array.from({ length: columns * rows }, (_, i) =>
    light((0.5 + (i % columns)) * pitch, (0.5 + Math.floor(i / columns)) * pitch),
  );
  return { origin: [0.125, 0.125], pitch: [pitch, pitch], columns, rows, height: 0.75, values };
}

describe('the grid', () => {
  test('of 5 x 4 m leaves 4 x 3 m, with 8 x 6 points at most 0.527 m apart', () => {
    const grid = enGrid(5, 4);
    expect(grid).toMatchObject({ rim: 0.5, columns: 8, rows: 6 });
    expect(grid.spacing).toBeCloseTo(0.527, 3);
    expect(grid.points).toHaveLength(48);
    expect(grid.points[0]).toEqual([0.75, 0.75]);
    expect(grid.points.at(-1)).toEqual([4.25, 3.25]);
  });

  test('of a small area keeps 15 % of its shorter side free', () => {
    expect(enGrid(1.6, 0.8).rim).toBeCloseTo(0.12);
  });

  test('of a long area goes by its shorter side, and is never wider than 10 m', () => {
    expect(enGrid(21, 5).spacing).toBeCloseTo(0.2 * 5 ** Math.log10(4));
    expect(enGrid(2000, 1500).spacing).toBe(10);
  });

  test('reads mean, least and evenness; a slope is read exactly', () => {
    const reading = readGrid(fieldOf((x) => 100 * x))!;
    expect(reading.mean).toBeCloseTo(250, 3);
    expect(reading.least).toBeCloseTo(75, 3);
    expect(reading.uniformity).toBeCloseTo(0.3, 5);
  });

  test('leaves out points where nothing is measured', () => {
    const reading = readGrid(fieldOf((x) => (x < 2.5 ? 200 : Number.NaN)))!;
    expect(reading.mean).toBeCloseTo(200);
    expect(readGrid(fieldOf(() => Number.NaN))).toBeNull();
  });
});

import { describe, expect, test } from '@jest/globals';
import {
  crossings,
  gridPatches,
  neighbours,
  type Plane,
} from '../../../../web/viewer/light/plane-readings.ts';

/** A plane of 4 x 2 m at 0.75 m with patches of 0.2 m; rows 3 onwards of a scene. */
function plane(): Plane & { at: (patch: number) => [number, number] } {
  const [columns, rows, first, edge] = [20, 10, 3, 0.2];
  const center = new Float32Array(3 * (first + columns * rows));
  const area = new Float32Array(first + columns * rows).fill(edge * edge);
  const patches: number[] = [];
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const patch = first + row * columns + column;
      center.set([(column + 0.5) * edge, 0.75, (row + 0.5) * edge], 3 * patch);
      patches.push(patch);
    }
  return { patches, center, area, at: (patch) => [center[3 * patch]!, center[3 * patch + 2]!] };
}

describe('readings on a plane', () => {
  const sheet = plane();

  test('stand one in each square of the grid, near its middle', () => {
    const picked = gridPatches(sheet, 1);
    expect(picked).toHaveLength(8);
    const cells = picked.map((patch) =>
      sheet
        .at(patch)
        .map((value) => Math.floor(value))
        .join(' '),
    );
    expect(new Set(cells).size).toBe(8);
    for (const patch of picked)
      for (const value of sheet.at(patch)) expect(Math.abs((value % 1) - 0.5)).toBeLessThan(0.21);
  });

  test('neighbours share a side', () => {
    const pairs = neighbours(sheet);
    expect(pairs).toHaveLength(19 * 10 + 20 * 9);
  });

  test('a level lies where the light has it', () => {
    const light = Array.from(sheet.area, (_, patch) => 100 * sheet.at(patch)[0]!); // 100 lx a metre along x
    const found = crossings(sheet, neighbours(sheet), light, [50, 300, 1000]);
    expect(found).toHaveLength(2 * 10);
    for (const { point, value } of found) expect(point[0]).toBeCloseTo(value / 100, 5);
    expect(crossings(sheet, neighbours(sheet), light.fill(50), [50])).toHaveLength(0);
  });
});

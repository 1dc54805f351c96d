/** Light as a raster and its isolux lines, against light that is known everywhere. Covers isolux-lines. */
import { describe, expect, test } from '@jest/globals';
import { isoluxLines } from '../../../web/document/isolux-lines.ts';
import { lightAt, lightField, type LightField } from '../../../web/document/light-field.ts';
import type { PlanFrame, Point2 } from '../../../web/document/plan-frame.ts';

const frame: PlanFrame = { west: 0, south: 4, floor: 0, size: [6, 4, 3] };

/** A level surface of 6 x 4 m at 0.75 m in squares of 0.5 m, lit by `light` of plan coordinates; some may be missing. */
function fieldOf(
  light: (x: number, y: number) => number,
  isThere = (_x: number, _y: number) => true,
): LightField {
  const places: Point2[] = [];
  for (let i = 0; i < 12; i++)
    for (let j = 0; j < 8; j++) {
      const [x, y] = [0.25 + 0.5 * i, 0.25 + 0.5 * j];
      if (isThere(x, y)) places.push([x, y]);
    }
  const scene = {
    surfaceOfPatch: Uint32Array.from(places, () => 1),
    patchArea: Float32Array.from(places, () => 0.25),
    patchCovered: new Uint8Array(0),
    patchCenter: Float32Array.from(places.flatMap(([x, y]) => [x, 0.75, 4 - y])),
  };
  const field = lightField(
    scene,
    1,
    places.map(([x, y]) => light(x, y)),
    frame,
  );
  if (!field) throw new Error('no field');
  return field;
}

describe('a field', () => {
  test('has the lattice of its patches', () => {
    const field = fieldOf(() => 1);
    expect(field).toMatchObject({ columns: 12, rows: 8, origin: [0.25, 0.25] });
    expect(field.pitch[0]).toBeCloseTo(0.5);
    expect(field.height).toBeCloseTo(0.75);
  });

  test('reads bilinear light exactly between its cells', () => {
    const light = (x: number, y: number) => 100 + 20 * x + 30 * y + 5 * x * y;
    const field = fieldOf(light);
    for (const [x, y] of [
      [1.1, 0.9],
      [0.25, 3.75],
      [4.6, 2.2],
    ] as const)
      expect(lightAt(field, [x, y])).toBeCloseTo(light(x, y), 3);
  });

  test('says nothing where it has no patch, and reads on beside the gap', () => {
    const field = fieldOf(
      () => 70,
      (x) => x < 3,
    );
    expect(field.columns).toBe(6);
    const holed = fieldOf(
      () => 70,
      (x, y) => !(x > 2 && x < 4 && y > 1 && y < 3),
    );
    expect(lightAt(holed, [3, 2])).toBeNaN();
    expect(lightAt(holed, [1.9, 2])).toBeCloseTo(70);
  });

  test('is not made of what is upright', () => {
    const scene = {
      surfaceOfPatch: Uint32Array.of(0, 0, 0, 0),
      patchArea: Float32Array.of(1, 1, 1, 1),
      patchCovered: new Uint8Array(0),
      patchCenter: Float32Array.of(0, 0.5, 0, 0, 1.5, 0, 0, 0.5, 1, 0, 1.5, 1),
    };
    expect(lightField(scene, 0, [1, 1, 1, 1], frame)).toBeNull();
  });
});

describe('isolux lines', () => {
  test('of light around a point are circles of the right radius', () => {
    const field = fieldOf((x, y) => 1000 - 300 * Math.hypot(x - 3, y - 2));
    const lines = isoluxLines(field, [700]);
    expect(lines).toHaveLength(1);
    const { points } = lines[0]!;
    expect(points[0]).toEqual(points.at(-1));
    for (const [x, y] of points) expect(Math.hypot(x - 3, y - 2)).toBeCloseTo(1, 1);
  });

  test('of light that falls in one direction run across, open at both ends', () => {
    const lines = isoluxLines(
      fieldOf((x) => 100 * x),
      [150, 250, 5000],
    );
    expect(lines.map(({ level }) => level)).toEqual([150, 250]);
    for (const { level, points } of lines) {
      expect(points).toHaveLength(8);
      for (const [x] of points) expect(x).toBeCloseTo(level / 100);
    }
  });

  test('of a saddle never cross', () => {
    const lines = isoluxLines(
      fieldOf((x, y) => 100 + 10 * Math.sign((x - 3) * (y - 2))),
      [100],
    );
    const places = lines.flatMap(({ points }) => points.map(String));
    expect(new Set(places).size).toBe(places.length);
    expect(lines).toHaveLength(2);
  });
});

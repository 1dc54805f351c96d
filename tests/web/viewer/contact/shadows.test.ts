/** The shadows that luminaires cast within a patch: where they fall, how strong they are, and that a patch keeps its mean. */
import { describe, expect, test } from '@jest/globals';
import { sampledGammas, sampledPlanes } from '../../../../web/document/photometry.ts';
import {
  latticeSize,
  placeOf,
  Solids,
  type Solid,
  type SolidPart,
} from '../../../../web/viewer/contact/lattice.ts';
import { openness } from '../../../../web/viewer/contact/openness.ts';
import { Shadows } from '../../../../web/viewer/contact/shadows.ts';
import type { LuminaireLight } from '../../../../web/viewer/types.ts';
import { rectangle } from './rectangle.ts';

/** A floor of 0.4 m and a screen across its middle, 0.4 m high and seen from both sides. */
const floor = rectangle(
  [
    [0, 0, 0],
    [0, 0, 0.4],
    [0.4, 0, 0],
  ],
  0,
);
const screen = [
  rectangle(
    [
      [0.2, 0, -0.1],
      [0, 0.4, 0],
      [0, 0, 0.6],
    ],
    1,
  ),
  rectangle(
    [
      [0.2, 0, -0.1],
      [0, 0, 0.6],
      [0, 0.4, 0],
    ],
    1,
  ),
];
const patchCenter = Float32Array.of(0.2, 0, 0.2, 0.2, 0.2, 0.2);

/** Hangs at the left, so that the right half of the floor is behind the screen. */
const light: LuminaireLight = {
  position: [-1, 1.2, 0.2],
  along: [1, 0, 0],
  across: [0, 0, 1],
  down: [0, -1, 0],
  size: [0.01, 0.01],
  flux: 1000,
  candela: null,
};

function cast(parts: readonly SolidPart[], lights: readonly LuminaireLight[]) {
  const room: Solid = { parts, patchCenter, edge: 0.2 };
  const solids = new Solids(room);
  const found = openness(solids);
  return { tiles: found.tiles, ...new Shadows(solids, found).cast(lights) };
}

/** S at the lattice places of the floor, by their x, m; the screen itself is left out. */
function onFloor({ tiles, values }: ReturnType<typeof cast>): { x: number; z: number; shadow: number }[] {
  const places = [];
  for (let t = 0; t < 2; t++) {
    const [first, cells] = [tiles[0]![2 * t]!, tiles[0]![2 * t + 1]!];
    expect(cells).toBeGreaterThan(0);
    for (let j = 0; j <= cells; j++)
      for (let i = 0; i <= cells - j; i++) {
        const [along, across] = [(0.4 * i) / cells, (0.4 * j) / cells];
        const [x, z] = t === 0 ? [across, along] : [0.4 - across, 0.4 - along];
        places.push({ x, z, shadow: values[first + placeOf(cells, i, j)]! });
      }
    expect(first + latticeSize(cells)).toBeLessThanOrEqual(values.length);
  }
  return places;
}

const lambertian = Float32Array.from({ length: sampledPlanes * sampledGammas }, (_, k) =>
  Math.max(0, 100 * Math.cos(((k % sampledGammas) * Math.PI) / 180)),
);

describe('shadows of luminaires', () => {
  test('before a screen there is none, behind it there is all that the luminaire would bring', () => {
    const places = onFloor(cast([floor, ...screen], [light]));
    for (const { x, shadow } of places.filter(({ x }) => x < 0.12)) expect([x, shadow]).toEqual([x, 0]);
    const behind = places.filter(({ x }) => x > 0.28);
    expect(behind.length).toBeGreaterThan(3);
    for (const { x, z, shadow } of behind) {
      const squared = (x + 1) ** 2 + 1.2 ** 2 + (z - 0.2) ** 2;
      expect(shadow / ((1000 / Math.PI) * (1.2 / squared) ** 2)).toBeCloseTo(1, 1.7);
    }
  });

  test('without a screen there is none', () => {
    const { values, means } = cast([floor], [light]);
    expect(Math.max(0, ...values)).toBe(0);
    expect([...means]).toEqual([0, 0]);
  });

  test('the mean of a patch is that of its places, and about half of them are behind', () => {
    const all = onFloor(cast([floor, ...screen], [light]));
    const { means } = cast([floor, ...screen], [light]);
    const behind = all.filter(({ x }) => x > 0.28).reduce((most, { shadow }) => Math.max(most, shadow), 0);
    expect(means[0]! / behind).toBeGreaterThan(0.35);
    expect(means[0]! / behind).toBeLessThan(0.6);
  });

  test('what arrives is what the luminaire would bring, without the shadow', () => {
    const { means, arriving } = cast([floor, ...screen], [light]);
    const open = [0.4 / 3, 0.8 / 3].map((at) => {
      const squared = (at + 1) ** 2 + 1.2 ** 2 + (at - 0.2) ** 2;
      return (1000 / Math.PI) * (1.2 / squared) ** 2;
    });
    expect(means[0]!).toBeGreaterThan(10);
    expect((arriving[0]! + means[0]!) / ((open[0]! + open[1]!) / 2)).toBeCloseTo(1, 2);
    const low = cast([floor, ...screen], [{ ...light, position: [0.3, 1.2, 0.2], down: [0, 1, 0] }]);
    expect(low.arriving[0]).toBe(0); // it shines away
  });

  test('a table that shines as a square does casts the same', () => {
    const one = cast([floor, ...screen], [light]);
    const other = cast([floor, ...screen], [{ ...light, candela: lambertian }]);
    expect(Math.max(...one.values)).toBeGreaterThan(10);
    one.values.forEach((value, k) => expect(other.values[k]! - value).toBeCloseTo(0, 1));
  });

  test('where a shadow ends a little beside the border of two triangles, both see the same there', () => {
    // Parallel to the diagonal, and 1.5 mm beyond it (2 mm above the floor): what its places see must not depend on their triangle.
    const board = [-0.4, 0, 0.6] as const;
    const [up, aslant] = [[0, 0.12294, 0] as const, [1, 0, -1] as const];
    const boards = [rectangle([board, up, aslant], 1), rectangle([board, aslant, up], 1)];
    const all = onFloor(cast([floor, ...boards], [{ ...light, position: [-0.8, 1.2, -0.8] }]));
    const onDiagonal = all.filter(({ x, z }) => Math.abs(x + z - 0.4) < 1e-6);
    expect(Math.max(...onDiagonal.map(({ shadow }) => shadow))).toBeGreaterThan(10);
    for (const { x, shadow } of onDiagonal)
      for (const other of onDiagonal)
        if (Math.abs(other.x - x) < 1e-6) expect(Math.abs(other.shadow / shadow - 1)).toBeLessThan(0.01);
  });

  test('luminaires add up, and what shines away from a place casts nothing there', () => {
    const once = cast([floor, ...screen], [light]).values;
    const thrice = cast([floor, ...screen], [light, { ...light, flux: 2000 }]).values;
    thrice.forEach((value, k) => expect(value).toBeCloseTo(3 * once[k]!, 3));
    const away = cast([floor, ...screen], [{ ...light, down: [0, 1, 0] }]).values;
    expect(Math.max(...away)).toBe(0);
  });
});

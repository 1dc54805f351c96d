/** Light within a patch: how open a floor is beside and under what stands on it. Covers contact-light's lattices, too. */
import { describe, expect, test } from '@jest/globals';
import { BufferAttribute, BufferGeometry } from 'three';
import { layTiles } from '../../../../web/viewer/contact/contact-light.ts';
import { latticeSize, Solids, type Solid, type SolidPart } from '../../../../web/viewer/contact/lattice.ts';
import { openness as opennessIn } from '../../../../web/viewer/contact/openness.ts';
import { rectangle } from './rectangle.ts';

const floor = rectangle(
  [
    [0, 0, 0],
    [0, 0, 0.2],
    [0.2, 0, 0],
  ],
  0,
);

/** A black box in the middle of the floor: four sides and a lid. */
const box = (
  [
    [
      [0.05, 0, 0.05],
      [0, 0, 0.1],
      [0, 0.1, 0],
    ],
    [
      [0.15, 0, 0.05],
      [0, 0.1, 0],
      [0, 0, 0.1],
    ],
    [
      [0.05, 0, 0.05],
      [0, 0.1, 0],
      [0.1, 0, 0],
    ],
    [
      [0.05, 0, 0.15],
      [0.1, 0, 0],
      [0, 0.1, 0],
    ],
    [
      [0.05, 0.1, 0.05],
      [0, 0, 0.1],
      [0.1, 0, 0],
    ],
  ] as const
).map((place) => rectangle(place, 1));
const patchCenter = Float32Array.of(0.1, 0, 0.1, 0.1, 0.1, 0.1);

const openness = (solid: Solid) => opennessIn(new Solids(solid));

describe('how open a place is', () => {
  test('a floor with nothing on it is left alone', () => {
    const found = openness({ parts: [floor], patchCenter, edge: 0.2 });
    expect([...found.tiles[0]!]).toEqual([0, 0, 0, 0]);
    expect(found.values).toHaveLength(0);
    expect([...found.means]).toEqual([1, 1]);
  });

  test('it is darker beside a box than away from it, and what is under the box counts for nothing', () => {
    const found = openness({ parts: [floor, ...box], patchCenter, edge: 0.2 });
    const [first, cells] = found.tiles[0]!;
    expect(cells).toBeGreaterThan(3);
    const [corner, ...others] = found.values.subarray(first!, first! + latticeSize(cells!));
    expect(corner).toBeGreaterThan(200);
    expect(Math.min(...others)).toBeLessThan(0.9 * corner!);
    // A quarter of the patch is covered, and the rest is in a shade that luminaires lighten.
    expect(found.means[0]).toBeGreaterThan(0.5);
    expect(found.means[0]).toBeLessThan(0.75);
  });

  test('what is under a tall box is as covered as what is under a low one, and under a sheet it is not', () => {
    const raised = (part: SolidPart, height: (y: number) => number) => ({
      ...part,
      positions: part.positions.map((x, i) => (i % 3 === 1 ? height(x) : x)),
    });
    const tall = box.map((part) => raised(part, (y) => 30 * y));
    expect(openness({ parts: [floor, ...tall], patchCenter, edge: 0.2 }).means[0]).toBeLessThan(0.75);
    const sheet = raised(box[4]!, () => 0.05); // seen from behind, but not from all round
    expect(openness({ parts: [floor, sheet], patchCenter, edge: 0.2 }).means[0]).toBeGreaterThan(0.75);
  });

  test('of a patch that lies wholly under a box nothing is seen', () => {
    const wide = box.map((part) => ({
      ...part,
      positions: part.positions.map((x, i) => (i % 3 === 1 ? x : 0.1 + 4 * (x - 0.1))),
    }));
    expect(openness({ parts: [floor, ...wide], patchCenter, edge: 0.2 }).means[0]).toBe(0);
  });

  test('what a box covers does not depend on how it lies to the lattice: its foot has no scallops', () => {
    const moved = (by: number) =>
      box.map((part) => ({ ...part, positions: part.positions.map((x, i) => (i % 3 === 1 ? x : x + by)) }));
    const of = (by: number) => openness({ parts: [floor, ...moved(by)], patchCenter, edge: 0.2 }).means[0]!;
    const means = [-0.02, -0.013, -0.006, 0.001, 0.008, 0.015, 0.022].map(of);
    expect(Math.max(...means) - Math.min(...means)).toBeLessThan(0.02);
  });
});

test('triangles with a lattice get corners of their own, and all keep their order', () => {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(floor.positions.slice(), 3));
  geometry.setIndex([...floor.index]);
  layTiles(geometry, Uint32Array.of(0, 0, 7, 2)); // the second one only
  expect([...geometry.index!.array]).toEqual([0, 1, 2, 4, 5, 6]);
  const { position, _lattice: lattice } = geometry.attributes;
  const places = [4, 5, 6].map((vertex) => [0, 1, 2].map((axis) => position!.getComponent(vertex, axis)));
  expect(places.flat()).toEqual(
    [3, 2, 1].flatMap((vertex) => [...floor.positions.subarray(3 * vertex, 3 * vertex + 3)]),
  );
  expect([...lattice!.array].slice(16)).toEqual([7, 2, 0, 0, 7, 2, 1, 0, 7, 2, 0, 1]);
  expect([...lattice!.array].slice(0, 16)).toEqual(Array.from({ length: 16 }, () => 0));
});

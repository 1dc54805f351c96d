import { expect, test } from '@jest/globals';
import type { SceneInfo } from '../../../../web/document/types.ts';
import { floorArea, powerOf, roomPlane } from '../../../../web/app/state/power.ts';

/** Two floors, the second in a storey, a table and two planes; statistics leave half of the first floor out. */
const scene = {
  surfaces: [
    { name: 'floor', area: 8, measuring: false },
    { name: 'upper/floor', area: 4, measuring: false },
    { name: 'table', area: 2, measuring: false },
    { name: 'reading place', area: 1, measuring: true },
    { name: 'working plane', area: 9, measuring: true },
  ] as unknown as SceneInfo['surfaces'],
  surfaceOfPatch: Uint32Array.of(0, 0, 1, 2, 3, 4),
  patchArea: Float32Array.of(8, 8, 4, 2, 1, 9),
  patchCenter: Float32Array.from([0, 0, 3, 0.7, 0.75, 0.8].flatMap((height) => [0, height, 0])),
  patchCovered: new Uint8Array(),
  provenance: {},
};

test('the floor is all of it, under furniture too', () => {
  expect(floorArea(scene)).toBe(20);
  const layout = { sites: [0, 1], flux: [1000, 3000], dimming: 0.5 };
  expect(powerOf(layout, scene, 100)).toEqual({ flux: 2000, watts: 20, floor: 20 });
});

test('the floor that the pipeline has found is the floor, and others are not where its name is another', () => {
  const asked = (surface: string) => ({ ...scene, provenance: { ask: { surface, mean: 300, count: 4 } } });
  expect(['floor', 'working plane', 'table'].map((name) => floorArea(asked(name)))).toEqual([20, 20, 2]);
});

test('under a plane that the pipeline asks of, the floor is the highest surface that is as large', () => {
  const surfaces = [
    { name: 'wall/floor', area: 80, measuring: false }, // of another storey
    { name: 'wall/top', area: 63, measuring: false },
    { name: 'table', area: 2, measuring: false },
    { name: 'working plane', area: 50, measuring: true },
    { name: 'ceiling', area: 60, measuring: false },
  ] as unknown as SceneInfo['surfaces'];
  const building = {
    surfaces,
    surfaceOfPatch: Uint32Array.of(0, 1, 2, 3, 4),
    patchArea: Float32Array.from(surfaces, ({ area }) => area),
    patchCenter: Float32Array.from([0.5, 2.5, 3.2, 3.3, 5].flatMap((height) => [0, height, 0])),
    patchCovered: new Uint8Array(),
    provenance: { ask: { surface: 'working plane', mean: 300, count: 4 } },
  };
  expect(floorArea(building)).toBe(63);
  const named = surfaces.map((each, leaf) => (leaf === 1 ? { ...each, name: 'floor' } : each));
  expect(floorArea({ ...building, surfaces: named })).toBe(143); // each says that it is one
});

test('a room that names no floor has no area of it', () => {
  expect(floorArea({ ...scene, surfaces: scene.surfaces.slice(2) })).toBeNull();
});

test('the largest plane speaks for the room where it measures much of the floor', () => {
  expect(roomPlane(scene)).toBe(4);
  const small = { ...scene, surfaces: scene.surfaces.slice(0, 4) };
  expect(roomPlane(small)).toBeNull();
  expect(roomPlane({ ...scene, surfaces: [] })).toBeNull();
});

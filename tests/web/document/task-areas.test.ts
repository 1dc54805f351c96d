/** Which points of a plane a task area, its band and the background are made of, and where areas come from. */
import { expect, test } from '@jest/globals';
import { isInside, outlineOf } from '../../../web/document/areas.ts';
import {
  aroundTask,
  cardsRenamed,
  cardsWithout,
  freeName,
  leafBehind,
  rectangleOf,
  surfaceUnder,
  withTaskAreas,
  worktopsOf,
} from '../../../web/document/task-areas.ts';
import { surfaceSetOf } from '../../../web/document/surface-names.ts';
import type { Card, SceneInfo, TaskArea } from '../../../web/document/types.ts';
import { patchesOf } from '../../../web/app/state/statistics.ts';

// A floor of 6 x 4 patches, a desk of 2 x 1 in its middle, and a plane over all of it; cells of half a metre.
const cell = 0.5;
const grid = (wide: number, deep: number, height: number, x = 0, z = 0) =>
  Array.from({ length: wide * deep }, (_, i) => [
    x + cell * ((i % wide) + 0.5),
    height,
    z + cell * (Math.floor(i / wide) + 0.5),
  ]);
const leaves = [
  { name: 'floor', measuring: false, places: grid(6, 4, 0) },
  { name: 'desk', measuring: false, places: grid(2, 1, 0.72, 1, 0.5) },
  { name: 'plane', measuring: true, places: grid(6, 4, 0.75) },
];
const places = leaves.flatMap((leaf) => leaf.places);
const scene = {
  surfaces: leaves.map(({ name, measuring, places: own }) => ({
    name,
    measuring,
    area: own.length * cell * cell,
    patches: own.length,
    reflectance: 0.5,
    lost: 0,
  })),
  surfaceOfPatch: Uint32Array.from(leaves.flatMap(({ places: own }, leaf) => own.map(() => leaf))),
  patchCenter: Float32Array.from(places.flat()),
  patchArea: Float32Array.from(places, () => cell * cell),
  patchCovered: Uint8Array.from(places, (_, row) => Number(row === 26)), // the first of the plane
} as unknown as SceneInfo;
const firstOfPlane = 26;

const task: TaskArea = { name: 'task 1', surface: 'plane', outline: outlineOf([1, 0.5, 2, 1]) };
const namesOf = ({ surfaces }: SceneInfo) => surfaces.slice(3).map(({ name }) => name);

test('an area, its band of half a metre and the background share the points of their plane', () => {
  const whole = withTaskAreas(scene, [task]);
  expect(namesOf(whole)).toEqual(['task 1', 'task 1 surround', 'plane background']);
  const rows = whole.surfaces
    .slice(3)
    .map(({ part }) => [...(part?.rows ?? [])].map((row) => row - firstOfPlane));
  expect(rows[0]).toEqual([8, 9]);
  expect(rows[1]).toEqual([2, 3, 7, 10, 14, 15].concat([1, 4, 13, 16]).sort((a, b) => a - b));
  expect(rows.flat().sort((a, b) => a - b)).toEqual([...Array(24).keys()].slice(1)); // the covered one is in none
  expect(whole.surfaces[3]).toMatchObject({ area: 0.5, patches: 2, measuring: true });
  expect(leafBehind(whole, 3)).toBe(2);
  expect([...patchesOf(whole, [3])]).toEqual([34, 35]);
  expect([...surfaceSetOf(['task 1'], whole.surfaces)]).toEqual([3]);
  expect([...surfaceSetOf(['all'], whole.surfaces)]).toEqual([]);
});

test('the same areas are made once, and what holds no point is left out', () => {
  expect(withTaskAreas(scene, undefined)).toBe(scene);
  expect(withTaskAreas(scene, [task])).toBe(withTaskAreas(scene, [structuredClone(task)]));
  const tiny = { ...task, outline: outlineOf([1.1, 0.6, 1.2, 0.7]) };
  expect(namesOf(withTaskAreas(scene, [tiny]))).toEqual(['task 1 surround', 'plane background']);
  expect(namesOf(withTaskAreas(scene, [{ ...task, surface: 'gone' }]))).toEqual([]);
});

test('a polygon holds what lies in it', () => {
  const corner = [[0, 0], [3, 0], [0, 2]] as const; // prettier-ignore
  expect(isInside(corner, [0.5, 0.5])).toBe(true);
  expect(isInside(corner, [2.5, 1.5])).toBe(false);
  const whole = withTaskAreas(scene, [{ ...task, outline: corner }]);
  expect(whole.surfaces[3]?.patches).toBe(11); // twelve but for the covered one
  expect(rectangleOf(corner)).toBeNull();
  expect(rectangleOf(outlineOf([1, 2, 3, 4]))).toEqual([1, 2, 3, 4]);
});

test('a desk is a task area on the plane above it', () => {
  expect(worktopsOf(scene)).toEqual([
    { name: 'desk', height: expect.closeTo(0.72, 5), outline: expect.anything() },
  ]);
  const outline = worktopsOf(scene)[0]!.outline;
  expect(new Set(outline.map(String))).toEqual(new Set(['1,0.5', '2,0.5', '2,1', '1,1']));
  expect(surfaceUnder(scene, outline, 0.72)).toBe('plane');
  expect(surfaceUnder(scene, outlineOf([8, 8, 9, 9]))).toBeNull();
});

test('names are free, and cards go with what they speak of', () => {
  expect(freeName(scene, [task])).toBe('task 2');
  const card = (surfaces: string[]): Card => ({ id: surfaces.join(), surfaces, verb: 'keep', weight: 1 });
  const left = cardsWithout([card(['task 1']), card(['task 1', 'floor']), card(['floor'])], ['task 1']);
  expect(left.map(({ surfaces }) => surfaces)).toEqual([['floor'], ['floor']]);
});

test('around a task the light goes down by the steps of the standard', () => {
  expect(aroundTask(750)).toEqual({ surround: 500, background: 167 });
  expect(aroundTask(500)).toEqual({ surround: 300, background: 100 });
  expect(aroundTask(150)).toEqual({ surround: 150, background: 50 });
});

test('cards follow an area to its new name, what it is compared with as well', () => {
  const cards: Card[] = [
    {
      id: 'a',
      surfaces: ['task 1', 'floor'],
      verb: 'keep',
      weight: 1,
      contrast: { over: ['task 1 surround'], min: 2 },
    },
    { id: 'b', surfaces: ['task 10'], verb: 'keep', weight: 1 },
  ];
  const names = new Map([['task 1', 'desk'], ['task 1 surround', 'desk surround']]); // prettier-ignore
  expect(cardsRenamed(cards, names)).toEqual([
    { ...cards[0], surfaces: ['desk', 'floor'], contrast: { over: ['desk surround'], min: 2 } },
    cards[1],
  ]);
});

// Where furniture gives way to a plane: over it, and not beside it (a sofa there left a dark hole in the plan).
import { expect, test } from '@jest/globals';
import { Box3, Vector3 } from 'three';
import {
  heightsOf,
  isBehind,
  isOverPlane,
  isPlaneAt,
} from '../../../../web/viewer/light/plane-footprints.ts';

/** A level rectangle as two triangles. */
const level = (x: number, z: number, farX: number, farZ: number, y: number) =>
  new Float32Array([x, y, z, farX, y, z, farX, y, farZ, x, y, z, farX, y, farZ, x, y, farZ]);

/** The heights of planes at a place, none left out. */
function at({ heights, frame }: ReturnType<typeof heightsOf>, x: number, z: number): number[] {
  const [column, row] = [Math.floor((x - frame[0]) * frame[2]), Math.floor((z - frame[1]) * frame[3])];
  if (column < 0 || row < 0 || column >= 256 || row >= 256) return [];
  const first = 4 * (row * 256 + column);
  return Array.from(heights.subarray(first, first + 4)).filter((height) => height < 1e6);
}

test('a plane has its height where it lies, and none beside it', () => {
  const map = heightsOf([level(1, 1, 3, 2, 0.75), level(5, 4, 6, 5, 0.75)], 0);
  expect(at(map, 2, 1.5)).toEqual([0.75]);
  expect(at(map, 5.5, 4.5)).toEqual([0.75]);
  expect([at(map, 4, 1.5), at(map, 2, 3), at(map, 0.5, 1.5)]).toEqual([[], [], []]);
});

test('planes of several heights lie in one map, and what lies underfoot or upright in none', () => {
  const wall = new Float32Array([0, 0, 0, 4, 0, 0, 4, 2, 0]);
  const map = heightsOf([level(0, 0, 4, 4, 1.25), level(0, 0, 2, 4, 0.75), level(0, 0, 4, 4, 0.02), wall], 0);
  expect(at(map, 1, 1)).toEqual([0.75, 1.25]);
  expect(at(map, 3, 1)).toEqual([1.25]);
  expect(at(heightsOf([wall], 0), 1, 0)).toEqual([]);
});

test('a number of the plane is not written on a cabinet that stands before it', () => {
  const cabinet = new Box3(new Vector3(1, 0, 3), new Vector3(2, 1.2, 3.4));
  const eye = new Vector3(1.5, 2, 6);
  expect(isBehind([cabinet], eye, new Vector3(1.5, 0.75, 2.5))).toBe(true);
  expect(isBehind([cabinet], eye, new Vector3(3, 0.75, 2.5))).toBe(false);
  expect(isBehind([cabinet], eye, new Vector3(1.5, 1.3, 4))).toBe(false);
  const map = heightsOf([level(0, 0, 4, 2.6, 0.75)], 0);
  expect([isPlaneAt(map, 1.5, 2.5), isPlaneAt(map, 1.5, 3.2)]).toEqual([true, false]);
});

test('furniture gives way over a plane and hardly below it, and nowhere beside it', () => {
  const map = heightsOf([level(0, 0, 4, 2.6, 0.75)], 0);
  const gives = (x: number, y: number, z: number) => isOverPlane(map, new Vector3(x, y, z));
  expect([gives(1, 1.1, 1), gives(1, 0.72, 1), gives(1, 0.6, 1)]).toEqual([true, true, false]);
  expect([gives(1, 3, 1), gives(1, 1.1, 2.9)]).toEqual([false, false]);
});

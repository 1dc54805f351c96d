import { describe, expect, test } from '@jest/globals';
import {
  nearestFreeSite,
  nextFreeSite,
  takenSites,
} from '../../../../web/viewer/luminaires/site-snapping.ts';

// A grid of 4 x 3 sites at 3 m, site = 4 z + x.
const positions = new Float32Array(
  Array.from({ length: 12 }, (_, site) => [site % 4, 3, Math.floor(site / 4)]).flat(),
);
const eye = [1.5, 0, 1] as const;
const towards = (x: number, z: number): [number, number, number] => {
  const offset = [x - eye[0], 3, z - eye[2]];
  const length = Math.hypot(...offset);
  return [offset[0]! / length, offset[1]! / length, offset[2]! / length];
};

describe('the nearest free site', () => {
  test('is the one that the ray meets', () => {
    expect(nearestFreeSite(positions, new Set(), eye, towards(2.1, 1.2))).toBe(6);
    expect(nearestFreeSite(positions, new Set(), eye, towards(9, 9))).toBe(11);
  });

  test('is never a taken one', () => {
    expect(nearestFreeSite(positions, new Set([6]), eye, towards(2.1, 1.3))).toBe(10);
    expect(nearestFreeSite(positions, new Set(Array(12).keys()), eye, towards(2, 1))).toBeNull();
  });

  test('is in front of the eye, except in a plan where the eye is anywhere', () => {
    expect(nearestFreeSite(positions, new Set(), eye, [0, -1, 0])).toBeNull();
    expect(nearestFreeSite(positions, new Set(), [3.2, 50, 0.1], [0, -1, 0], true)).toBe(3);
  });
});

describe('the next free site', () => {
  test('lies straight ahead and skips the taken ones', () => {
    expect(nextFreeSite(positions, new Set(), 5, [1, 0, 0])).toBe(6);
    expect(nextFreeSite(positions, new Set([6]), 5, [1, 0, 0])).toBe(7);
    expect(nextFreeSite(positions, new Set(), 5, [0, 0, -2])).toBe(1);
  });

  test('is none at the edge', () => {
    expect(nextFreeSite(positions, new Set(), 3, [1, 0, 0])).toBeNull();
  });
});

test('taken are the sites of the others and the excluded ones', () => {
  expect([...takenSites({ sites: [4, 5, 6] }, [1], [9])].sort()).toEqual([4, 6, 9]);
  const row = { sites: [4, 5, 6], ties: [0, 0, 1] };
  expect([...takenSites(row, [1], [9])].sort()).toEqual([6, 9]);
  expect([...takenSites(row, [1, 2], [9])]).toEqual([9]);
});

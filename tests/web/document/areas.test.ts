/** Which sites areas in plan and a distance to walls leave out. */
import { expect, test } from '@jest/globals';
import {
  areaBetween,
  barredSites,
  clippedTo,
  luminairesIn,
  noAreas,
  wallDistance,
} from '../../../web/document/areas.ts';
import type { Areas } from '../../../web/document/types.ts';
import { fakePlan } from '../fake-viewer.ts';
import { fakeScene } from '../fake-solver.ts';

const { sites } = fakeScene(); // 4 x 4, a metre apart, number x + 4 z
const barred = (areas: Partial<Areas>, excluded: number[] = [], pinned: number[] = []) =>
  [...barredSites({ excluded, pinned, areas: { ...noAreas, ...areas } }, sites, fakePlan)].sort(
    (a, b) => a - b,
  );

test('what an area keeps free is left out, what it keeps to is all there is', () => {
  const corner = areaBetween([1.2, 1.1], [-0.5, -0.5]);
  expect(corner).toEqual([-0.5, -0.5, 1.2, 1.1]);
  expect(barred({ keepOut: [corner] })).toEqual([0, 1, 4, 5]);
  expect(barred({ keepIn: [corner] })).toEqual([2, 3, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15]);
  expect(barred({ keepIn: [corner], keepOut: [[0.9, 0.9, 2, 2]] })).toContain(5);
});

test('an area may be drawn by its corners, and its edge is in it', () => {
  const half = [[-0.5, -0.5], [3, 0], [0, 3]] as const; // prettier-ignore
  expect(barred({ keepOut: [half] })).toEqual([0, 1, 2, 3, 4, 5, 6, 8, 9, 12]);
  expect(barred({ keepIn: [half], keepOut: [[-1, -1, 0.5, 5]] })).toEqual([
    0, 4, 7, 8, 10, 11, 12, 13, 14, 15,
  ]);
});

test('places kept free by hand stay so, and a pinned luminaire stays where it is', () => {
  expect(barred({ keepOut: [[-1, -1, 1, 0.5]] }, [9], [1])).toEqual([0, 9]);
  const excluded = [3];
  expect(barredSites({ excluded, pinned: [] }, sites, fakePlan)).toBe(excluded);
});

test('a distance to walls leaves the middle', () => {
  expect(wallDistance([0.5, 2], fakePlan.outlines)).toBe(0.5);
  expect(wallDistance([-3, -4], fakePlan.outlines)).toBe(5);
  const middle = [5, 6, 9, 10];
  const all = [...sites.size.keys()];
  expect(barred({ fromWalls: 0.6 })).toEqual(all.filter((site) => !middle.includes(site)));
  expect(barred({ fromWalls: 0.5 })).toEqual([]);
});

test('an area holds the luminaires that hang in it', () => {
  const layout = { sites: [0, 5, 9, 15], flux: [1, 1, 1, 1], dimming: 1 };
  expect(luminairesIn([-1, -1, 1.5, 1.5], layout, sites)).toEqual([0, 1]);
});

test('what is drawn beyond a rectangle is cut off; what lies in it stays as it is', () => {
  const within = [[1, 1], [3, 1], [2, 2.5]] as const; // prettier-ignore
  expect(clippedTo(within, [0, 0, 4, 3])).toEqual(within);
  expect(clippedTo(within, [1, 1, 3, 2.5])).toEqual(within); // to its edges
  const beyond = [[-1, 1], [2, 1], [2, 5], [-1, 5]] as const; // prettier-ignore
  const cut = clippedTo(beyond, [0, 0, 4, 3]);
  expect([...cut].sort(([a, b], [c, d]) => a - c || b - d)).toEqual([[0, 1], [0, 3], [2, 1], [2, 3]]); // prettier-ignore
  expect(clippedTo([[5, 5], [6, 5], [6, 6]], [0, 0, 4, 3])).toEqual([]); // prettier-ignore
});

/** Names of leaves, of inner nodes, and 'all'. */
import { expect, test } from '@jest/globals';
import { resolveSurfaces } from '../../../web/solver/resolve-surfaces.ts';

const leaves = ['room/floor', 'room/ceiling', 'desk', 'desk 2/top', 'desk 2/legs', 'plane'].map((name) => ({
  name,
  measuring: name === 'plane',
}));
const resolve = (...names: string[]) => [...resolveSurfaces(names, leaves)];

test('a leaf, an inner node, and their union without repeats', () => {
  expect(resolve('desk')).toEqual([2]);
  expect(resolve('room')).toEqual([0, 1]);
  expect(resolve('desk 2', 'room/floor', 'room')).toEqual([0, 1, 3, 4]);
});

test('all is the empty set of the core; beside another name it is spelled out', () => {
  expect(resolve('all')).toEqual([]);
  expect(resolve('all', 'plane')).toEqual([0, 1, 2, 3, 4, 5]);
  expect(resolve('all', 'desk')).toEqual([0, 1, 2, 3, 4]);
});

test('an unknown name is refused with the names that there are', () => {
  expect(() => resolve('desk', 'wall')).toThrow(/no surface "wall".*"room\/floor"/);
  expect(() => resolve('roo')).toThrow(/no surface "roo"/);
});

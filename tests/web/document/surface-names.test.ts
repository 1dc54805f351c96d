/** Names of leaves, of inner nodes, and 'all': the core's rule is precompute's, with the same one form of 'all'. */
import { expect, test } from '@jest/globals';
import { leavesOf, surfaceSetOf } from '../../../web/document/surface-names.ts';

const leaves = ['room/floor', 'room/ceiling', 'desk', 'desk 2/top', 'desk 2/legs', 'plane'].map((name) => ({
  name,
  measuring: name === 'plane',
}));
const resolve = (...names: string[]) => [...surfaceSetOf(names, leaves)];

test('a leaf, an inner node, and their union without repeats', () => {
  expect(resolve('desk')).toEqual([2]);
  expect(resolve('room')).toEqual([0, 1]);
  expect(resolve('desk 2', 'room/floor', 'room')).toEqual([0, 1, 3, 4]);
});

test('all is the empty set of the core, however it is spelled', () => {
  expect(resolve('all')).toEqual([]);
  expect(resolve('room', 'desk', 'desk 2')).toEqual([]);
  expect(resolve()).toEqual([]);
  expect(resolve('all', 'plane')).toEqual([0, 1, 2, 3, 4, 5]);
  expect(resolve('all', 'desk')).toEqual([]);
});

test('the page gets every leaf, and none for a name that is not there', () => {
  expect(leavesOf(['all'], leaves)).toEqual([0, 1, 2, 3, 4]);
  expect(leavesOf(['desk 2', 'plane', 'wall'], leaves)).toEqual([3, 4, 5]);
});

test('an unknown name is refused with the names that there are', () => {
  expect(() => resolve('desk', 'wall')).toThrow(/no surface "wall".*"room\/floor"/);
  expect(() => resolve('roo')).toThrow(/no surface "roo"/);
});

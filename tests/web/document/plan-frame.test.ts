/** The one mapping between the room's axes and a designer's coordinates. */
import { expect, test } from '@jest/globals';
import {
  inPlan,
  inRoom,
  placeText,
  twiceArea,
  type PlanFrame,
  sideOf,
} from '../../../web/document/plan-frame.ts';

const frame: PlanFrame = { west: -2, south: 5, floor: 0.5, size: [6, 8, 3] };

test('x runs to the east, y to the north, z up, from the south-west corner of the floor', () => {
  expect(inPlan(frame, [-2, 0.5, 5])).toEqual([0, 0, 0]);
  expect(inPlan(frame, [1, 3.3, -3])).toEqual([3, 8, 2.8]);
});

test('the way back is exact', () => {
  expect(inRoom(frame, inPlan(frame, [1.25, 2.75, -0.5]))).toEqual([1.25, 2.75, -0.5]);
});

test('places are written to the centimetre, never as minus zero', () => {
  expect(placeText([1.236, -0.001, 2.8])).toBe('1.24, 0.00, 2.80');
});

test('a loop that runs counter-clockwise has a positive area', () => {
  const square = [
    [0, 0],
    [2, 0],
    [2, 3],
    [0, 3],
  ] as const;
  expect(twiceArea(square)).toBe(12);
  expect(twiceArea([...square].reverse())).toBe(-12);
});

test('a side of the room is told of a direction that points straight to it', () => {
  expect(sideOf([1, 0, 0])).toBe('east');
  expect(sideOf([0, 0, -1])).toBe('north');
  expect(sideOf([Math.SQRT1_2, 0, Math.SQRT1_2])).toBeNull();
});

/** Rows of furniture and typed sizes, as the room maker takes them. */
import { expect, test } from '@jest/globals';
import { outlines } from '../../../web/room-maker/plan-shapes.mjs';
import { planFaults } from '../../../web/room-maker/plan-faults.mjs';
import { extentOf, resized, withRows } from '../../../web/room-maker/plan-edits.ts';
import { planOf, usualItem, type Point } from '../../../web/room-maker/room-plan.mjs';

const fourDesks = { across: 2, down: 2, acrossPitch: 2, downPitch: 2 };

function rowsFrom(at: Point, turn = 0, outline = outlines.rectangle(6, 4)) {
  const desk = { ...usualItem('desk', at, 2.8), turn };
  return withRows({ ...planOf(outline, 2.8), items: [desk] }, 0, fourDesks);
}
const places = ({ items }: ReturnType<typeof rowsFrom>) => items.map(({ x, z }): Point => [x, z]);

test('rows begin with the piece that is repeated', () => {
  expect(places(rowsFrom([1, 1]))).toEqual([[1, 1], [3, 1], [1, 3], [3, 3]]); // prettier-ignore
  expect(places(rowsFrom([0.8, 0.4]))[0]).toEqual([0.8, 0.4]); // at the walls
});

test('rows that would leave the room move into it as one, midway between the walls', () => {
  const plan = rowsFrom([2, 2]);
  expect(planFaults(plan)).toEqual([]);
  expect(places(plan)).toEqual([[2, 1], [4, 1], [2, 3], [4, 3]]); // prettier-ignore
  expect(planFaults(rowsFrom([2.5, 2], 90, outlines.L(9, 8)))).toEqual([]);
});

test('rows of workplaces move into the room with their chairs', () => {
  const workplace = usualItem('workplace', [1, 2.5], 2.8);
  const plan = { ...planOf(outlines.rectangle(6, 4), 2.8), items: [workplace] };
  const { items } = withRows(plan, 0, { across: 2, down: 1, acrossPitch: 2, downPitch: 1 });
  expect(items[0]!.z).toBe(2.5); // its chair still fits
  const late = withRows({ ...plan, items: [{ ...workplace, z: 3.4 }] }, 0, { across: 2, down: 1, acrossPitch: 2, downPitch: 1 }); // prettier-ignore
  expect(planFaults(late)).toEqual([]);
});

test('rows for which the room is too small stay where they were asked for', () => {
  expect(places(rowsFrom([1, 1], 0, outlines.rectangle(3, 2)))[0]).toEqual([1, 1]);
});

test('a typed size keeps the shape of the room', () => {
  const l = resized(outlines.L(6, 4, 2, 1), [12, 9]);
  expect(extentOf(l)).toEqual([12, 9]);
  expect(l).toEqual(outlines.L(12, 9, 4, 2.25));
  expect(resized([[1, 1], [4, 1], [2, 3]], [6, 4])).toEqual([[1, 1], [7, 1], [3, 5]]); // prettier-ignore
  expect(resized(outlines.rectangle(6, 4), [7, 3])).toEqual(outlines.rectangle(7, 3));
});

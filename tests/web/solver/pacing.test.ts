/** Slices that take as long as wished, whatever a unit of work costs. */
import { expect, test } from '@jest/globals';
import { Slicer } from '../../../web/solver/pacing.ts';

/** A slicer on a machine of so many units a millisecond, and the amounts that it was asked for. */
function slicerAt(speed: number, first: number) {
  let now = 0;
  const amounts: number[] = [];
  const slicer = new Slicer(() => now, first);
  const run = (milliseconds?: number, left?: number) =>
    slicer.run(
      (amount) => {
        amounts.push(amount);
        now += amount / speed;
      },
      milliseconds,
      left,
    );
  return { slicer, run, amounts };
}

test('a slice grows to the wished time, at most fourfold at once', () => {
  const { run, amounts } = slicerAt(1000, 100);
  for (let i = 0; i < 5; i++) run(3);
  expect(amounts).toEqual([100, 400, 1600, 3000, 3000]);
});

test('a slice that took too long is followed by one that does not', () => {
  const { run, amounts } = slicerAt(10, 1000);
  run(3);
  run(3);
  expect(amounts).toEqual([1000, 30]);
});

test('what is left bounds a slice but not the next one', () => {
  const { run, amounts, slicer } = slicerAt(1000, 1000);
  run(2, 50);
  run(2);
  expect(amounts).toEqual([50, 2000]);
  expect(slicer.milliseconds).toBeCloseTo(2.05);
});

test('a clock that does not move leaves a slice bounded', () => {
  const { run, amounts } = slicerAt(Infinity, 1000);
  for (let i = 0; i < 9; i++) run(1000);
  expect(Math.max(...amounts)).toBe(200_000);
});

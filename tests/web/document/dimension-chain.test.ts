/** The chains of distances of the report's plan. Covers dimension-chain. */
import { expect, test } from '@jest/globals';
import { chainOf } from '../../../web/document/dimension-chain.ts';

const frame = { west: -2, south: 3, floor: 0, size: [4, 3, 2.8] } as const;

test('a field is measured from wall to luminaire to wall, once for each row and column', () => {
  const field = [0.5, 1.5, 2.5].flatMap((y) => [1, 3].map((x) => [x, y, 2.8] as const));
  expect(chainOf(field, frame, 0)).toEqual([
    { at: 0, from: null },
    { at: 1, from: 0.5 },
    { at: 3, from: 0.5 },
    { at: 4, from: null },
  ]);
  expect(chainOf(field, frame, 1).map(({ at, from }) => [at, from])).toEqual([
    [0, null],
    [0.5, 1],
    [1.5, 1],
    [2.5, 1],
    [3, null],
  ]);
});

test('what is written adds up to the room, to the centimetre; a luminaire on a wall is no stop of its own', () => {
  const thirds = [0, 4 / 3, 8 / 3].map((x) => [x, 1] as const);
  const stops = chainOf(thirds, frame, 0).map(({ at }) => at);
  expect(stops).toEqual([0, 1.33, 2.67, 4]);
  const written = stops.slice(1).map((at, i) => Number((at - stops[i]!).toFixed(2)));
  expect(written.reduce((sum, gap) => sum + gap, 0)).toBeCloseTo(4, 9);
});

test('luminaires a hair apart are one row', () => {
  const row = [[1, 1.001], [2, 1.0], [3, 0.999]] as const; // prettier-ignore
  expect(chainOf(row, frame, 1).map(({ at }) => at)).toEqual([0, 1, 3]);
});

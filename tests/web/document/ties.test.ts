import { expect, test } from '@jest/globals';
import { movedSites, tieOf } from '../../../web/document/ties.ts';

// A line of five places, 0.6 m apart, and one of them 2 m beside it.
const positions = Float32Array.from([0, 1, 2, 3, 4].flatMap((i) => [0.6 * i, 3, 0]).concat([0, 3, 2]));
const rows = { sites: [0, 1, 5], ties: [0, 0, 1] };

test('a luminaire belongs to its tie, or to nobody', () => {
  expect(tieOf(rows, 0)).toEqual([0, 1]);
  expect(tieOf({ sites: [0, 1] }, 1)).toEqual([1]);
});

test('a row goes as it is, onto its own places too', () => {
  expect(movedSites(rows, 0, 1, 'rows', positions)).toEqual([1, 2, 5]);
  expect(movedSites(rows, 1, 4, 'field', positions)).toEqual([3, 4, 5]);
});

test('where one of a row finds no place, none goes', () => {
  expect(movedSites(rows, 0, 4, 'rows', positions)).toBeNull();
  expect(movedSites(rows, 0, 5, 'rows', positions)).toBeNull();
});

test('free luminaires and mirrored ones go alone, but not onto another', () => {
  expect(movedSites(rows, 0, 3, 'symmetric', positions)).toEqual([3, 1, 5]);
  expect(movedSites({ sites: [0, 1] }, 0, 1, 'free', positions)).toBeNull();
});

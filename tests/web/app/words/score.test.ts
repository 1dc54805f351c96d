/** The score of a layout by hand, and what is said of it. */
import { describe, expect, test } from '@jest/globals';
import { boundText, highestScore, outcomeText, scoreOf, type Best } from '../../../../web/app/words/score.ts';
import type { Goal } from '../../../../web/document/types.ts';

const result = (value: number, met = true) => ({ value, met, violation: met ? 0 : 0.1, margin: 0 });
const reached = (values: number[], violation = 0) => ({
  goals: values.map((value) => result(value)),
  constraints: [result(1, violation === 0)],
  violation,
});
const goal = (sense: Goal['sense'], weight = 1, target?: number): Goal => ({
  statistic: sense === 'min' ? 'sigma' : 'mean',
  sense,
  weight,
  surfaces: ['all'],
  ...(target !== undefined && { target }),
});
const best = (values: number[], gap: number | null = null, violation = 0): Best => ({
  shown: reached(values, violation),
  gap,
});

test('the solver’s own layout scores 100, whatever is asked', () => {
  for (const goals of [[goal('max')], [goal('min')], [goal('near', 10, 500), goal('min')], []])
    expect(scoreOf(goals, reached([3, 4]), best([3, 4]))).toBeCloseTo(100);
});

test('more counts where most is asked for, less where least is, and nearness to a target', () => {
  expect(scoreOf([goal('max')], reached([270]), best([300]))).toBeCloseTo(90);
  expect(scoreOf([goal('min')], reached([50]), best([40]))).toBeCloseTo(80);
  expect(scoreOf([goal('near', 1, 500)], reached([0.3]), best([0.1]))).toBeCloseTo(80);
  expect(scoreOf([goal('max', 3), goal('min', 1)], reached([300, 80]), best([300, 40]))).toBeCloseTo(87.5);
});

test('bounds that only the solver meets take off, by as much as they are missed', () => {
  expect(scoreOf([goal('max')], reached([300], 0.25), best([300]))).toBeCloseTo(75);
});

test('what is proved of one goal is a bound on the score', () => {
  expect(highestScore([goal('max')], best([300], 0.04))).toBeCloseTo(104);
  expect(highestScore([goal('min')], best([40], 0.2))).toBeCloseTo(125);
  expect(highestScore([goal('max'), goal('min')], best([300, 40], 0.04))).toBeNull();
  expect(boundText([goal('max')], best([300], 0.04))).toMatch(/above 104: that is proved/);
  expect(boundText([goal('max'), goal('min')], best([1, 1], 0.04))).toMatch(/more than 4 %/);
  expect(boundText([goal('max')], best([300]))).toMatch(/not been proved/);
});

describe('one sentence for each outcome', () => {
  test.each([
    [87, reached([1]), best([1]), 'The solver’s layout is better by 13 points.'],
    [100.2, reached([1]), best([1]), 'As good as the solver’s layout, to half a point.'],
    [103, reached([1]), best([1]), /^You beat the solver/],
    [90, reached([1], 0.1), best([1]), '1 bound not met, which the solver’s layout meets.'],
    [90, reached([1], 0.2), best([1], null, 0.1), /yours misses them by more/],
    [90, reached([1], 0.1), best([1], null, 0.2), /yours comes nearer/],
    [90, reached([1]), best([1], null, 0.2), /meets every bound, the solver’s does not/],
  ])('%d', (score, own, against, text) => expect(outcomeText(score, own, against)).toMatch(text));
});

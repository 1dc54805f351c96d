/** When a bound counts as met on the screen. */
import { expect, test } from '@jest/globals';
import { withNearMisses } from '../../../../web/app/words/near-miss.ts';
import type { Constraint } from '../../../../web/document/types.ts';
import type { Shown } from '../../../../web/solver/protocol.ts';

const light: Shown = {
  layout: { sites: [], flux: [], dimming: 1 },
  illuminance: new Float32Array(),
  surfaces: [],
  goals: [],
  constraints: [],
  goal: 0,
  violation: 0,
  observers: [],
  grids: [],
  planes: [],
};
const missedBy = (violation: number) => ({ value: 1, met: false, violation, margin: -violation });
const verdictOn = (statistic: Constraint['statistic'], violation: number) =>
  withNearMisses({ ...light, constraints: [missedBy(violation)], violation }, [
    { statistic, surfaces: ['floor'], min: 1 },
  ]);

test('a bound that is missed by a thousandth is met, and its margin is still told', () => {
  const shown = verdictOn('mean', 0.001);
  expect(shown.constraints).toEqual([{ value: 1, met: true, violation: 0, margin: -0.001 }]);
  expect(shown.violation).toBe(0);
});

test('a bound that is missed by more is not', () => {
  const shown = verdictOn('chebyshev', 0.0011);
  expect(shown.constraints[0]?.met).toBe(false);
  expect(shown.violation).toBe(0.0011);
});

test('what is asked of every patch stays strict', () => {
  for (const statistic of ['minimum', 'maximum', 'uniformity'] as const)
    expect(verdictOn(statistic, 1e-5).constraints[0]?.met).toBe(false);
});

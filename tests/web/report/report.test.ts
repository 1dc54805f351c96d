/** What the report says of the rules that luminaires hang by. */
import { expect, test } from '@jest/globals';
import { rulesText } from '../../../web/report/report.ts';
import { sixLuminaires as free } from '../six-luminaires.ts';

test('the rules that luminaires hang by are one sentence, and none where there are none', () => {
  expect(rulesText(free)).toEqual([]);
  expect(rulesText({ ...free, arrangement: { rule: 'rows' }, minDistance: 1.8 })).toEqual([
    'Luminaires hang by rule: in rows, at least 1.8 m apart.',
  ]);
  const areas = { keepOut: [[0, 0, 1, 1]], keepIn: [], fromWalls: 0.5 } as const;
  expect(rulesText({ ...free, areas })).toEqual([
    'Luminaires hang by rule: at least 0.5 m from walls, as areas in plan leave them room.',
  ]);
});

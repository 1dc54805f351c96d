/** What the report says of the rules that luminaires hang by, and of energy. */
import { expect, test } from '@jest/globals';
import { energyText, rulesText } from '../../../web/report/report.ts';
import { usualEnergy } from '../../../web/document/energy.ts';
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

test('energy is told with what it is reckoned by, where there is a floor', () => {
  const power = { flux: 48_000, watts: 400, floor: 80 };
  expect(energyText(power, { ...usualEnergy, occupancy: 0.9, standby: 1.5 })).toEqual([
    'LENI 12.8 kWh/(m² a) by EN 15193-1: 2250 + 250 h by day and night; Fₒ, F_c, F_D 0.90, 1.00, 1.00; standby 1.5 kWh/(m² a).',
  ]);
  expect(energyText({ ...power, floor: null }, usualEnergy)).toEqual([]);
});

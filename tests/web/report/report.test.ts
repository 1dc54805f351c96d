/** What the report says of the rules that luminaires hang by, of energy, and of how it was computed. */
import { afterEach, expect, jest, test } from '@jest/globals';
import { energyText, reportOf, rulesText, splitAtIndices, verdictText } from '../../../web/report/report.ts';
import { usualEnergy } from '../../../web/document/energy.ts';
import { speak } from '../../../web/language/language.ts';
import { appInRoom } from '../app-in-room.ts';
import { fakeScene } from '../fake-solver.ts';
import { sixLuminaires as free } from '../six-luminaires.ts';

afterEach(() => void jest.useRealTimers());

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

test('the index of a sign is told from the text around it', () => {
  expect(splitAtIndices('Fₒ, F_c, F_D 0.90; U_d')).toEqual(['Fₒ, F', 'c', ', F', 'D', ' 0.90; U', 'd', '']);
  expect(splitAtIndices('“OFF_c” and “F_desk” reflect')).toHaveLength(1); // names of a file
});

test('a verdict tells what there is to spare, and what is met exactly says so once', async () => {
  const row = { where: 'wall', what: 'mean', target: 50, actual: 50, unit: 'lx', met: true };
  expect(verdictText({ ...row, margin: 0 })).toBe('✓ met exactly');
  expect(verdictText({ ...row, margin: 0.1 })).toBe('✓ met, 10 % to spare');
  expect(verdictText({ ...row, margin: -0.1, met: false })).toBe('✗ not met, 10 % short');
  expect(verdictText({ ...row, unit: 'UGR', margin: null, target: 19, actual: 19.04 })).toBe('✓ met exactly');
  expect(verdictText({ ...row, unit: 'UGR', margin: null, target: 19, actual: 8 })).toBe('✓ met');
  expect(verdictText({ ...row, margin: null, met: null })).toBe('wish');
  await speak('de');
  expect(verdictText({ ...row, margin: 0 })).toBe('✓ genau erfüllt');
  await speak('en');
});

test('how it was computed stands by itself, and what the figures rest on is sentences', async () => {
  const provenance = {
    source: { file: 'room.glb' },
    warnings: ['a wall has one side only'],
    residuals: [0.2, 1e-3],
  };
  const { app } = await appInRoom({ ...fakeScene(), provenance });
  const { assumptions, record } = reportOf(app);
  expect(Object.fromEntries(record)).toMatchObject({
    'Made from': 'room.glb',
    'Groups of patches that reflect to each other': '4',
    'Reflected light left out': '0.1 %',
    Identity: '0123456789abcdef',
  });
  expect(assumptions.at(-1)).toBe('A wall has one side only.');
  expect(assumptions.filter((text) => !/^[^a-z].*\.$/.test(text))).toEqual([]);
});

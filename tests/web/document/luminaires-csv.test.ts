/** The luminaires as a table. */
import { expect, test } from '@jest/globals';
import { luminairesCsv } from '../../../web/document/luminaires-csv.ts';
import { fakeScene } from '../fake-solver.ts';
import { fakePlan } from '../fake-viewer.ts';
import { luminaireType, photometricText } from './luminaire-type.ts';

const scene = fakeScene();

const layout = { sites: [0, 5], flux: [1200, 600], dimming: 0.5 };

test('CSV: a row a luminaire, metres from the corner with z up, dimmed lumens, watts by the efficacy', () => {
  expect(luminairesCsv(layout, scene.sites, fakePlan.frame, 100)).toBe(
    'id,x,y,z,flux,watts\r\nL1,0.500,3.500,3.000,600.0,6.00\r\nL2,1.500,2.500,3.000,300.0,3.00\r\n',
  );
});

test('CSV of types: their watts, turns and aims; names that are no formulas', () => {
  const type = luminaireType('a', photometricText(), { name: '=1+1, "bright"', watts: 20 });
  const mountings = [
    { type: 'a', turn: 90, aim: [1, 0.5, 2] as const },
    { type: 'gone', turn: 0, aim: null },
  ];
  expect(luminairesCsv({ ...layout, mountings }, scene.sites, fakePlan.frame, 100, [type])).toBe(
    'id,x,y,z,flux,watts,type,turn,aim x,aim y,aim z\r\n' +
      'L1,0.500,3.500,3.000,600.0,10.00,"\'=1+1, ""bright""",90,1.500,1.500,0.500\r\n' +
      'L2,1.500,2.500,3.000,300.0,3.00,,0,,,\r\n',
  );
});

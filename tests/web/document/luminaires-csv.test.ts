/** The luminaires as a table. */
import { expect, test } from '@jest/globals';
import { luminairesCsv } from '../../../web/document/luminaires-csv.ts';
import { fakeScene } from '../fake-solver.ts';

const scene = fakeScene();

const layout = { sites: [0, 5], flux: [1200, 600], dimming: 0.5 };

test('CSV: a row a luminaire, metres, dimmed lumens, watts by the efficacy', () => {
  expect(luminairesCsv(layout, scene.sites, 100)).toBe(
    'id,x,y,z,flux,watts\r\nL1,0.000,3.000,0.000,600.0,6.00\r\nL2,1.000,3.000,1.000,300.0,3.00\r\n',
  );
});

/** LENI by hand, and that its settings go wherever a document goes. */
import { expect, test } from '@jest/globals';
import { energyOf, energySettings, leni, usualEnergy } from '../../../web/document/energy.ts';
import { readProject, writeProject } from '../../../web/document/project-file.ts';
import { variantOf } from '../../../web/document/variants.ts';
import { sampleDocument } from '../sample-rooms.ts';

const used = { day: 2000, night: 500, occupancy: 0.9, constant: 0.95, daylight: 0.6, standby: 1.5 };

test('LENI is (W_L + W_P) / A with the hours, the controls and the standby that are said', () => {
  expect(leni(1000, 100)).toBe(25); // 1 kW for 2500 h on 100 m2
  // 1 kW x .95 x .9 x (2000 h x .6 + 500 h) on 100 m2, and what waits
  expect(leni(1000, 100, { ...usualEnergy, ...used })).toBeCloseTo(14.535 + 1.5, 10);
  const dark = { ...usualEnergy, daylight: 0 };
  expect(leni(1000, 100, dark)).toBe(2.5); // the night's 250 h are left
});

test('what is not said is as usual', () => {
  expect(energyOf({})).toEqual(usualEnergy);
  expect(energyOf({ energy: { occupancy: 0.5 } })).toEqual({ ...usualEnergy, occupancy: 0.5 });
  for (const [key, , , most] of energySettings) expect(usualEnergy[key]).toBeLessThanOrEqual(most);
});

test('the settings travel in the project file and with a variant, and are bounded', () => {
  const document = { ...sampleDocument('0123456789abcdef', 'box'), energy: { ...used, efficacy: 90 } };
  const project = { document, camera: null, display: null };
  expect(readProject(writeProject(project))).toEqual(project);
  expect(readProject(writeProject(project).replace('"daylight": 0.6', '"daylight": 6'))).toMatch(/daylight/);
  expect(variantOf(document, { sites: [1], flux: [1], dimming: 1 }).energy).toEqual(document.energy);
});

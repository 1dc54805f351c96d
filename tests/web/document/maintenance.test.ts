/** Maintained light: what is asked of the new installation, and what is read of it later. */
import { expect, test } from '@jest/globals';
import { asNew, maintained, maintenanceOf, usualMaintenance } from '../../../web/document/maintenance.ts';
import type { Intentions } from '../../../web/document/types.ts';

const intentions: Intentions = {
  luminaires: { count: 1, flux: 1000, dimming: [1, 1], pinned: [], excluded: [], minDistance: 0 },
  quantity: 'illuminance',
  goals: [
    { statistic: 'mean', sense: 'near', target: 400, weight: 1, surfaces: ['desk'] },
    { statistic: 'sigma', sense: 'min', weight: 1, surfaces: ['desk'] },
    { statistic: 'power', sense: 'min', weight: 1, surfaces: [] },
  ],
  constraints: [
    { statistic: 'mean', min: 500, max: 600, surfaces: ['desk'] },
    { statistic: 'uniformity', min: 0.6, surfaces: ['desk'] },
    { statistic: 'chebyshev', min: 300, alpha: 2, surfaces: ['desk'] },
    { statistic: 'modelling', min: 0.3, surfaces: ['desk'] },
    { statistic: 'cylindrical', min: 100, surfaces: ['desk'] },
  ],
};

test('the usual factors make 0.80; nothing said means the new installation', () => {
  expect(maintenanceOf({ maintenance: usualMaintenance })).toBe(0.8);
  expect(maintenanceOf({})).toBe(1);
  expect(asNew(intentions, 1)).toBe(intentions);
});

test('bounds and targets on light grow, ratios and power stay', () => {
  const asked = asNew(intentions, 0.8);
  expect(asked.constraints[0]).toMatchObject({ min: 625, max: 750 });
  expect(asked.constraints.slice(1)).toMatchObject([
    { min: 0.6 },
    { min: 375, alpha: 2 },
    { min: 0.3 },
    { min: 125 },
  ]);
  expect(asked.goals.map(({ target }) => target)).toEqual([500, undefined, undefined]);
  expect(intentions.constraints[0]?.min).toBe(500);
});

test('a bound that the new installation just meets is just met by what is shown', () => {
  const shown = {
    illuminance: Float32Array.of(625, 1250),
    direct: Float32Array.of(500, 1000),
    surfaces: [{ mean: 625, sigma: 10, min: 500, max: 1250 }],
    goals: [{ value: 0.25 }, { value: 10 }, { value: 1000 }],
    constraints: [{ value: 625 }, { value: 0.7 }, { value: 605 }, { value: 0.4 }, { value: 150 }],
    grids: [{ mean: 625, min: 500, max: 750 }],
    observers: [{ cylindrical: 200, ugr: 17 }],
    planes: [
      {
        horizontal: { mean: 500, least: 300 },
        cylindrical: { mean: 200, least: 150 },
        modelling: { mean: 0.4, least: 0.3 },
        verticals: [{ mean: 100, least: 50, direction: [1, 0, 0] }],
      },
    ],
  };
  const aged = maintained(shown, intentions, 0.8);
  expect([...aged.illuminance]).toEqual([500, 1000]);
  expect([...(aged.direct ?? [])]).toEqual([400, 800]);
  expect(aged.planes).toEqual([
    {
      horizontal: { mean: 400, least: 240 },
      cylindrical: { mean: 160, least: 120 },
      modelling: { mean: 0.4, least: 0.3 }, // a ratio does not age
      verticals: [{ mean: 80, least: 40, direction: [1, 0, 0] }],
    },
  ]);
  expect(aged.surfaces).toEqual([{ mean: 500, sigma: 8, min: 400, max: 1000 }]);
  expect(aged.grids).toEqual([{ mean: 500, min: 400, max: 600 }]);
  expect(aged.observers).toEqual([{ cylindrical: 160, ugr: 17 }]); // glare is that of the new installation
  expect(aged.goals.map(({ value }) => value)).toEqual([0.25, 8, 1000]);
  expect(aged.constraints.map(({ value }) => value)).toEqual([500, 0.7, 484, 0.4, 120]);
});

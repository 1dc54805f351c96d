/** Readings of an area from the light of its patches. */
import { describe, expect, test } from '@jest/globals';
import { spanText } from '../../../../web/app/words/format.ts';
import {
  histogram,
  mostShown,
  patchesOf,
  promises,
  sampleOf,
  shareBelow,
  unionOf,
} from '../../../../web/app/state/statistics.ts';
import { fakeScene } from '../../fake-solver.ts';

describe('statistics of an area', () => {
  const scene = {
    ...fakeScene(),
    surfaceOfPatch: Uint32Array.of(0, 0, 1),
    patchArea: Float32Array.of(1, 3, 2),
    patchCovered: new Uint8Array(0),
    patchReflectance: Float32Array.of(0.8, 0.4, 0.25),
  };
  const light = Float32Array.of(2, 6, 8);
  const sample = sampleOf(scene, light, patchesOf(scene, [0]), 'illuminance')!;

  test('are population statistics weighted by area', () => {
    expect(sample.mean).toBeCloseTo(5);
    expect(sample.sigma).toBeCloseTo(1.7320508);
    expect([sample.min, sample.max]).toEqual([2, 6]);
  });

  test('leave out what something covers', () => {
    const covered = { ...scene, patchCovered: Uint8Array.of(1, 0, 0) };
    expect(patchesOf(covered, [0, 1])).toEqual(Uint32Array.of(1, 2));
  });

  test('exitance is what each patch reflects, not the mean of its surface', () => {
    const floor = sampleOf(scene, light, patchesOf(scene, [0]), 'exitance')!;
    expect(floor.mean).toBeCloseTo((1 * 2 * 0.8 + 3 * 6 * 0.4) / 4);
    expect([floor.min, floor.max].map((value) => value.toFixed(3))).toEqual(['1.600', '2.400']);
    expect(sampleOf(scene, light, patchesOf(scene, [1]), 'exitance')?.mean).toBeCloseTo(2);
    expect(sampleOf(scene, light, new Uint32Array(), 'exitance')).toBeNull();
  });

  test('shares are shares of the area', () => {
    expect(shareBelow(sample, 2)).toBe(0);
    expect(shareBelow(sample, 5)).toBeCloseTo(0.25);
    expect(shareBelow(sample, 7)).toBe(1);
    expect(histogram(sample, 8, 4)).toEqual([0, 0.25, 0, 0.75]);
  });

  test('an axis holds the light, but not one bright spot that would squeeze it', () => {
    const values = Float32Array.from({ length: 1000 }, (_, i) => (i === 7 ? 5000 : 100 + (i % 100)));
    const of = (light: Float32Array) =>
      mostShown({
        ...sample,
        values: light,
        areas: values.map(() => 1),
        area: 1000,
        max: Math.max(...light),
      });
    expect(of(values)).toBeGreaterThan(198);
    expect(of(values)).toBeLessThan(220);
    expect(of(values.map((value) => Math.min(value, 250)))).toBe(250);
  });

  test('the promises hold for the true share', () => {
    for (const alpha of [0.5, 1, 1.5, 2]) {
      const share = shareBelow(sample, sample.mean - alpha * sample.sigma);
      expect(share).toBeLessThanOrEqual(promises(alpha).cantelli + 1e-9);
      expect(promises(alpha).cantelli).toBeLessThanOrEqual(promises(alpha).chebyshev);
    }
    expect(promises(2)).toEqual({ chebyshev: 0.25, cantelli: 0.2 });
  });
});

test('the readings of a family are those of all its patches together', () => {
  const row = (name: string, area: number, mean: number, sigma: number) => ({
    name,
    area,
    mean,
    sigma,
    min: mean - sigma,
    max: mean + sigma,
  });
  // Two values a surface, half of its area each: 1 m2 of 9 and 11, 3 m2 of 18 and 22.
  const union = unionOf([row('desk 1', 1, 10, 1), row('desk 2', 3, 20, 2)]);
  const values = [9, 11, 18, 22];
  const shares = [0.125, 0.125, 0.375, 0.375];
  const mean = values.reduce((sum, value, i) => sum + value * shares[i]!, 0);
  const variance = values.reduce((sum, value, i) => sum + (value - mean) ** 2 * shares[i]!, 0);
  expect(union).toMatchObject({ min: 9, max: 22 });
  expect(union.mean).toBeCloseTo(mean, 10);
  expect(union.sigma).toBeCloseTo(Math.sqrt(variance), 10);
  expect([spanText(487.2, 561.6), spanText(500.1, 500.2)]).toEqual(['487–\u200b562', '500']);
});

/** What is offered where a card's slider asks for more or less light than there is. */
import { expect, test } from '@jest/globals';
import { missesAim, pullsBack, wayToAim } from '../../../web/document/aim.ts';
import type { Constraint, Luminaires } from '../../../web/document/types.ts';

const four: Luminaires = {
  count: 4,
  flux: 5000,
  dimming: [1, 1],
  pinned: [],
  excluded: [],
  minDistance: 0,
};

test('an aim is missed by more than a hundredth', () => {
  expect(missesAim(397, 400)).toBe(false);
  expect(missesAim(405, 400)).toBe(true);
  expect(missesAim(405, undefined)).toBe(false);
});

test('less light than luminaires give is reached by dimming them, as far as that takes', () => {
  expect(wayToAim(four, 250, 250)).toBeNull();
  expect(wayToAim(four, 232, 50)).toEqual({ dimming: [0.1, 1] });
  expect(wayToAim(four, 232, 10)).toEqual({ dimming: [0.03, 1] });
  expect(wayToAim({ ...four, dimming: [0.5, 1] }, 120, 50)).toEqual({ dimming: [0.1, 1] });
  expect(wayToAim({ ...four, dimming: [0.1, 1] }, 232, 200)).toBeNull(); // something else is in the way
});

test('more is reached by flux, unless types have fluxes of their own', () => {
  expect(wayToAim(four, 326, 400)).toEqual({ flux: 6200 });
  expect(wayToAim({ ...four, flux: 300 }, 100, 150)).toEqual({ flux: 450 });
  expect(wayToAim(four, 300, 10_000)).toBeNull();
  expect(wayToAim({ ...four, types: [{ id: 'a' } as never] }, 326, 400)).toBeNull();
});

test('a bound that is broken, or would be, pulls the other way', () => {
  const mean = (bound: object): Constraint => ({ statistic: 'mean', surfaces: ['floor'], ...bound });
  expect(pullsBack(mean({ min: 5000 }), 350, 250 / 350)).toBe(true); // dimmed it is missed by more
  expect(pullsBack(mean({ min: 300 }), 350, 250 / 350)).toBe(true); // met now, and then no longer
  expect(pullsBack(mean({ min: 250 }), 350, 250 / 350)).toBe(false);
  expect(pullsBack(mean({ max: 200 }), 233, 250 / 233)).toBe(true);
  expect(pullsBack(mean({ max: 200 }), 350, 250 / 350)).toBe(false); // less light is what it asks for, too
  expect(pullsBack({ statistic: 'uniformity', min: 0.6, surfaces: ['floor'] }, 0.5, 0.5)).toBe(false);
  const glare: Constraint = { statistic: 'ugr', max: 19, surfaces: [] };
  expect([1.1, 2].map((share) => pullsBack(glare, 18, share))).toEqual([false, true]);
  expect(pullsBack(mean({ min: 300 }), NaN, 0.5)).toBe(false); // nobody has told what is reached
});

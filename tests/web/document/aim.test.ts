/** What is offered where a card's slider asks for more or less light than there is. */
import { expect, test } from '@jest/globals';
import { missesAim, wayToAim } from '../../../web/document/aim.ts';
import type { Luminaires } from '../../../web/document/types.ts';

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

/** The way of a film: layouts between two others, and the light between two steps. Covers film-note. */
import { expect, test } from '@jest/globals';
import type { App } from '../../../web/app/app.ts';
import { comparingActions } from '../../../web/app/comparing-actions.ts';
import { blended, canFilm, layoutBetween } from '../../../web/app/film.ts';
import { fakeScene } from '../fake-solver.ts';

const { sites } = fakeScene(); // 4 x 4, 1 m apart
const from = { sites: [0, 3], flux: [1, 2], dimming: 1 };
const to = { sites: [3, 0], flux: [1, 2], dimming: 1 };

test('begins and ends as it is told; luminaires that meet on the way hang apart', () => {
  expect(layoutBetween(from, to, 0, sites)).toBe(from);
  expect(layoutBetween(from, to, 1, sites)).toBe(to);
  expect(layoutBetween(from, to, 1 / 3, sites).sites).toEqual([1, 2]);
  expect(new Set(layoutBetween(from, to, 0.5, sites).sites).size).toBe(2);
});

test('light goes straight from step to step', () => {
  const lights = [
    [0, 10],
    [4, 10],
    [4, 0],
  ].map((light) => Float32Array.from(light));
  const at = (share: number) => [...blended(lights, share)];
  expect([0, 0.25, 0.5, 0.75, 1].map(at)).toEqual([
    [0, 10],
    [2, 10],
    [4, 10],
    [4, 5],
    [4, 0],
  ]);
});

test('where nothing encodes it, it is offered and says so in a sentence', () => {
  expect(canFilm()).toBe(false);
  const said: unknown[] = [];
  const app = { store: { say: (...message: unknown[]) => said.push(message) } } as unknown as App;
  comparingActions.find(({ id }) => id === 'film')!.run(app);
  expect(said).toEqual([['info', expect.stringContaining('cannot encode video')]]);
});

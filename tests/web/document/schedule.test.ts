/** Luminaires as they are ordered: letters of types, and how they are mounted. */
import { expect, test } from '@jest/globals';
import { pointingsOf } from '../../../web/document/pointing.ts';
import { scheduleOf } from '../../../web/document/schedule.ts';
import type { LuminaireType, Mounting } from '../../../web/document/types.ts';
import { speak } from '../../../web/language/language.ts';
import { fakeScene } from '../fake-solver.ts';
import { fakePlan } from '../fake-viewer.ts';
import { luminaireType, photometricText } from './luminaire-type.ts';

const { sites } = fakeScene();
const spot = luminaireType('a', photometricText(), { name: 'Spot' });
const washer = luminaireType('b', photometricText(), { name: 'Washer', tilt: 30 });
const hung = (type: string, aim: Mounting['aim'] = null): Mounting => ({ type, turn: 0, aim });

const rowsOf = (mountings: readonly Mounting[], types: readonly LuminaireType[], its = sites) => {
  const layout = { sites: mountings.map((_, i) => i), flux: mountings.map(() => 900), dimming: 1, mountings };
  const pointings = pointingsOf(layout, its, fakePlan.frame, types);
  return scheduleOf({ ...layout, pointings }, its, fakePlan.frame, 100, types).map(
    ({ letter, tags, mounting }) => ({
      letter,
      tags: tags.join(' '),
      mounting,
    }),
  );
};

test('one type that hangs straight down is one row without a letter', () => {
  expect(rowsOf([hung('a'), hung('a')], [spot])).toEqual([
    { letter: null, tags: 'L1 L2', mounting: 'facing down at 3.00 m' },
  ]);
});

test('what is aimed is told of its type, which keeps its letter', () => {
  expect(rowsOf([hung('a', [1, 0, 1]), hung('b'), hung('a')], [spot, washer])).toEqual([
    { letter: 'A', tags: 'L1', mounting: 'aimed, mounted at 3.00 m' },
    { letter: 'B', tags: 'L2', mounting: 'tilted by 30°, mounted at 3.00 m' },
    { letter: 'A', tags: 'L3', mounting: 'facing down at 3.00 m' },
  ]);
  expect(rowsOf([hung('a', [1, 0, 1]), hung('a')], [spot]).map(({ letter }) => letter)).toEqual([null, null]);
});

test('on a wall that is told, too, and in the language of the page', async () => {
  const walls = { ...sites, normal: Float32Array.from(sites.normal, (_, i) => (i % 3 === 2 ? 1 : 0)) };
  const mountings = [hung('a'), hung('a', [1, 0, 3])];
  const told = () => rowsOf(mountings, [spot], walls).map(({ mounting }) => mounting);
  expect(told()).toEqual(['on a wall, at 3.00 m', 'on a wall, aimed, at 3.00 m']);
  await speak('de');
  expect(told()).toEqual(['an einer Wand, in 3,00 m', 'an einer Wand, ausgerichtet, in 3,00 m']);
  await speak('en');
});

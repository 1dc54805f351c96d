// What the EN grid reads of a surface in several pieces: each counts by its points, the darkest is that of all.
import { expect, test } from '@jest/globals';
import type { Card } from '../../../../web/document/types.ts';
import { gridLightOf, withSurfaces } from '../../../../web/app/state/grid-light.ts';

const piece = (name: string, points: number, mean: number, min: number, max: number) =>
  ({ name, points, mean, min, max }) as Parameters<typeof gridLightOf>[0]['grids'][number];

test('pieces of a surface are one, by their points', () => {
  const grids = [
    piece('plane', 30, 500, 300, 600),
    piece('desk', 4, 900, 800, 950),
    piece('plane', 10, 300, 200, 400),
  ];
  expect(gridLightOf({ grids }, 'plane')).toEqual({
    mean: 450,
    uniformity: 200 / 450,
    min: 200,
    max: 600,
  });
  expect(gridLightOf({ grids }, 'floor')).toBeNull();
});

test('a card asks at the points of a grid only where one of its surfaces has any', () => {
  const leaves = ['plane', 'desk', 'wall'].map((name) => ({ name, measuring: name === 'plane' }));
  const card: Card = {
    id: 'a',
    verb: 'homogenize',
    surfaces: ['plane'],
    weight: 1,
    mean: { min: 500 },
    onGrid: true,
  };
  const shown = { grids: [piece('plane', 30, 500, 300, 600)] };
  expect(withSurfaces(card, ['plane', 'wall'], leaves, shown)).toEqual({
    ...card,
    surfaces: ['plane', 'wall'],
  });
  const { onGrid: _, ...ofPatches } = card;
  for (const surfaces of [['desk'], ['all']])
    expect(withSurfaces(card, surfaces, leaves, shown)).toEqual({ ...ofPatches, surfaces });
  expect(withSurfaces(ofPatches, ['plane'], leaves, shown)).toEqual(ofPatches);
});

/** Points that luminaires are aimed at are told as all places are: from the corner of the floor, z up. */
import { expect, test } from '@jest/globals';
import { aimText } from '../../../../web/panel/luminaires/type-aims.tsx';

const frame = { west: -4, south: 3, floor: -0.5, size: [8, 6, 3] } as const;

test('a point counts east, north and up from the corner of the floor', () => {
  expect(aimText([-2.5, 1, 2], frame)).toBe('1.50, 1.00, 1.50');
});

test('a surface is told by its name', () => {
  expect(aimText('picture 3', frame)).toBe('picture 3');
});

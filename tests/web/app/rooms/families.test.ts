/** Numbered surfaces folded into families. */
import { expect, test } from '@jest/globals';
import { folded } from '../../../../web/app/rooms/families.ts';
import { innerNodes } from '../../../../web/panel/intentions/surface-picker.tsx';

test('families of numbered surfaces fold into one line, where their first member stood', () => {
  const names = [
    'floor',
    'desk 2',
    'desk 10',
    'door',
    'desk 1',
    'desk 3',
    'chair 1',
    'room/wall 1',
    'room/wall 4',
  ];
  const lines = folded(names, (name) => name);
  expect(lines.map(({ title }) => title)).toEqual([
    'floor',
    'desk 1–3, 10',
    'door',
    'chair 1',
    'room/wall 1, 4',
  ]);
  expect(lines[1]?.items).toEqual(['desk 1', 'desk 2', 'desk 3', 'desk 10']);
  expect(folded(['a 1', 'a 3', 'a 5', 'a 7'], (name) => name)[0]?.title).toBe('a (4)');
  expect(innerNodes(['room/floor', 'room/wall 1', 'desk', 'box/lid'])).toEqual(['room']);
});

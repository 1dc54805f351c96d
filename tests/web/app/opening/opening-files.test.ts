/** What files are called, and which of a folder are meant. Covers opening-files. */
import { expect, test } from '@jest/globals';
import { cleanFileName, modelOfSeveral, openable } from '../../../../web/app/opening/opening-files.ts';

test('a name that is too long keeps what says what the file is', () => {
  expect(cleanFileName('office.glb')).toBe('office.glb');
  expect(cleanFileName('no suffix')).toBe('no suffix');
  const long = cleanFileName(`${'a_very_long_name_'.repeat(14)}.glb`);
  expect(long).toHaveLength(200);
  expect(long).toMatch(/^a_very_long_name_.*\.glb$/);
});

test.each([
  [
    ['._room.glb', 'room.glb', 'wall.png', '.DS_Store'],
    ['room.glb', 'wall.png'],
  ],
  [
    ['readme.txt', 'a.ldt', 'b.ies'],
    ['a.ldt', 'b.ies'],
  ],
  [['readme.txt', 'room.flux'], ['room.flux']],
  [
    ['a.txt', 'b.txt'],
    ['a.txt', 'b.txt'],
  ],
  [['.DS_Store'], []],
])('of %j, %j are opened', (dropped, meant) => {
  const files = dropped.map((name) => new File(['x'], name));
  expect(openable(files).map(({ name }) => name)).toEqual(meant);
});

test.each([
  [['b.glb', 'a.glb', 'wall.png'], { opened: 'b.glb', others: ['a.glb'] }],
  [
    ['plan.stf', 'house.obj', 'house.mtl', 'room.gltf'],
    { opened: 'room.gltf', others: ['house.obj', 'plan.stf'] },
  ],
  [['house.obj', 'house.mtl'], null],
  [['a.ldt', 'b.ldt'], null],
])('of %j one model is opened, and the others have a name: %j', (dropped, said) => {
  expect(modelOfSeveral(dropped.map((name) => new File(['x'], name)))).toEqual(said);
});

/** Surfaces are called in the language of the page; those of one's own rooms as they are. Covers web/language/surface-names. */
import { afterEach, expect, test } from '@jest/globals';
import { namesText, placesText } from '../../../web/app/words/places.ts';
import { speak } from '../../../web/language/language.ts';
import { isFoundBy, roomSurfaces, surfaceText, unnamedFloor } from '../../../web/language/surface-names.ts';

afterEach(() => speak('en'));

test('a name is read in the language of the page, alone, in a family and as a part', async () => {
  const names = [
    'wall north',
    'desk 3',
    'working plane background',
    'constructor',
    'Fauteuil 2',
    'storey 1/room 2/floor',
    'Cube/wall 3 (back)',
    'Cube/rest',
  ];
  expect(names.map(surfaceText)).toEqual(names);
  await speak('de');
  expect(names.map(surfaceText)).toEqual([
    'Wand Nord',
    'Schreibtisch 3',
    'Nutzebene, Hintergrund',
    'constructor',
    'Fauteuil 2',
    'Geschoss 1/Raum 2/Fußboden',
    'Cube/Wand 3 (Rückseite)',
    'Cube/Rest',
  ]);
  expect(isFoundBy('schreib', 'desk 3') && isFoundBy('DESK', 'desk 3')).toBe(true);
  expect(isFoundBy('stuhl', 'desk 3')).toBe(false);
});

test('a floor whose name does not say so is called one, and found as one', async () => {
  unnamedFloor.value = 'Cube/wall/top';
  try {
    const names = ['Cube/wall/top', 'Cube/wall/top (back)', 'Cube/wall/rest'];
    expect(names.map(surfaceText)).toEqual(['floor (Cube/wall/top)', ...names.slice(1)]);
    expect(isFoundBy('floor', 'Cube/wall/top')).toBe(true);
    await speak('de');
    expect(surfaceText('Cube/wall/top')).toMatch(/^Fußboden \(Cube\/Wand\//);
  } finally {
    unnamedFloor.value = null;
  }
});

test('several surfaces are told in few words', async () => {
  const desks = Array.from({ length: 12 }, (_, i) => `desk ${i + 1}`);
  expect([namesText(desks), placesText([...desks, 'floor'])]).toEqual(['12 × desk', 'desk 1–12, floor']);
  expect([namesText(['all']), placesText(['all'])]).toEqual(['the whole room', 'the whole room']);
  expect([namesText(['desk 1', 'floor']), placesText(['desk 1'])]).toEqual(['desk 1, floor', 'desk 1']);
  await speak('de');
  expect([namesText(desks), placesText(desks)]).toEqual(['12 × Schreibtisch', 'Schreibtisch 1–12']);
});

test('of the path of a floor, a ceiling and walls as much is read as tells them from others', async () => {
  const told = {
    'box/cbox.Material.002/floor': 'floor',
    'box/cbox.Material.002/wall 2': 'wall 2',
    'box/cbox.red': 'box/cbox.red',
    'large.box/side 1': 'large.box/side 1',
    'house/kitchen/ceiling': 'kitchen/ceiling',
    'house/bath/ceiling': 'bath/ceiling',
    'house/bath/ceiling (back)': 'bath/ceiling (back)',
  };
  const names = Object.keys(told);
  try {
    roomSurfaces.value = names;
    expect(names.map(surfaceText)).toEqual(Object.values(told));
    expect(placesText(['box/cbox.Material.002/wall 1', 'box/cbox.Material.002/wall 2'])).toBe('wall 1–2');
    expect(isFoundBy('material', names[0]!) && isFoundBy('floor', names[0]!)).toBe(true);
    await speak('de');
    expect(surfaceText(names[1]!)).toBe('Wand 2');
  } finally {
    roomSurfaces.value = [];
  }
  expect(surfaceText(names[0]!)).toBe('box/cbox.Material.002/Fußboden');
});

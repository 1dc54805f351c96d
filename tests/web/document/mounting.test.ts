/** How luminaires hang. */
import { expect, test } from '@jest/globals';
import { frameOf, frameOn, middleOf } from '../../../web/document/mounting.ts';
import { fakeScene } from '../fake-solver.ts';
import { luminaireType, photometricText } from './luminaire-type.ts';

const { sites, ...scene } = fakeScene(); // normals down (-y), axes along x

const expectAt = (point: readonly number[], ...truth: number[]) =>
  truth.forEach((value, axis) => expect(point[axis]).toBeCloseTo(value, 6));

test('unturned: along the normal, C0 along the axis', () => {
  const { down, along } = frameOn(sites, 5, { turn: 0, aim: null });
  expectAt(down, 0, -1, 0);
  expectAt(along, 1, 0, 0);
});

test('a quarter turn takes C0 to normal x axis', () => {
  expectAt(frameOn(sites, 5, { turn: 90, aim: null }).along, 0, 0, 1);
});

test('aimed: gamma 0 goes through the point, C0 stays as near as it can', () => {
  const { down, along } = frameOn(sites, 5, { turn: 0, aim: [1, 0, 4] }); // from (1, 3, 1): 3 down, 3 along z
  expectAt(down, 0, -Math.SQRT1_2, Math.SQRT1_2);
  expectAt(along, 1, 0, 0);
  expectAt(frameOn(sites, 5, { turn: 0, aim: [1, 3, 1] }).down, 0, -1, 0);
});

test('tilted towards C0, as far as its type says', () => {
  const type = luminaireType('a', photometricText(), { tilt: 30 });
  const { down, along } = frameOf(sites, 0, { type: 'a', turn: 90, aim: null }, [type]);
  expectAt(down, 0, -Math.cos(Math.PI / 6), 0.5);
  expectAt(along, 0, 0.5, Math.cos(Math.PI / 6));
});

test('aimed along its own C0, it has some other', () => {
  const { down, along } = frameOn(sites, 0, { turn: 0, aim: [4, 3, 0] });
  expectAt(down, 1, 0, 0);
  expect(Math.abs(along[0])).toBeLessThan(1e-6);
  expect(Math.hypot(...along)).toBeCloseTo(1);
});

test('the middle of surfaces is that of their area', () => {
  expectAt(middleOf({ ...scene, sites }, [1]) ?? [], 1.5, 0, 3);
  expect(middleOf({ ...scene, sites }, [])).toBeNull();
});

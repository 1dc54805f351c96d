/** How luminaires point, in plan and from straight down. */
import { expect, test } from '@jest/globals';
import { isAimed, isOffDown, pointingsOf } from '../../../web/document/pointing.ts';
import { fakeScene } from '../fake-solver.ts';
import { fakePlan } from '../fake-viewer.ts';
import { luminaireType, photometricText } from './luminaire-type.ts';

const { sites } = fakeScene(); // 3 m above the floor, normals down, axes to the east
const type = luminaireType('a', photometricText(), { tilt: 30 });

test('straight down there is no azimuth, and nothing is aimed', () => {
  const [pointing] = pointingsOf({ sites: [5] }, sites, fakePlan.frame);
  expect(pointing).toEqual({ turn: 0, aim: null, lean: 0, tilt: 0, azimuth: null });
  expect([isAimed(pointing!), isOffDown(pointing!)]).toEqual([false, false]);
});

test('aimed: the point in plan, the tilt from straight down, the azimuth from north clockwise', () => {
  const to = (x: number, y: number, z: number) => ({ type: 'a', turn: 0, aim: [x, y, z] as const });
  // Site 5 hangs at (1, 3, 1) of the room: to the east, south, west and north of it, and right below.
  const mountings = [to(4, 0, 1), to(1, 0, 4), to(-2, 0, 1), to(1, 0, -2), to(1, 0, 1)];
  const pointings = pointingsOf({ sites: [5, 5, 5, 5, 5], mountings }, sites, fakePlan.frame, [type]);
  expect(pointings[0]!.aim).toEqual([4.5, 2.5, 0]);
  expect(pointings.map(({ tilt }) => Math.round(tilt))).toEqual([45, 45, 45, 45, 0]);
  expect(pointings.map(({ azimuth }) => azimuth && Math.round(azimuth))).toEqual([90, 180, 270, 0, null]);
  expect(pointings.map(isOffDown)).toEqual([true, true, true, true, false]);
  expect(pointings.every(isAimed)).toBe(true);
});

test('tilted as its type says, towards where it is turned', () => {
  const mountings = [{ type: 'a', turn: 90, aim: null }];
  const [pointing] = pointingsOf({ sites: [5], mountings }, sites, fakePlan.frame, [type]);
  expect(pointing).toMatchObject({ turn: 90, aim: null, lean: 30 });
  expect(pointing!.tilt).toBeCloseTo(30);
  expect(pointing!.azimuth).toBeCloseTo(180);
});

test('on a wall it shines level, and on the floor up, without being aimed', () => {
  const normals = (normal: number[]) => ({
    ...sites,
    normal: Float32Array.from([0, 1, 2].flatMap(() => normal)),
  });
  const [wall] = pointingsOf({ sites: [0] }, normals([1, 0, 0]), fakePlan.frame);
  expect(wall).toMatchObject({ tilt: 90, azimuth: 90 });
  const [floor] = pointingsOf({ sites: [0] }, normals([0, 1, 0]), fakePlan.frame);
  expect(floor).toMatchObject({ tilt: 180, azimuth: null });
  expect([isAimed(wall!), isOffDown(wall!), isOffDown(floor!)]).toEqual([false, true, true]);
});

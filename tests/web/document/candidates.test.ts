/** What luminaires of some types could do in a room. */
import { expect, test } from '@jest/globals';
import { candidatesOf, mountingsOf, whyNowhere } from '../../../web/document/candidates.ts';
import type { Aim, Point } from '../../../web/document/types.ts';
import { fakeScene } from '../fake-solver.ts';
import { luminaireType, photometricText } from './luminaire-type.ts';

const scene = fakeScene(); // 4 x 4 sites of 0.5 m, 1 m apart, on a ceiling; "floor" and "wall"
const type = luminaireType('a', photometricText());
const area = (length: number, width: number, longAxis: 'C0' | 'C90' = 'C0') => ({
  luminous: { length, width, height: 0, round: false },
  longAxis,
});

test('every turn with every aim; surfaces are aimed at in their middle, unknown ones not at all', () => {
  const mountings = mountingsOf(
    { ...type, turns: [0, 90], aims: ['wall', [1, 2, 3], 'no such surface'] },
    scene,
  );
  expect(mountings).toHaveLength(4);
  expect(mountings[0]?.aim?.map((value) => Math.round(value * 10) / 10)).toEqual([1.5, 0, 3]);
  expect(mountings[3]).toEqual({ type: 'a', turn: 90, aim: [1, 2, 3] });
  expect(mountingsOf({ ...type, aims: ['no such surface'] }, scene)).toEqual([
    { type: 'a', turn: 0, aim: null },
  ]);
});

test('types come site by site', () => {
  const candidates = candidatesOf([type, { ...type, id: 'b' }], () => undefined, scene);
  expect(candidates.slice(0, 4).map(({ site, type: { id } }) => `${site}${id}`)).toEqual([
    '0a',
    '0b',
    '1a',
    '1b',
  ]);
  expect(candidates).toHaveLength(32);
});

test('a tilt is a point to aim at, and the layout does not hold it', () => {
  const [first] = candidatesOf([{ ...type, tilt: 90 }], () => undefined, scene);
  expect(first?.mounting.aim).toBeNull();
  [10, 3, 0].forEach((value, axis) => expect(first?.aim?.[axis]).toBeCloseTo(value));
});

test('what is longer than its place is offered where its neighbours carry it', () => {
  const sitesOf = (length: number, longAxis: 'C0' | 'C90' = 'C0') =>
    candidatesOf([type], () => area(length, 0.1, longAxis), scene).map(({ site }) => site);
  expect(sitesOf(0.5)).toHaveLength(16);
  expect(sitesOf(1.8).every((site) => site % 4 === 1 || site % 4 === 2)).toBe(true);
  expect(sitesOf(1.8)).toHaveLength(8);
  expect(sitesOf(1.8, 'C90').every((site) => site > 3 && site < 12)).toBe(true);
  expect(sitesOf(5)).toEqual([]);
  expect(whyNowhere(type, area(1.8, 0.1), scene)).toBeNull();
  expect(whyNowhere(type, area(5, 0.1), scene)).toBe('size');
});

test('a largest aiming angle leaves out places that are further away, and does nothing where nothing is aimed at', () => {
  const under: Point = [0, 2, 0]; // 1 m below the first site; the next ones are 45 degrees off
  const sitesWithin = (maxAimingAngle: number, aims: readonly Aim[] = [under]) =>
    candidatesOf([{ ...type, aims, maxAimingAngle }], () => undefined, scene).map(({ site }) => site);
  expect(sitesWithin(0)).toEqual([0]);
  expect(sitesWithin(44)).toEqual([0]);
  expect(sitesWithin(45)).toEqual([0, 1, 4]);
  expect(sitesWithin(60)).toEqual([0, 1, 4, 5]);
  expect(sitesWithin(180)).toHaveLength(16);
  expect(sitesWithin(0, [])).toHaveLength(16);
  const overhead = { ...type, aims: [[0, 4, 0] as const], maxAimingAngle: 90 };
  expect(whyNowhere(overhead, area(0.1, 0.1), scene)).toBe('angle');
});

test('a hall’s places are listed while nobody waits, those for long luminaires too', () => {
  const side = 50;
  const place = Array.from({ length: side * side }, (_, i) => [i % side, 3, Math.floor(i / side)]);
  const each = (values: readonly number[]) => Float32Array.from(place.flatMap(() => values));
  const sites = {
    position: Float32Array.from(place.flat()),
    normal: each([0, -1, 0]),
    axis: each([1, 0, 0]),
    size: each([0.5]),
  };
  const begin = process.cpuUsage();
  const listed = candidatesOf([type], () => area(1.8, 0.1), { ...scene, sites });
  expect(listed).toHaveLength(side * (side - 2));
  // Where each corner looks at all places it takes ten seconds and more.
  expect(process.cpuUsage(begin).user / 1e6).toBeLessThan(4);
});

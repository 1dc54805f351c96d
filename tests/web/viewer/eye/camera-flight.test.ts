import { describe, expect, test } from '@jest/globals';
import { Spherical, Vector3 } from 'three';
import { poseBetween, type CameraPose } from '../../../../web/viewer/eye/camera-flight.ts';

const pose = (radius: number, phi: number, theta: number, plan = false): CameraPose => ({
  target: new Vector3(radius, 0, 0),
  spherical: new Spherical(radius, phi, theta),
  plan,
});

describe('a flight of the eye', () => {
  test('begins and ends at its poses', () => {
    const [from, to] = [pose(2, 1, 0.5), pose(8, 0.5, 1.5)];
    expect(poseBetween(from, to, 0).spherical.radius).toBeCloseTo(2);
    expect(poseBetween(from, to, 1).spherical.theta).toBeCloseTo(1.5);
    expect(poseBetween(from, to, 1).target.x).toBeCloseTo(8);
  });

  test('takes the shorter turn and equal ratios of distance', () => {
    const half = poseBetween(pose(2, 1, 3), pose(8, 1, -3), 0.5);
    expect(Math.cos(half.spherical.theta)).toBeCloseTo(-1);
    expect(half.spherical.radius).toBeCloseTo(4);
  });

  test('is orthographic only from plan to plan', () => {
    expect(poseBetween(pose(2, 0, 0, true), pose(3, 0, 0, true), 0.5).plan).toBe(true);
    expect(poseBetween(pose(2, 0, 0, true), pose(3, 1, 0), 0.5).plan).toBe(false);
  });
});

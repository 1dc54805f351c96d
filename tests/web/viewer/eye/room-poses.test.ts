/** Where a visitor comes in. */
import { expect, test } from '@jest/globals';
import { Vector3 } from 'three';
import { RoomPoses } from '../../../../web/viewer/eye/room-poses.ts';

test.each([
  ['a hall', [0, 0, 0], [14, 3, 9]],
  ['a corridor', [-1, 2, -20], [1, 4.6, 20]],
  ['a closet', [0, 0, 0], [1.2, 2, 1]],
] as const)('the eye within %s is inside at eye height, on the side of home', (_, min, max) => {
  const poses = new RoomPoses({ min, max }, [0, 0, 0, 0], 1.5);
  const { target, spherical } = poses.within();
  const eye = new Vector3().setFromSpherical(spherical).add(target);
  for (const [axis, at] of eye.toArray().entries()) {
    expect(at).toBeGreaterThan(min[axis]!);
    expect(at).toBeLessThan(max[axis]!);
  }
  expect(eye.y - min[1]).toBeCloseTo(Math.min(1.6, 0.6 * (max[1] - min[1])));
  expect(spherical.theta).toBeCloseTo(poses.home().spherical.theta);
  expect(spherical.radius).toBeLessThan(poses.home().spherical.radius);
});

test('a view from a wider picture is seen from farther back, from side to side as wide; others are as they were', () => {
  const wide = { position: [9, 8, 7], target: [4, 1, 3], plan: false, aspect: 1.6 } as const;
  const radius = Math.hypot(5, 7, 4);
  const at = (own: number, planOwn = own) =>
    new RoomPoses({ min: [0, 0, 0], max: [9, 3, 7] }, [0, 0, 0, 0], own, planOwn);
  expect(at(0.4).given(wide).spherical.radius).toBeCloseTo(radius * 4);
  expect(at(1.6).given(wide).spherical.radius).toBeCloseTo(radius);
  expect(at(2.2).given(wide).spherical.radius).toBeCloseTo(radius);
  const { aspect: _, ...unknown } = wide;
  expect(at(0.4).given(unknown).spherical.radius).toBeCloseTo(radius);
  const plan = { position: [4, 12, 3], target: [4, 1, 3], plan: true, aspect: 1.5 } as const;
  expect(at(1.5, 0.5).given(plan).spherical.radius).toBeCloseTo(33);
  // Who stands in the room is not drawn through a wall.
  const standing = { position: [4, 1.6, 3], target: [4, 1.6, 2.6], plan: false, aspect: 1.6 } as const;
  expect(at(0.4).given(standing).spherical.radius).toBeCloseTo(0.4);
});

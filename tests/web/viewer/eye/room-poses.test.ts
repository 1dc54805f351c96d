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

import { describe, expect, test } from '@jest/globals';
import { PerspectiveCamera, Vector3 } from 'three';
import * as framing from '../../../../web/viewer/eye/framing.ts';

const corridor: framing.Box = { min: [0, 0, 0], max: [12.75, 3, 32.25] };
const cube: framing.Box = { min: [-2, 0, -2], max: [2, 4, 2] };

/** Corners of the box in the picture, -1..1 each way. */
function project(box: framing.Box, pose: framing.Pose, aspect: number) {
  const camera = new PerspectiveCamera(40, aspect, 0.01, 1000);
  camera.position.set(...pose.position);
  camera.lookAt(...pose.target);
  camera.updateMatrixWorld();
  camera.updateProjectionMatrix();
  return framing.boxCorners(box).map((corner) => new Vector3(...corner).project(camera));
}

describe.each([
  ['corridor', corridor],
  ['cube', cube],
])('a pose on the %s', (_, box) => {
  test.each([0.46, 1, 1.6])(
    'holds every corner and touches the frame on opposite sides, aspect %d',
    (aspect) => {
      for (const [azimuth, elevation] of [
        [45, 30],
        [0, 8],
        [200, 55],
      ] as const) {
        const direction = framing.directionOf(azimuth, elevation);
        const corners = project(box, framing.framePose(box, direction, 40, aspect, 0.05), aspect);
        const xs = corners.map((c) => c.x);
        const ys = corners.map((c) => c.y);
        const [left, right] = [Math.min(...xs), Math.max(...xs)];
        const [low, high] = [Math.min(...ys), Math.max(...ys)];
        expect(Math.max(-left, right, -low, high)).toBeCloseTo(0.95, 6);
        const across = Math.abs(left + right) < 1e-6 && right > 0.9499;
        const upright = Math.abs(low + high) < 1e-6 && high > 0.9499;
        expect(across || upright).toBe(true);
      }
    },
  );
});

test('the axes of a camera are a right-handed frame with y up', () => {
  const direction = framing.directionOf(30, 40);
  const { right, up } = framing.cameraAxes(direction);
  const cross = new Vector3(...right).cross(new Vector3(...up));
  expect(cross.distanceTo(new Vector3(...direction))).toBeCloseTo(0);
  expect(up[1]).toBeGreaterThan(0);
});

test('a plan of a long room is turned where that fills the picture', () => {
  expect(framing.planFrame(corridor, 1.6).turned).toBe(true);
  expect(framing.planFrame(corridor, 0.46).turned).toBe(false);
  expect(framing.planFrame(cube, 1.6).turned).toBe(false);
  const { height } = framing.planFrame(corridor, 1.6, 0);
  expect(height).toBeCloseTo(Math.max(12.75, 32.25 / 1.6));
});

test('the eye goes to the corner that sees most, and a long room lies along the picture', () => {
  expect(framing.cornerAzimuth(cube, 1.6, [1, 1, 3, 1])).toBe(225);
  expect(framing.cornerAzimuth(cube, 1.6, [2, 2, 2, 2])).toBe(45);
  const wide = framing.cornerAzimuth(corridor, 1.6, [0, 1, 0, 0]);
  const tall = framing.cornerAzimuth(corridor, 0.46, [0, 1, 0, 0]);
  expect(wide).toBeGreaterThan(90);
  expect(wide).toBeLessThan(135);
  expect(tall).toBeGreaterThan(135);
  expect(tall).toBeLessThan(180);
});

test('a flat room is looked at from higher up', () => {
  expect(framing.cornerElevation(corridor)).toBeGreaterThan(framing.cornerElevation(cube) + 10);
});

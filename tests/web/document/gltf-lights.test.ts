/** The luminaires as glTF lights. */
import { describe, expect, test } from '@jest/globals';
import { gltfLights, rotationFromMinusZ } from '../../../web/document/gltf-lights.ts';
import { fakeScene } from '../fake-solver.ts';

const scene = fakeScene();

const layout = { sites: [0, 5], flux: [1200, 600], dimming: 0.5 };

describe('glTF lights', () => {
  const rotate = ([x, y, z, w]: readonly number[], v: readonly number[]) => {
    // v + 2 q x (q x v + w v)
    const cross = (a: readonly number[], b: readonly number[]) => [
      a[1]! * b[2]! - a[2]! * b[1]!,
      a[2]! * b[0]! - a[0]! * b[2]!,
      a[0]! * b[1]! - a[1]! * b[0]!,
    ];
    const q = [x!, y!, z!];
    const inner = cross(q, v).map((value, i) => value + w! * v[i]!);
    return cross(q, inner).map((value, i) => v[i]! + 2 * value);
  };

  test.each([
    [[0, -1, 0]],
    [[0, 1, 0]],
    [[1, 0, 0]],
    [[0, 0, -1]],
    [[0, 0, 1]],
    [[0.6, -0.8, 0]],
    [[0.48, -0.6, 0.64]],
  ])('turn -z to %j', (direction) => {
    const rotation = rotationFromMinusZ(direction);
    expect(Math.hypot(...rotation)).toBeCloseTo(1);
    rotate(rotation, [0, 0, -1]).forEach((value, axis) => expect(value).toBeCloseTo(direction[axis]!));
  });

  test('carry Phi / pi candela at the place of the site', () => {
    const gltf = JSON.parse(gltfLights(layout, scene.sites));
    const { lights } = gltf.extensions.KHR_lights_punctual;
    expect(gltf.asset.version).toBe('2.0');
    expect(lights).toHaveLength(2);
    expect(lights[0].intensity).toBeCloseTo(600 / Math.PI);
    expect(gltf.nodes[1].translation).toEqual([1, 3, 1]);
    expect(gltf.scenes[0].nodes).toEqual([0, 1]);
  });
});

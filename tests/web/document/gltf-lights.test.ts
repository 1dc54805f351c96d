/** The luminaires as glTF lights. */
import { describe, expect, test } from '@jest/globals';
import { gltfLights, rotationFromMinusZ } from '../../../web/document/gltf-lights.ts';
import { sampledGammas, type PhotometricDescription } from '../../../web/document/photometry.ts';
import { described } from '../described.ts';
import { fakeScene } from '../fake-solver.ts';
import { luminaireType, photometricText } from './luminaire-type.ts';

const scene = fakeScene();

const layout = { sites: [0, 5], flux: [1200, 600], dimming: 0.5 };

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

describe('glTF lights', () => {
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

describe('glTF lights of photometric files', () => {
  const text = photometricText();
  const type = luminaireType('a', text);
  const mountings = [
    { type: 'a', turn: 90, aim: null },
    { type: 'gone', turn: 0, aim: null },
  ];
  const gltfOf = (description: PhotometricDescription) =>
    JSON.parse(
      gltfLights({ ...layout, mountings }, scene.sites, {
        types: [type],
        descriptions: { [type.hash]: description },
        files: { [type.hash]: text },
      }),
    );
  const embeddedIn = (gltf: ReturnType<typeof gltfOf>) => {
    const [head, body] = gltf.extensions.EXT_lights_ies.lights[0].uri.split(',');
    expect(head).toBe('data:application/x-ies-lm-63;base64');
    return atob(body);
  };

  test('hold the file, and scale it to what the luminaire emits', () => {
    const gltf = gltfOf(described(100, { integratedFlux: 1200 }));
    expect(gltf.extensionsUsed).toEqual(['KHR_lights_punctual', 'EXT_lights_ies']);
    expect(embeddedIn(gltf)).toBe(text);
    expect(gltf.nodes[0].extensions.EXT_lights_ies).toEqual({ light: 0, multiplier: 0.5 });
    expect(gltf.nodes[1].extensions.EXT_lights_ies).toBeUndefined();
  });

  test('point gamma 0 along -z and C0 along x', () => {
    const { rotation } = gltfOf(described(100)).nodes[0];
    const down = rotate(rotation, [0, 0, -1]);
    const along = rotate(rotation, [1, 0, 0]);
    [0, -1, 0].forEach((value, axis) => expect(down[axis]).toBeCloseTo(value));
    [0, 0, 1].forEach((value, axis) => expect(along[axis]).toBeCloseTo(value));
  });

  test('are written anew where the file is no LM-63, or reads otherwise the other way round', () => {
    const candela = described(1).candela.map((_, i) => 1 + Math.floor(i / sampledGammas)); // by plane
    const ies = embeddedIn(gltfOf(described(100, { format: 'EULUMDAT', symmetry: 'none', candela })));
    const lines = ies.split('\r\n');
    expect(lines[0]).toBe('IESNA:LM-63-2002');
    const start = lines.indexOf('TILT=NONE');
    const planes = lines.slice(start + 5, -1).map((line) => Number(line.split(' ')[0]));
    expect(planes).toEqual([1, ...Array.from({ length: 23 }, (_, i) => 24 - i), 1]);
  });

  test('resemble spots for those who cannot read files', () => {
    const spot = described(100, { integratedFlux: 1200, upwardShare: 0, beamAngle: 24, fieldAngle: 50 });
    const [light] = gltfOf(spot).extensions.KHR_lights_punctual.lights;
    expect(light).toMatchObject({ type: 'spot', intensity: 50 });
    expect(light.spot.outerConeAngle).toBeCloseTo((25 * Math.PI) / 180);
  });
});

/** The body of a luminaire's light. */
import { expect, test } from '@jest/globals';
import { Vector3 } from 'three';
import { sampledGammas, sampledPlanes } from '../../../../web/document/photometry.ts';
import { PhotometricSolid, solidGeometry } from '../../../../web/viewer/luminaires/photometric-solid.ts';
import { described } from '../../described.ts';

const points = (candela: Float32Array) => {
  const position = solidGeometry(candela).getAttribute('position');
  return Array.from({ length: position.count }, (_, i) =>
    new Vector3().fromBufferAttribute(position as never, i),
  );
};

test('even light is a sphere', () => {
  const radii = points(described(7).candela).map((point) => point.length());
  expect(Math.min(...radii)).toBeCloseTo(Math.max(...radii), 5);
});

test('is as long as the light is strong, gamma 0 along z, C0 along x', () => {
  const candela = new Float32Array(sampledPlanes * sampledGammas);
  candela[0] = 50; // C0, gamma 0
  candela[90] = 100; // C0, horizontal
  const all = points(candela);
  const along = (x: number, y: number, z: number) => Math.max(...all.map((p) => p.dot(new Vector3(x, y, z))));
  expect(along(1, 0, 0)).toBeCloseTo(2 * along(0, 0, 1), 4);
  expect(along(-1, 0, 0)).toBeCloseTo(0, 5);
});

test('is not seen where colours stand for numbers', () => {
  const solid = new PhotometricSolid();
  const { candela } = described(7);
  solid.show(candela);
  expect(solid.mesh.visible).toBe(true);
  solid.isWanted = false;
  solid.show(candela);
  expect(solid.mesh.visible).toBe(false);
});

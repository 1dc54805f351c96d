/** Triangles of a mesh that is moved and turned, with and without an index. */
import { expect, test } from '@jest/globals';
import { Mesh, PlaneGeometry, type BufferGeometry } from 'three';
import { inWorld } from '../../../../web/viewer/room/in-world.ts';

test('a mesh is where its matrix puts it, and its own places stay', () => {
  const mesh = new Mesh<BufferGeometry>(new PlaneGeometry(2, 2));
  mesh.position.set(5, 0, 0);
  mesh.rotation.x = -Math.PI / 2;
  mesh.updateMatrixWorld();
  const { index, positions } = inWorld(mesh);
  expect([...(index as Uint16Array)]).toEqual([0, 2, 1, 2, 3, 1]);
  expect([...(positions as Float32Array)].map((value) => Number(value.toFixed(6)) + 0)).toEqual([
    4, 0, -1, 6, 0, -1, 4, 0, 1, 6, 0, 1,
  ]);
  expect(mesh.geometry.getAttribute('position').getX(0)).toBe(-1);
  mesh.geometry = mesh.geometry.toNonIndexed();
  expect([...(inWorld(mesh).index as Uint32Array)]).toEqual([0, 1, 2, 3, 4, 5]);
});

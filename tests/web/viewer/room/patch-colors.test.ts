/** What colour patches have by the vertices of their meshes. Covers patch-colors. */
import { expect, test } from '@jest/globals';
import { BufferAttribute, BufferGeometry, Mesh, ShaderMaterial, Vector4 } from 'three';
import { patchColors } from '../../../../web/viewer/room/patch-colors.ts';
import type { LitMesh } from '../../../../web/viewer/room/room-mesh.ts';

/** A mesh of `count` vertices, each of which takes its light from one patch, and half of it from another. */
function litMesh(count: number, patch: number, half: number, measuring = false): LitMesh {
  const geometry = new BufferGeometry();
  const each = <T>(make: (vertex: number) => T[]) => Array.from({ length: count }, (_, v) => make(v)).flat();
  geometry.setAttribute('_patches', new BufferAttribute(new Uint32Array(each(() => [patch, half, 9, 9])), 4));
  geometry.setAttribute(
    '_weights',
    new BufferAttribute(new Uint8Array(each(() => [170, 85, 0, 0])), 4, true),
  );
  geometry.setAttribute(
    'color',
    new BufferAttribute(new Uint16Array(each(() => [65535, 32768, 0])), 3, true),
  );
  const material = new ShaderMaterial({
    vertexColors: true,
    uniforms: {
      albedo: { value: new Vector4(0.6, 0.4, 0.2, 1) },
      albedoMap: { value: null },
      mapTransform: { value: null },
    },
  });
  return { mesh: new Mesh(geometry, material), measuring } as unknown as LitMesh;
}

test('patches take the colours of all vertices that take their light from them, in portions or not', async () => {
  const many = 20_000;
  const colors = await patchColors([litMesh(many, 0, 1), litMesh(3, 2, 2), litMesh(5, 3, 3, true)], 5);
  const ratio = (patch: number) => [1, 2].map((channel) => colors[3 * patch + channel]! / colors[3 * patch]!);
  for (const patch of [0, 1, 2]) {
    expect(ratio(patch)[0]).toBeCloseTo((0.4 / 0.6) * 0.5, 3);
    expect(ratio(patch)[1]).toBe(0);
  }
  expect(colors[0]! / colors[3]!).toBeCloseTo(2, 3);
  expect(colors[0]! / (many * 0.6)).toBeCloseTo(2 / 3, 2);
  expect(colors.slice(9)).toEqual(new Float32Array(6)); // what measures has no colour, and nobody is patch 9
});

/** Emphasis: what is told of or under a pointer has lines around it and keeps its colour, which is read off a legend. */
import { expect, test } from '@jest/globals';
import { BoxGeometry, Mesh, ShaderMaterial } from 'three';
import { Emphasis } from '../../../../web/viewer/hand/emphasis.ts';
import { planeUniforms } from '../../../../web/viewer/light/plane-footprints.ts';
import { SurfaceOutlines } from '../../../../web/viewer/room/surface-outline.ts';
import type { LitMesh } from '../../../../web/viewer/room/room-mesh.ts';

const others = { invalidate() {}, animate() {}, cancel() {}, objects: [], setState() {} };

function roomOf(surfaces: number): LitMesh[] {
  return Array.from({ length: surfaces }, (_, surface) => {
    const mesh = new Mesh(new BoxGeometry(), new ShaderMaterial({ uniforms: { tint: { value: 0 } } }));
    return { mesh, surface, measuring: false } as unknown as LitMesh;
  });
}

test('a surface that is told of or pointed at is outlined, and a red wall stays red', () => {
  const outlines = new SurfaceOutlines(planeUniforms());
  const emphasis = new Emphasis(others as never, outlines, others as never, others as never);
  const room = roomOf(3);
  const tints = () => room.map(({ mesh }) => (mesh.material as ShaderMaterial).uniforms['tint']!.value);
  emphasis.setRoom(room);
  emphasis.glow([0, 2]);
  expect(tints()).toEqual([0, 0, 0]);
  expect(outlines.root.children).toHaveLength(1);
  emphasis.hover(1, null);
  expect(tints()).toEqual([0, 0, 0]);
  expect(outlines.root.children).toHaveLength(2);
  emphasis.setRoom(room); // the room anew, as under other paint
  expect(outlines.root.children).toHaveLength(1);
  emphasis.glow([]);
  expect(outlines.root.children).toHaveLength(0);
});

/** What of a single room is open to an eye outside, and that none of it is open from within or where nothing is cut away. */
import { expect, test } from '@jest/globals';
import { BufferAttribute, BufferGeometry, type DataTexture, Group, Vector3 } from 'three';
import { noSection, sharedUniforms } from '../../../../web/viewer/light/light-material.ts';
import type { RoomMesh } from '../../../../web/viewer/room/room-mesh.ts';
import { Section } from '../../../../web/viewer/room/section.ts';

/** With the insides of walls, or without. */
const roomOf = (backs: readonly BufferGeometry[]) =>
  ({
    root: new Group(),
    lit: backs.map((geometry) => ({ mesh: { geometry }, back: true })),
    box: { min: [0, 0, 0], max: [4, 3, 5] },
  }) as unknown as RoomMesh;

const outside = new Vector3(9, 8, 9);

/** The section of that room, looked at from outside. */
function sectionOf(...backs: readonly BufferGeometry[]) {
  const uniforms = sharedUniforms();
  const section = new Section(uniforms);
  section.setRoom(roomOf(backs));
  section.set(null, true);
  section.look(outside);
  return { uniforms, section };
}

test('the dark shell of a room is cut away for an eye outside alone', () => {
  const { uniforms, section } = sectionOf(new BufferGeometry());
  expect(uniforms.openTo.value).toBe(1.5);
  section.look(new Vector3(2, 1.6, 2));
  expect(uniforms.openTo.value).toBe(noSection);
  section.set(null, false);
  section.look(outside);
  expect(uniforms.openTo.value).toBe(noSection);
  expect(sectionOf().uniforms.openTo.value).toBe(noSection); // of walls with one side the dark ones are meant
});

test('what is cut away of a dark shell is not met by a pointer, lit walls are', () => {
  const { uniforms, section } = sectionOf(new BufferGeometry());
  uniforms.sides.value.set(0, 0, 4, 5);
  uniforms.usualLight.value = 100;
  uniforms.lightTexture.value = { image: { data: new Float32Array([0.5, 50]) } } as unknown as DataTexture;
  const wall = (x: number, nx: number, patch: number) => {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array([x, 1, 2]), 3));
    geometry.setAttribute('normal', new BufferAttribute(new Float32Array([nx, 0, 0]), 3));
    geometry.setAttribute('_patches', new BufferAttribute(new Float32Array([patch, 0, 0, 0]), 4));
    return section.hides(geometry, 0, 1, false);
  };
  expect(wall(4, 1, 0)).toBe(true);
  expect([wall(4, 1, 1), wall(4, -1, 0), wall(0, 1, 0)]).toEqual([false, false, false]);
});

test('a roof is cut away, too, where a little light comes through its joints', () => {
  const { uniforms, section } = sectionOf(new BufferGeometry());
  uniforms.sides.value.set(0, 0, 4, 5);
  uniforms.usualLight.value = 100;
  uniforms.lightTexture.value = { image: { data: new Float32Array([8, 40]) } } as unknown as DataTexture;
  const isHidden = (y: number, up: number, patch: number) => {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array([2, y, 2]), 3));
    geometry.setAttribute('normal', new BufferAttribute(new Float32Array([1 - up, up, 0]), 3));
    geometry.setAttribute('_patches', new BufferAttribute(new Float32Array([patch, 0, 0, 0]), 4));
    return section.hides(geometry, 0, y, false);
  };
  expect(isHidden(3, 1, 0)).toBe(true);
  expect([isHidden(3, 1, 1), isHidden(0, 1, 0), isHidden(3, 0, 0)]).toEqual([false, false, false]);
});

test('the inside of a hollow wall is cut away where a little light comes into it, the front of one is not', () => {
  const [inside, front] = [new BufferGeometry(), new BufferGeometry()];
  for (const geometry of [inside, front]) {
    geometry.setAttribute('position', new BufferAttribute(new Float32Array([4, 1, 2]), 3));
    geometry.setAttribute('normal', new BufferAttribute(new Float32Array([1, 0, 0]), 3));
    geometry.setAttribute('_patches', new BufferAttribute(new Float32Array([0, 0, 0, 0]), 4));
  }
  const { uniforms, section } = sectionOf(inside);
  uniforms.sides.value.set(0, 0, 4, 5);
  uniforms.usualLight.value = 100;
  uniforms.lightTexture.value = { image: { data: new Float32Array([8]) } } as unknown as DataTexture;
  expect([section.hides(inside, 0, 1, false), section.hides(front, 0, 1, false)]).toEqual([true, false]);
});

test('a room that is whole again has the floors and the furniture of all storeys', () => {
  const { uniforms, section } = sectionOf();
  section.set(1.4, true);
  expect(uniforms.storeys.value).toBe(0);
  section.set(null, true);
  expect(uniforms.storeys.value).toBe(noSection);
});

/** What is cut away with a wall (standing, cut-away) and how meshes are taken apart for it (hung-meshes). */
import { describe, expect, test } from '@jest/globals';
import { BufferGeometry, Float32BufferAttribute, Group, Mesh } from 'three';
import { isOutside } from '../../../../web/viewer/room/cut-away.ts';
import { splitHungMeshes } from '../../../../web/viewer/room/hung-meshes.ts';
import { atOnce } from '../../../../web/viewer/stage/breath.ts';
import { hangingSides, leavesPlan, nearSide } from '../../../../web/viewer/room/standing.ts';
import { boxes } from '../boxes.ts';
import type { Box } from '../../../../web/viewer/eye/framing.ts';

const room: Box = { min: [0, 0, 0], max: [8, 3, 6] };

const picture: Box = { min: [2, 1, 0], max: [3, 2, 0.05] };
const board: Box = { min: [7.9, 1, 1], max: [8, 2, 4] };
const table: Box = { min: [3, 0, 2], max: [5, 0.75, 3] };

describe('what hangs on a wall', () => {
  test('is flat and near a side of the room', () => {
    expect(nearSide(room, picture)).toEqual({ axis: 2, sign: -1 });
    expect(nearSide(room, board)).toEqual({ axis: 0, sign: 1 });
    expect(nearSide(room, { min: [1, 2.9, 1], max: [2, 3, 2] })).toEqual({ axis: 1, sign: 1 });
    expect(nearSide(room, table)).toBeNull();
    expect(nearSide(room, { min: [0, 0, 0], max: [8, 0, 6] })).toBeNull(); // the floor
    expect(nearSide(room, { min: [3, 0, 3], max: [5, 2, 3.1] })).toBeNull(); // a partition in the middle
  });

  test('is cut away when the eye stands outside that side', () => {
    expect(isOutside(room, { axis: 2, sign: -1 }, [4, 2, -3])).toBe(true);
    expect(isOutside(room, { axis: 2, sign: -1 }, [4, 2, 9])).toBe(false);
    expect(isOutside(room, { axis: 0, sign: 1 }, [9, 2, 1])).toBe(true);
  });

  test('leaves the plan with its wall, which a shelf that stands there does not', () => {
    const side = { axis: 0, sign: 1 } as const;
    expect(leavesPlan(room, { min: [7.9, 0.9, 1], max: [8.1, 1.2, 3] }, side)).toBe(true); // a sill
    expect(leavesPlan(room, { min: [7.92, 0, 1], max: [8, 2.1, 2] }, side)).toBe(true); // a door
    expect(leavesPlan(room, { min: [7.72, 0, 1], max: [8, 2, 2] }, side)).toBe(false); // a shelf
    expect(leavesPlan(room, { min: [1, 2.9, 1], max: [2, 3, 2] }, { axis: 1, sign: 1 })).toBe(true);
  });

  test('is split from what hangs elsewhere and from what stands', () => {
    const { index, positions } = boxes(picture, board, table);
    const geometry = new BufferGeometry().setIndex(index);
    geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
    const root = new Group().add(new Mesh(geometry));
    const { hanging, standing } = atOnce(splitHungMeshes([root.children[0] as Mesh], room));
    expect([...hanging.values()]).toEqual([
      { axis: 2, sign: -1 },
      { axis: 0, sign: 1 },
    ]);
    expect(root.children.length).toBe(3);
    expect(root.children.filter((mesh) => standing.has(mesh))).toHaveLength(1); // the table
    const triangles = root.children.map((mesh) => (mesh as Mesh<BufferGeometry>).geometry.index!.count / 3);
    expect(triangles).toEqual([12, 12, 12]);
  });

  test('a rug is told from furniture: light is measured on it, not on the floor that it covers', () => {
    const meshes = [{ min: [1, 0.001, 1], max: [3, 0.014, 3] } satisfies Box, table].map((box) => {
      const { index, positions } = boxes(box);
      const geometry = new BufferGeometry().setIndex(index);
      return new Mesh(geometry.setAttribute('position', new Float32BufferAttribute(positions, 3)));
    });
    const { standing, rugs } = atOnce(splitHungMeshes(meshes, room));
    expect([...standing]).toEqual(meshes);
    expect([...rugs]).toEqual([meshes[0]]);
  });
});

describe('what stands in the room', () => {
  const sides = (...parts: Box[]) => hangingSides(room, parts);

  test('keeps its back, whatever wall it stands at', () => {
    const seat: Box = { min: [2, 0, 0.02], max: [4, 0.4, 0.9] };
    const back: Box = { min: [2, 0.4, 0.02], max: [4, 0.8, 0.2] };
    expect(sides(back)).toEqual([{ axis: 2, sign: -1 }]); // alone it would hang
    expect(sides(back, seat)).toEqual([null, null]);
  });

  test('carries what rests on it, over several steps', () => {
    const legs: Box = { min: [7, 0, 1], max: [7.9, 0.7, 2] };
    const top: Box = { min: [7, 0.7, 1], max: [8, 0.74, 2] };
    const screen: Box = { min: [7.8, 0.75, 1.2], max: [7.85, 1.2, 1.8] };
    expect(sides(screen, top, legs)).toEqual([null, null, null]);
  });

  test('does not carry the picture above it, a door beside it, or the wall', () => {
    const sofa: Box = { min: [2, 0, 0.02], max: [4, 0.8, 0.9] };
    const door: Box = { min: [4.01, 0, 0], max: [5, 2.1, 0.05] };
    const wall: Box = { min: [0, 0, 0], max: [8, 3, 0] };
    const skirting: Box = { min: [0, 0, 0], max: [8, 0.1, 6] };
    const behind = { axis: 2, sign: -1 };
    expect(sides(sofa, { min: [2, 1, 0], max: [3, 2, 0.05] }, wall, skirting)).toEqual([
      null,
      behind,
      behind,
      null,
    ]);
    const far: Box = { min: [5.01, 1, 0], max: [5.5, 2, 0.05] };
    expect(sides(sofa, door, far)[2]).toEqual(behind); // a door carries nothing
  });
});

/** The room in plan out of triangles: the floor, its frame, its outline. */
import { describe, expect, test } from '@jest/globals';
import { BufferAttribute, BufferGeometry, Mesh } from 'three';
import { floorTriangles, frameOf, outlinesOf, planOf } from '../../../../web/viewer/room/floor-plan.ts';
import type { RoomMesh } from '../../../../web/viewer/room/room-mesh.ts';
import { atOnce } from '../../../../web/viewer/stage/breath.ts';
import { twiceArea } from '../../../../web/document/plan-frame.ts';

type Corner = readonly [number, number, number];

/** A level rectangle from (x0, z0) to (x1, z1) at a height, facing up. */
function level(
  height: number,
  [x0, z0]: readonly [number, number],
  [x1, z1]: readonly [number, number],
): number[] {
  const [a, b, c, d]: Corner[] = [
    [x0, height, z0],
    [x0, height, z1],
    [x1, height, z1],
    [x1, height, z0],
  ] as const satisfies Corner[];
  return [a!, b!, c!, a!, c!, d!].flat();
}

/** The same with its back up. */
const down = (triangles: readonly number[]): number[] => {
  const flipped: number[] = [];
  for (let i = 0; i < triangles.length; i += 9)
    flipped.push(
      ...triangles.slice(i, i + 3),
      ...triangles.slice(i + 6, i + 9),
      ...triangles.slice(i + 3, i + 6),
    );
  return flipped;
};

// An L of three rectangles that are cut differently, a table in it and a ceiling above.
const floor = [...level(0, [-1, -3], [2, 0]), ...level(0, [2, -3], [5, -1]), ...level(0, [-1, 0], [2, 2])];
const room = [...floor, ...level(0.7, [0, 0], [1, 1]), ...down(level(2.8, [-1, -3], [5, 2]))];

describe('a plan', () => {
  test('takes what faces up at the bottom as the floor', () => {
    expect([...floorTriangles(room)]).toEqual(floor);
    expect(floorTriangles(down(floor))).toHaveLength(0);
  });

  test('begins at the south-west corner', () => {
    expect(frameOf(floor, 2.8)).toEqual({ west: -1, south: 2, floor: 0, size: [6, 5, 2.8] });
  });

  test('has the corners of the outline and no others', () => {
    const [outline, ...more] = atOnce(outlinesOf(floor, frameOf(floor, 2.8)));
    expect(more).toEqual([]);
    expect(outline).toHaveLength(6);
    expect(Math.abs(twiceArea(outline!)) / 2).toBeCloseTo(9 + 6 + 6);
    const corners = outline!.map(([x, y]) => `${x.toFixed(3)} ${y.toFixed(3)}`).sort();
    expect(corners).toEqual(
      ['0.000 0.000', '3.000 0.000', '3.000 3.000', '6.000 3.000', '6.000 5.000', '0.000 5.000'].sort(),
    );
  });

  test('shows a hole in the floor as a loop of its own', () => {
    const ring = [
      ...level(0, [0, 0], [4, 1]),
      ...level(0, [0, 1], [1, 3]),
      ...level(0, [3, 1], [4, 3]),
      ...level(0, [0, 3], [4, 4]),
    ];
    const loops = atOnce(outlinesOf(ring, frameOf(ring, 3)));
    expect(loops.map((loop) => Math.round(Math.abs(twiceArea(loop)) / 2))).toEqual([16, 4]);
  });

  test('is of the lowest level where much faces up: a plinth and a terrace below it are not the floor', () => {
    const plinth = level(-1, [-9, -9], [-6, -7]);
    const terrace = level(-0.4, [-9, -6], [-7, -3]);
    const upstairs = level(3, [-1, -3], [5, 2]);
    expect(frameIn(...plinth, ...terrace, ...room, ...upstairs)).toMatchObject({
      west: -1,
      south: 2,
      floor: 0,
      size: [6, 5, 4],
    });
    expect(frameIn(...room)).toMatchObject({ west: -1, south: 2, floor: 0 });
    expect(frameIn(...down(room)).floor).toBeCloseTo(2.8); // only the back of the ceiling faces up
  });
});

/** The frame of a room whose box reaches from -9 m to 5, 2 and 4 m. */
function frameIn(...corners: number[]) {
  const geometry = new BufferGeometry().setAttribute(
    'position',
    new BufferAttribute(new Float32Array(corners), 3),
  );
  const lit = [{ mesh: new Mesh(geometry), surface: 0, measuring: false }];
  const box = { min: [-9, -1, -9], max: [5, 4, 2] };
  return atOnce(planOf({ lit, box, standing: new Set() } as unknown as RoomMesh)).frame;
}

/** Narrow gaps, closed on the screen: what ends on them comes half way, what is no longer seen is not drawn, wide ones stay. */
import { describe, expect, test } from '@jest/globals';
import { BufferAttribute, BufferGeometry, Matrix4 } from 'three';
import { closeGaps } from '../../../../web/viewer/contact/contact-light.ts';
import { Solids, type SolidPart } from '../../../../web/viewer/contact/lattice.ts';
import { closeNarrowGaps } from '../../../../web/viewer/contact/narrow-gaps.ts';
import type { LitMesh } from '../../../../web/viewer/room/room-mesh.ts';
import { rectangle } from './rectangle.ts';

/** Two desks of 0.8 m, one beside the other: tops, and the sides that look at each other over a gap (m), normals outward. */
function desks(gap: number): SolidPart[] {
  const [left, right] = [-gap / 2, gap / 2];
  return [
    rectangle([[left - 0.8, 0, 0], [0, 0, 0.8], [0.8, 0, 0]] as const, 0), // prettier-ignore
    rectangle([[right, 0, 0], [0, 0, 0.8], [0.8, 0, 0]] as const, 1), // prettier-ignore
    rectangle([[left, 0, 0], [0, 0, 0.8], [0, -0.025, 0]] as const, 2), // prettier-ignore
    rectangle([[right, 0, 0], [0, -0.025, 0], [0, 0, 0.8]] as const, 3), // prettier-ignore
  ];
}

const closed = (gap: number) => closeNarrowGaps(new Solids({ parts: desks(gap), patchCenter: new Float32Array(12), edge: 0.2 })); // prettier-ignore

describe('a gap of 2 mm', () => {
  const [leftTop, rightTop, leftSide, rightSide] = closed(0.002);

  test('is closed: both tops reach a little beyond its middle', () => {
    expect(leftTop!.vertices).toHaveLength(2);
    const alongX = (positions: Float32Array) => [...positions].filter((_, i) => i % 3 === 0);
    for (const x of alongX(leftTop!.positions)) expect(x).toBeCloseTo(0.0001, 5);
    for (const x of alongX(rightTop!.positions)) expect(x).toBeCloseTo(-0.0001, 5);
  });

  test('has no sides any more, and tops are drawn', () => {
    expect([leftSide, rightSide].map((side) => [...side!.hidden])).toEqual([[0, 1], [0, 1]]); // prettier-ignore
    expect([leftTop, rightTop].map((top) => top!.hidden.length)).toEqual([0, 0]);
  });
});

test('a floor of which a corner looks out from under a foot is drawn', () => {
  const floor = rectangle([[0, 0, 0], [0, 0, 0.2], [0.2, 0, 0]] as const, 0); // prettier-ignore
  const hidden = (x: number) => {
    const foot = rectangle([[x, 0.001, x], [0.4, 0, 0], [0, 0, 0.4]] as const, 1); // prettier-ignore
    const parts = [floor, foot];
    return closeNarrowGaps(new Solids({ parts, patchCenter: new Float32Array(6), edge: 0.2 }))[0]!.hidden
      .length;
  };
  expect(hidden(0.005)).toBe(0); // 5 mm of either triangle
  expect(hidden(-0.1)).toBe(2);
});

test('a wall of which a picture covers a part keeps its plane', () => {
  const wall = rectangle([[0, 0, 0], [0, 0, 0.8], [0.8, 0, 0]] as const, 0); // prettier-ignore
  const more = rectangle([[0.8, 0, 0], [0, 0, 0.8], [0.8, 0, 0]] as const, 0); // prettier-ignore
  const both = {
    ...wall,
    index: Uint32Array.of(...wall.index, ...more.index.map((v) => v + 4)),
    positions: Float32Array.of(...wall.positions, ...more.positions),
  };
  const picture = rectangle([[0, 0.001, 0], [0.8, 0, 0], [0, 0, 0.8]] as const, 1); // prettier-ignore
  const parts = [both, picture];
  const [behind] = closeNarrowGaps(new Solids({ parts, patchCenter: new Float32Array(6), edge: 0.2 }));
  expect([behind!.vertices.length, behind!.hidden.length]).toEqual([0, 0]);
});

test('a joint that is to be seen stays', () => {
  for (const { vertices, hidden } of closed(0.004)) expect([vertices.length, hidden.length]).toEqual([0, 0]);
});

test('a mesh that stands elsewhere is moved in its own coordinates, and keeps the order of its triangles', () => {
  const [, , side] = desks(0.002);
  const geometry = new BufferGeometry().setAttribute(
    'position',
    new BufferAttribute(side!.positions.slice(), 3),
  );
  geometry.setIndex([0, 1, 2, 3, 2, 1]);
  const matrixWorld = new Matrix4().makeTranslation(0, 5, 0);
  const gaps = {
    vertices: Uint32Array.of(2),
    positions: Float32Array.of(1, 7, 3),
    hidden: Uint32Array.of(1),
  };
  closeGaps({ geometry, matrixWorld } as LitMesh['mesh'], gaps);
  expect(Array.from(geometry.getAttribute('position').array).slice(6, 9)).toEqual([1, 2, 3]);
  expect([...geometry.index!.array]).toEqual([0, 1, 2, 3, 3, 3]);
});

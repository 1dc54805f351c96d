// Measuring planes that are drawn become nodes of the model that is lit.
import { expect, test } from '@jest/globals';
import { outlineOf } from '../../../../web/document/areas.ts';
import { readContainer, writeGlb } from '../../../../web/document/gltf-container.ts';
import { measuredOutline, withPlanes } from '../../../../web/app/importing/drawn-planes.ts';
import { keptChoices, usualChoices } from '../../../../web/app/importing/model-choices.ts';

const bin = Uint8Array.of(1, 2, 3, 4);
const gltf = {
  asset: { version: '2.0' },
  scene: 1,
  scenes: [{ nodes: [7] }, { nodes: [0] }],
  nodes: [{ name: 'room' }],
  buffers: [{ byteLength: 4 }],
};
const model = { name: 'a.glb', bytes: writeGlb(gltf, bin), siblings: new Map() };
const plane = { name: 'plane 1', outline: outlineOf([1, 2, 4, 4]), height: 0.75, border: 0.5 };

/** Corners of the triangles of the one plane that a file has. */
function cornersOf(scale: number, up: 'y' | 'z'): number[][] {
  const { text, bin: kept } = readContainer(withPlanes(model, [plane], { scale, up }).bytes);
  const read = JSON.parse(text);
  expect([...kept!]).toEqual([...bin]);
  expect(read.scenes).toEqual([{ nodes: [7] }, { nodes: [0, 1] }]);
  expect(read.nodes[1]).toEqual({
    name: 'plane 1',
    mesh: 0,
    extras: { fiatlux: { measure: true, border: plane.border } },
  });
  const bytes = Buffer.from(read.buffers[1].uri.split(',')[1], 'base64');
  expect(bytes.length).toBe(read.buffers[1].byteLength);
  const numbers = [...new Float32Array(Uint8Array.from(bytes).buffer)];
  return Array.from({ length: read.accessors[0].count }, (_, i) => numbers.slice(3 * i, 3 * i + 3));
}

/** Of a triangle, twice its area along each axis. */
function normalOf([a, b, c]: number[][]): number[] {
  const [u, w] = [b!, c!].map((corner) => corner.map((value, i) => value - a![i]!));
  return [0, 1, 2].map((i) => u![(i + 1) % 3]! * w![(i + 2) % 3]! - u![(i + 2) % 3]! * w![(i + 1) % 3]!);
}

test('at their height within their border, facing up, whatever the file counts in', () => {
  const corners = cornersOf(1, 'y');
  expect(corners.every(([x, y, z]) => [1.5, 3.5].includes(x!) && y === 0.75 && [2.5, 3.5].includes(z!))).toBe(
    true,
  );
  const areas = [corners.slice(0, 3), corners.slice(3)].map((triangle) => normalOf(triangle)[1]! / 2);
  expect(areas[0]! > 0 && areas[1]! > 0).toBe(true);
  expect(areas[0]! + areas[1]!).toBeCloseTo(2); // 2 x 1 m
  const inCentimetres = cornersOf(0.01, 'z'); // east, north, up
  expect(
    inCentimetres.every(([x, y, z]) => [150, 350].includes(x!) && [-250, -350].includes(y!) && z === 75),
  ).toBe(true);
  expect(normalOf(inCentimetres.slice(0, 3))[2]).toBeGreaterThan(0);
});

test('what its border leaves nothing of is left out; the outline may run either way', () => {
  expect(measuredOutline({ ...plane, border: 1 })).toBeNull();
  const counterClockwise = [...plane.outline].reverse();
  expect(measuredOutline({ ...plane, outline: counterClockwise })).toHaveLength(4);
  const { nodes } = JSON.parse(
    readContainer(withPlanes(model, [{ ...plane, border: 1 }], { scale: 1, up: 'y' }).bytes).text,
  );
  expect(nodes).toHaveLength(1);
  expect(withPlanes(model, [], { scale: 1, up: 'y' })).toBe(model);
});

test('planes are kept with the other choices', () => {
  const choices = { ...usualChoices, drawn: [plane] };
  expect(keptChoices(structuredClone(choices))).toEqual(choices);
  expect(keptChoices({ ...choices, drawn: [{ ...plane, outline: [[0, 0]] }] })).toBeNull();
});

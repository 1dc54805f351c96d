import { describe, expect, test } from '@jest/globals';
import { BoxGeometry, EdgesGeometry, PlaneGeometry } from 'three';
import { boxes } from './boxes.ts';
import type { Box } from '../../../web/viewer/eye/framing.ts';
import { connectedParts } from '../../../web/viewer/room/mesh-parts.ts';
import { atOnce } from '../../../web/viewer/stage/breath.ts';
import { surfaceEdges } from '../../../web/viewer/room/surface-edges.ts';
import { crowdedTags, spreadTags } from '../../../web/viewer/luminaires/tag-layout.ts';

const picture: Box = { min: [2, 1, 0], max: [3, 2, 0.05] };
const board: Box = { min: [7.9, 1, 1], max: [8, 2, 4] };

test('connected parts hang together through vertices at the same place', () => {
  const { index, positions } = boxes(picture, board);
  expect(atOnce(connectedParts(index, positions)).map((part) => part.length)).toEqual([12, 12]);
  const touching = boxes(picture, { min: [3, 1, 0], max: [4, 2, 0.05] });
  expect(atOnce(connectedParts(touching.index, touching.positions))).toHaveLength(1);
});

describe('edges of a surface', () => {
  const count = (ends: Float32Array) => ends.length / 6;

  test('are its boundary, however it is cut', () => {
    const plane = new PlaneGeometry(2, 1, 8, 4);
    const ends = atOnce(surfaceEdges(plane.index!.array, plane.getAttribute('position').array, 35));
    expect(count(ends)).toBe(2 * (8 + 4)); // the sides of the outermost cells
    for (let i = 0; i < ends.length; i += 3) {
      const onEdge = Math.abs(Math.abs(ends[i]!) - 1) < 1e-6 || Math.abs(Math.abs(ends[i + 1]!) - 0.5) < 1e-6;
      expect(onEdge).toBe(true);
    }
  });

  test('are not the seams of flat neighbours that are cut differently', () => {
    const left = new PlaneGeometry(1, 1, 1, 3).translate(-0.5, 0, 0);
    const right = new PlaneGeometry(1, 1, 1, 4).translate(0.5, 0, 0);
    const shift = left.getAttribute('position').count;
    const index = [...left.index!.array, ...[...right.index!.array].map((vertex) => vertex + shift)];
    const positions = [...left.getAttribute('position').array, ...right.getAttribute('position').array];
    const ends = atOnce(surfaceEdges(index, positions, 35));
    for (let i = 0; i < ends.length; i += 6)
      expect(Math.abs(ends[i]!) + Math.abs(ends[i + 3]!)).toBeGreaterThan(0.9);
    let length = 0;
    for (let i = 0; i < ends.length; i += 6)
      length += Math.hypot(ends[i + 3]! - ends[i]!, ends[i + 4]! - ends[i + 1]!);
    expect(length).toBeCloseTo(6);
  });

  test('are the creases of a closed body, as three finds them', () => {
    const box = new BoxGeometry(1, 2, 3, 2, 3, 4);
    const ends = atOnce(surfaceEdges(box.index!.array, box.getAttribute('position').array, 35));
    expect(count(ends)).toBe(4 * (2 + 3 + 4));
    expect(count(ends)).toBe(new EdgesGeometry(box, 35).getAttribute('position').count / 2);
    expect(count(atOnce(surfaceEdges(box.index!.array, box.getAttribute('position').array, 100)))).toBe(0);
  });
});

describe('tags', () => {
  test('that overlap are pushed apart, the others stay', () => {
    const places = [
      { x: 100, y: 100 },
      { x: 104, y: 102 },
      { x: 300, y: 50 },
    ];
    const [a, b, c] = spreadTags(places, 30, 18);
    expect(Math.abs(a!.x - b!.x) >= 29.9 || Math.abs(a!.y - b!.y) >= 17.9).toBe(true);
    expect(c).toEqual(places[2]);
  });

  test('never go far from their luminaires', () => {
    const places = Array.from({ length: 12 }, () => ({ x: 10, y: 10 }));
    for (const { x, y } of spreadTags(places, 30, 18)) {
      expect(Math.abs(x - 10)).toBeLessThanOrEqual(26);
      expect(Math.abs(y - 10)).toBeLessThanOrEqual(26);
    }
    // Small ones on a phone stay nearer: what is as far as the next luminaire seems to be that one's.
    for (const { x, y } of spreadTags(places, 30, 16)) {
      expect(Math.abs(x - 10)).toBeLessThanOrEqual(8);
      expect(Math.abs(y - 10)).toBeLessThanOrEqual(8);
    }
  });
});

test('tags that find no place of their own become dots, those that matter never', () => {
  const places = [
    { x: 0, y: 0 },
    { x: 4, y: 2 },
    { x: 100, y: 0 },
  ];
  expect(crowdedTags(places, 32, 19, () => false)).toEqual([false, true, false]);
  expect(crowdedTags(places, 32, 19, (index) => index === 1)).toEqual([true, false, false]);
  // A third of one tag under another was still read as two, and looked like a heap.
  const heap = [0, 16, 32].map((x) => ({ x, y: 8 }));
  expect(crowdedTags(heap, 24, 15, () => false)).toEqual([false, true, false]);
});

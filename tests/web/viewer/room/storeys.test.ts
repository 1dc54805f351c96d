// Storeys and rooms of a made building, and the eyes in them; also columns, and what a section leaves whole.
import { describe, expect, test } from '@jest/globals';
import { forEachCut, type Solid } from '../../../../web/viewer/room/columns.ts';
import { standingStoreys } from '../../../../web/viewer/room/section.ts';
import { isBuilding, openingCut, storeysOf, type Storey } from '../../../../web/viewer/room/storeys.ts';
import type { Box } from '../../../../web/viewer/eye/framing.ts';
import { building, makeBuilding } from '../../../rooms/made-building.mjs';
import { readRoom } from '../../../rooms/read-room.mjs';

/** Its surfaces are its nodes. */
type Nodes = Awaited<ReturnType<typeof readRoom>>['nodes'];

const solidsOf = (nodes: Nodes): Solid[] =>
  nodes.map(({ triangles }, surface) => {
    const positions = triangles.flatMap(({ points }) => points.flat());
    return { index: [...Array(positions.length / 3).keys()], positions, surface };
  });

const boxOf = (solids: readonly Solid[]): Box => {
  const min: [number, number, number] = [Infinity, Infinity, Infinity];
  const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (const { positions } of solids)
    for (let i = 0; i < positions.length; i++) {
      min[i % 3] = Math.min(min[i % 3]!, positions[i]!);
      max[i % 3] = Math.max(max[i % 3]!, positions[i]!);
    }
  return { min, max };
};

const { nodes } = await readRoom(await makeBuilding().bytes());
const all = solidsOf(nodes);
const storeys = storeysOf(all, boxOf(all));

/** Its rooms in plan: in the west, in the north east, in the south east. */
const rooms = [
  [0, 6, 0, 9],
  [6.16, 12, 0, 4.5],
  [6.16, 12, 4.66, 9],
] as const;

describe('a building of two storeys', () => {
  test('has its floors, each with three rooms that doors join', () => {
    expect(storeys.map(({ floor }) => Math.round(100 * floor) / 100)).toEqual([0, building.storey]);
    expect(storeys.map((storey) => storey.rooms.length)).toEqual([3, 3]);
    for (const { clear } of storeys) expect(clear).toBeCloseTo(building.clear, 1);
    const [hall] = storeys[0]!.rooms;
    expect(hall!.area).toBeGreaterThan(44);
    expect(hall!.area).toBeLessThan(54);
    expect(isBuilding(storeys)).toBe(true);
  });

  test('is stood in at eye height, a step away from all walls, looking through the room', () => {
    for (const storey of storeys)
      for (const [west, east, north, south] of rooms) {
        const inside = storey.rooms.filter(
          ({ eye: [x, , z] }) => x > west && x < east && z > north && z < south,
        );
        expect(inside).toHaveLength(1);
        const { eye, ahead } = inside[0]!;
        expect(eye[1] - storey.floor).toBeCloseTo(1.6, 6);
        expect(Math.min(eye[0] - west, east - eye[0], eye[2] - north, south - eye[2])).toBeGreaterThan(0.3);
        const free = { x: ahead[0] > 0 ? east - eye[0] : eye[0] - west, z: ahead[2] > 0 ? south - eye[2] : eye[2] - north }; // prettier-ignore
        const seen = Math.min(free.x / Math.abs(ahead[0]), free.z / Math.abs(ahead[2]));
        expect(seen).toBeGreaterThan(3);
      }
  });

  test('tells whose floor a room has, where it has one of its own', () => {
    const names = (storey: Storey) => storey.rooms.map(({ surface }) => nodes[surface]?.name ?? null);
    expect(names(storeys[0]!).sort()).toEqual(['Hall floor', 'Kitchen floor', 'Study floor']);
    expect(names(storeys[1]!)).toEqual([null, null, null]);
  });

  test('keeps its upper storey where the roof is taken off', () => {
    const open = solidsOf(nodes.filter(({ name }) => name !== 'roof'));
    expect(storeysOf(open, boxOf(open)).map((storey) => storey.rooms.length)).toEqual([3, 3]);
  });
});

test('a room without inner walls is no building, and neither is its table a floor', () => {
  const lower = solidsOf(nodes.filter(({ name }) => /^(ground|slab|lower (?!between|across))/.test(name)));
  const found = storeysOf(lower, boxOf(lower));
  expect(found.map((storey) => storey.rooms.length)).toEqual([1]);
  expect(isBuilding(found)).toBe(false);
});

test('a level plane cuts a triangle in one segment, and one that it does not meet in none', () => {
  const positions = [0, 0, 0, 4, 0, 0, 0, 2, 0];
  const cuts: number[][] = [];
  forEachCut([0, 1, 2], positions, 1, (...ends) => cuts.push(ends));
  forEachCut([0, 1, 2], positions, 3, (...ends) => cuts.push(ends));
  expect(cuts).toEqual([[2, 0, 0, 0]]);
});

test('furniture stands whole on its storey with what it carries; walls and what hangs on them are cut', () => {
  const twoFloors: Storey[] = [0, 3].map((floor) => ({ floor, clear: 2.7, rooms: [] }));
  const parts: Box[] = [
    { min: [2, 0, 2], max: [4, 0.75, 3] }, // a table
    { min: [2.5, 0.75, 2.2], max: [3, 1.2, 2.3] }, // a screen on it
    { min: [0, 0, 0], max: [6, 2.7, 0.2] }, // a wall
    { min: [2, 1.5, 0.2], max: [3, 2, 0.24] }, // a picture on it
    { min: [2, 3, 2], max: [4, 3.75, 3] }, // a table above
    { min: [1, 2.2, 1], max: [1.4, 2.6, 1.4] }, // a pendant
    { min: [5, 0, 1], max: [6, 3, 4] }, // a stair
  ];
  expect(standingStoreys(parts, twoFloors)).toEqual([1, 1, 0, 0, 2, 0, 0]);
});

test('a building is opened at the storey that is asked about, where others lie over it', () => {
  const tall = [0, 3, 6].map((floor) => ({ floor, clear: 2.7, rooms: [] }));
  const asked = [0, 0.75, 2.9, 3, 3.75]; // floors and planes, a floor on a thinner slab
  expect(asked.map((height) => openingCut(tall, height))).toEqual([1.5, 1.5, 4.5, 4.5, 4.5]);
  expect([6, 6.75, -2].map((height) => openingCut(tall, height))).toEqual([null, null, null]);
  expect(openingCut([{ floor: 0, clear: 1.6, rooms: [] }, ...tall.slice(1)], 0)).toBe(1.3);
});

// Plans become rooms: closed walls, areas, openings, columns, marks for the pipeline.
// Covers make-room, mounts, items, gltf-room, polygon.
import { describe, expect, test } from '@jest/globals';
import { readRoom } from '../../rooms/read-room.mjs';
import { areaOf, doubleSurfaceArea, normalOf, openEdgeLength, volumeOf } from '../../rooms/geometry.mjs';
import { luminance } from '../../../web/document/linear-colour.mjs';
import { tintOf } from '../../../web/room-maker/colour.mjs';
import { ItemShapes, floorOf, footprint, isColumn } from '../../../web/room-maker/items.mjs';
import {
  builtOpenings,
  clearColumns,
  glbOf,
  makeRoom,
  planeOutline,
} from '../../../web/room-maker/make-room.mjs';
import { railLines } from '../../../web/room-maker/mounts.mjs';
import { planFaults } from '../../../web/room-maker/plan-faults.mjs';
import {
  contains,
  distance,
  distanceToOutline,
  inset,
  rotated,
  signedArea,
} from '../../../web/room-maker/polygon.mjs';
import { itemKinds, planOf, usualItem, usualOpening } from '../../../web/room-maker/room-plan.mjs';
import { outlines } from '../../../web/room-maker/plan-shapes.mjs';

const area = (triangles) => triangles.reduce((sum, { points }) => sum + areaOf(points), 0);
const read = async (plan) => readRoom(await glbOf(plan));
const named = ({ nodes }, pattern) => nodes.filter(({ name }) => pattern.test(name));
const areaNamed = (room, pattern) =>
  named(room, pattern).reduce((sum, { triangles }) => sum + area(triangles), 0);

const rectangle = () => planOf(outlines.rectangle(6, 4), 2.8);

test.each([
  ['rectangle', 24, 20],
  ['L', 18, 20],
  ['U', 20, 24],
  ['T', 16, 20],
])('a room in the shape of a %s is closed and has its areas', async (shape, floor, around) => {
  const room = await read(planOf(outlines[shape](6, 4), 2.8));
  expect(openEdgeLength(room.triangles)).toBeLessThan(1e-6);
  expect(volumeOf(room.triangles)).toBeCloseTo(-2.8 * floor, 4);
  expect(areaNamed(room, /^floor$/)).toBeCloseTo(floor, 4);
  expect(areaNamed(room, /^ceiling/)).toBeCloseTo(floor, 4);
  expect(areaNamed(room, /^wall/)).toBeCloseTo(2.8 * around, 4);
});

test('a polygon with oblique walls is closed', async () => {
  const outline = [[0, 0], [5.3, 0.7], [7, 3], [4.1, 3.2], [3.3, 6], [-1, 4]]; // prettier-ignore
  const room = await read(planOf(outline, 3));
  expect(openEdgeLength(room.triangles)).toBeLessThan(1e-6);
  expect(volumeOf(room.triangles)).toBeCloseTo(-3 * signedArea(outline), 4);
});

test('doors and windows are cut into their walls, and the room stays closed', async () => {
  const plan = rectangle();
  plan.openings = [usualOpening('window', 0, 1), usualOpening('window', 0, 3.2), usualOpening('door', 2, 1)];
  const room = await read(plan);
  expect(openEdgeLength(room.triangles)).toBeLessThan(1e-6);
  expect(areaNamed(room, /^wall north/)).toBeCloseTo(6 * 2.8 - 2 * 1.6 * 1.35, 4);
  expect(areaNamed(room, /^wall south/)).toBeCloseTo(6 * 2.8 - 1.13 * 2.19, 4);
  expect(named(room, /^(window|door) \d$/).map(({ name }) => name)).toEqual([
    'window 1',
    'window 2',
    'door 1',
  ]);
});

test('an opening that does not fit is kept in the plan and not built', async () => {
  const plan = rectangle();
  const [wide, tall, late] = [
    { ...usualOpening('window', 0, 1), width: 9 },
    { ...usualOpening('window', 0, 1), height: 2.5 },
    usualOpening('window', 0, 2),
  ];
  const first = usualOpening('window', 0, 1);
  plan.openings = [wide, tall, first, late];
  expect(builtOpenings(plan, 0)).toEqual([first]);
  expect(openEdgeLength((await read(plan)).triangles)).toBeLessThan(1e-6);
});

test('floor, ceiling and working plane end at a column that stands free', async () => {
  const plan = rectangle();
  plan.items = [usualItem('column', [2, 2], 2.8, 20), usualItem('round column', [4, 2], 2.8)];
  const bases = plan.items.reduce((sum, item) => sum + signedArea(footprint(item)), 0);
  const room = await read(plan);
  expect(clearColumns(plan)).toHaveLength(2);
  expect(openEdgeLength(room.triangles)).toBeLessThan(1e-6);
  expect(areaNamed(room, /^floor$/)).toBeCloseTo(24 - bases, 4);
  expect(areaNamed(room, /^working plane$/)).toBeCloseTo(15 - bases, 4);
  expect(volumeOf(room.triangles)).toBeCloseTo(-2.8 * (24 - bases), 4);
});

test('a column at a wall stands in the room as a closed block', async () => {
  const plan = rectangle();
  plan.items = [usualItem('column', [0.205, 2], 2.8)];
  expect(clearColumns(plan)).toHaveLength(0);
  const room = await read(plan);
  expect(openEdgeLength(room.triangles)).toBeLessThan(1e-6);
  expect(areaNamed(room, /^floor$/)).toBeCloseTo(24, 4);
});

test.each(itemKinds)('a %s is made of closed solids above the floor', async (kind) => {
  const [empty, furnished] = [rectangle(), rectangle()];
  furnished.items = [usualItem(kind, [3, 2], 2.8, 90)];
  const [bare, room] = [await read(empty), await read(furnished)];
  expect(room.triangles.length).toBeGreaterThan(bare.triangles.length);
  expect(openEdgeLength(room.triangles)).toBeLessThan(1e-6);
  expect(doubleSurfaceArea(room.triangles)).toBeLessThan(1e-6);
  expect(volumeOf(room.triangles)).toBeGreaterThan(-2.8 * 24 - 1e-4);
});

test.each(itemKinds)('a %s stands within the floor that is kept for it', (kind) => {
  const plan = rectangle();
  plan.items = [usualItem(kind, [3, 2], 2.8, 30)];
  const [item] = plan.items;
  const floor = floorOf(item);
  const shapes = isColumn(item) ? [] : new ItemShapes().of(item).map(({ shape }) => shape);
  const corners = shapes.flatMap(({ triangles }) => triangles.flatMap(({ points }) => points));
  const places = rotated(corners.map(([x, , z]) => [x, z]), item.turn); // prettier-ignore
  // a round footprint has fewer corners than its table, and lies up to 5 mm within
  const beyond = places
    .map(([x, z]) => [x + item.x, z + item.z])
    .filter((place) => !contains(floor, place) && distanceToOutline(floor, place) > 0.006);
  expect(beyond).toEqual([]);
});

test('rows of the same furniture share their meshes', () => {
  const plan = rectangle();
  plan.items = [1, 2, 3, 4].map((x) => usualItem('desk', [x, 2], 2.8));
  const { document } = makeRoom(plan);
  expect(document.getRoot().listNodes().filter((node) => node.getName().startsWith('desk'))).toHaveLength(8); // prettier-ignore
  expect(document.getRoot().listMeshes().filter((mesh) => mesh.getName().startsWith('desk'))).toHaveLength(2); // prettier-ignore
});

describe('where luminaires may hang', () => {
  const marked = ({ nodes }) => nodes.filter(({ fiatlux }) => fiatlux.mount);

  test('all of the ceiling', async () => {
    const [mount, ...others] = marked(await read(rectangle()));
    expect(others).toEqual([]);
    expect(mount).toMatchObject({ name: 'ceiling', fiatlux: { siteSpacing: 0.6, siteSize: 0.6 } });
    expect(mount.fiatlux.drop).toBeUndefined();
    expect(mount.triangles.every(({ points }) => normalOf(points)[1] < -0.999)).toBe(true);
  });

  test('a plane below it, for small luminaires far apart', async () => {
    const plan = rectangle();
    plan.mount = { ...plan.mount, kind: 'plane', spacing: 1.2, luminaire: 0.3, drop: 0.8 };
    const [mount, ...others] = marked(await read(plan));
    expect(others).toEqual([]);
    expect(mount.fiatlux).toMatchObject({ siteSpacing: 1.2, siteSize: 0.3, drop: 0.8 });
    expect(planFaults(plan)).toEqual([]);
    plan.mount.drop = 2.75;
    expect(planFaults(plan)).toEqual([{ fault: 'belowFloor' }]);
    plan.mount = { ...plan.mount, drop: 0.8, luminaire: 1.5 };
    expect(planFaults(plan)).toEqual([{ fault: 'overlap' }]);
  });

  test.each([0, 30])('whole tiles of a grid at %s degrees; the ceiling stays whole', async (turn) => {
    const plan = rectangle();
    plan.mount = { ...plan.mount, kind: 'tiles', origin: [0.3, 0.1], turn };
    const room = await read(plan);
    const [tiles] = marked(room);
    const count = area(tiles.triangles) / 0.36;
    expect(count).toBeCloseTo(Math.round(count), 4);
    if (turn === 0) expect(Math.round(count)).toBe(9 * 6);
    expect(Math.round(count)).toBeGreaterThan(35);
    expect(areaNamed(room, /^ceiling/)).toBeCloseTo(24, 4);
    expect(volumeOf(room.triangles)).toBeCloseTo(-2.8 * 24, 3);
    if (turn === 0) {
      const corners = tiles.triangles.flatMap(({ points }) => points);
      for (const [x, , z] of corners)
        for (const along of [(x - 0.3) / 0.6, (z - 0.1) / 0.6])
          expect(along).toBeCloseTo(Math.round(along), 4);
    }
  });

  test('rails stay within the room and clear of columns', async () => {
    const plan = planOf(outlines.L(8, 6, 4, 3), 3);
    plan.items = [usualItem('column', [2, 1], 3)];
    plan.mount = { ...plan.mount, kind: 'rails', spacing: 0.3, luminaire: 0.06, drop: 0.4, rows: 1 };
    const lines = railLines(plan, [footprint(plan.items[0])]);
    expect(lines).toHaveLength(6);
    for (const { from, to, at } of lines) {
      expect(contains(plan.outline, [from - 0.04, at]) && contains(plan.outline, [to + 0.04, at])).toBe(true);
      expect(at > 0.8 && at < 1.2 && from < 2 && to > 2).toBe(false);
    }
    plan.items = [];
    const [rails] = marked(await read(plan));
    expect(rails).toMatchObject({ name: 'rails', fiatlux: { siteSpacing: 0.3, siteSize: 0.06 } });
    const heights = rails.triangles.flatMap(({ points }) => points.map(([, y]) => y));
    expect(Math.max(...heights)).toBeCloseTo(2.6, 5);
    expect(openEdgeLength(rails.triangles.map(({ points }) => points))).toBeLessThan(1e-6);
  });
});

describe('the working plane', () => {
  test('keeps its rim from every wall', () => {
    const plan = planOf(outlines.L(6, 4), 2.8);
    const outline = planeOutline(plan);
    expect(signedArea(outline)).toBeCloseTo(18 - 20 * 0.5 + 4 * 0.25, 6);
    expect(outline.every((corner) => contains(plan.outline, corner))).toBe(true);
    expect(distance(outline[0], [0.5, 0.5])).toBeLessThan(1e-9);
  });

  test('says how far it stays away from the walls, so that no rim is left out twice, nor any of a task area', async () => {
    const plan = { ...rectangle(), plane: { height: 0.75, rim: 0.35 } };
    plan.tasks = [{ x: 2, z: 2, width: 1.2, depth: 0.6, height: 0.75, turn: 0 }];
    const borders = (await read(plan)).nodes
      .filter(({ fiatlux }) => fiatlux.measure)
      .map(({ name, fiatlux }) => [name, fiatlux.border]);
    expect(borders).toEqual([
      ['working plane', 0.35],
      ['task area 1', 0.5],
    ]);
  });

  test('is left out where the room is too narrow for its rim', async () => {
    const plan = planOf(outlines.rectangle(6, 0.9), 2.8);
    expect(inset(plan.outline, 0.5)).toBeNull();
    expect(named(await read(plan), /^working plane$/)).toEqual([]);
  });

  test('is marked, and so are task areas, all looking up', async () => {
    const plan = rectangle();
    plan.tasks = [{ x: 2, z: 2, width: 1.2, depth: 0.6, height: 0.75, turn: 40 }];
    const planes = (await read(plan)).nodes.filter(({ fiatlux }) => fiatlux.measure);
    expect(planes.map(({ name }) => name)).toEqual(['working plane', 'task area 1']);
    expect(area(planes[1].triangles)).toBeCloseTo(0.72, 5);
    for (const { triangles } of planes) for (const { points } of triangles) expect(normalOf(points)[1]).toBeCloseTo(1, 5); // prettier-ignore
  });
});

test.each([
  ['#f2bd2d', 0.9],
  ['#b3261e', 0.7],
  ['#000000', 0.3],
  ['#8d8b88', 0.2],
])('a surface of the colour %s gives back exactly %s', (colour, reflectance) => {
  const tint = tintOf(colour, reflectance);
  expect(luminance(tint)).toBeCloseTo(reflectance, 9);
  expect(tint.every((c) => c >= 0 && c <= 1 + 1e-12)).toBe(true);
});

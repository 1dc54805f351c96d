// The plan of a room that is made here: a few numbers from which the same glTF follows everywhere. Metres and degrees;
// x to the right and z downwards in the plan, y up. Wall i leads from corner i to corner i + 1, the room at its right hand
// as the plan is drawn; positions along a wall are counted from its first corner.
import * as v from 'valibot';
import { distance, isSimple, signedArea } from './polygon.mjs';

function number(low, high) {
  const range = `it must lie between ${low} and ${high}`;
  return v.pipe(v.number(), v.finite(range), v.minValue(low, range), v.maxValue(high, range));
}
const atMost = (count) => v.maxLength(count, `there are more than ${count}`);
const coordinate = number(-1000, 1000);
const degrees = number(-3600, 3600);

/** What can stand in a room, in the order of their codes in links: new ones come last. */
export const itemKinds = [
  'desk', 'workplace', 'table', 'round table', 'chair', 'office chair', 'cupboard', 'bookcase', 'sofa', 'bench',
  'partition', 'plant', 'column', 'round column',
]; // prettier-ignore
export const openingKinds = ['door', 'window'];
export const mountKinds = ['ceiling', 'tiles', 'rails', 'plane'];

export const mostItems = 500;
export const mostCorners = 64;
const mostOpenings = 200;
const mostTasks = 50;
const leastWall = 0.05; // m
const leastFloor = 0.25; // m2

const colour = v.pipe(v.string(), v.regex(/^#[0-9a-f]{6}$/, 'it is no colour such as #f4f1ea'));
const finish = v.object({ reflectance: number(0, 0.95), colour });

const opening = v.object({
  kind: v.picklist(openingKinds),
  wall: v.pipe(number(0, mostCorners - 1), v.integer()),
  at: number(0, 1000), // m along the wall, to the opening's nearer edge
  width: number(0.1, 100),
  sill: number(0, 50), // m above the floor; 0 for doors
  height: number(0.1, 50),
});

const item = v.object({
  kind: v.picklist(itemKinds),
  x: coordinate, // of its centre
  z: coordinate,
  turn: degrees, // counter-clockwise as seen from above; 0: its front looks down the plan
  size: v.tuple([number(0.05, 50), number(0.02, 50), number(0.05, 50)]), // width, depth, height
});

const mount = v.object({
  kind: v.picklist(mountKinds),
  spacing: number(0.05, 20), // m between places; the tile's edge where the ceiling has tiles
  luminaire: number(0.02, 20), // m, its edge; the width of a rail
  drop: number(0, 40), // m below the ceiling: rails and suspended planes
  rows: number(0.1, 50), // m between rails
  origin: v.tuple([coordinate, coordinate]), // a corner of a tile
  turn: degrees, // of tiles and rails
});

const plane = v.object({ height: number(0, 50), rim: number(0, 50) });

const task = v.object({
  x: coordinate, z: coordinate, width: number(0.05, 100), depth: number(0.05, 100), height: number(0, 50), turn: degrees,
}); // prettier-ignore

const planSchema = v.pipe(
  v.object({
    name: v.pipe(v.string(), v.maxLength(2000), v.transform(cleaned)),
    outline: v.pipe(
      v.array(v.tuple([coordinate, coordinate])),
      v.minLength(3, 'there are fewer than 3 corners'),
      atMost(mostCorners),
    ),
    height: number(0.5, 50),
    finishes: v.object({ ceiling: finish, walls: finish, floor: finish }),
    openings: v.pipe(v.array(opening), atMost(mostOpenings)),
    items: v.pipe(v.array(item), atMost(mostItems)),
    mount,
    plane: v.nullable(plane),
    tasks: v.pipe(v.array(task), atMost(mostTasks)),
  }),
  v.check(({ outline }) => isSimple(outline), 'the walls cross or touch each other'),
  v.check(({ outline }) => Math.abs(signedArea(outline)) >= leastFloor, 'the floor is smaller than 0.25 m2'),
  v.check(
    ({ outline }) => outline.every((a, i) => distance(a, outline[(i + 1) % outline.length]) >= leastWall),
    'a wall is shorter than 5 cm',
  ),
  v.transform((plan) => (signedArea(plan.outline) > 0 ? plan : turnedRound(plan))),
);

function cleaned(text) {
  return text.replace(/\p{C}/gu, '').trim().slice(0, 80);
}

/** An outline that was drawn the other way round; each opening stays where it was. */
function turnedRound(plan) {
  const { outline } = plan;
  const count = outline.length;
  const openings = plan.openings.map((each) => {
    if (each.wall >= count) return each;
    const length = distance(outline[each.wall], outline[(each.wall + 1) % count]);
    return {
      ...each,
      wall: (2 * count - 2 - each.wall) % count,
      at: Math.max(0, length - each.at - each.width),
    };
  });
  return { ...plan, outline: [...outline].reverse(), openings };
}

/** Reads a plan from anywhere; { plan } or { fault }, one clause. Never throws. */
export function readPlan(value) {
  const read = v.safeParse(planSchema, value);
  if (read.success) return { plan: read.output };
  const [issue] = read.issues;
  const path = issue.path?.map(({ key }) => String(key)).join('.') ?? '';
  const what = issue.message.startsWith('Invalid ') ? 'it is missing or of another kind' : issue.message;
  return { fault: `${path ? `${path}: ` : ''}${what}`.replace(/\p{C}/gu, '').slice(0, 160) };
}

/** Usual sizes [width, depth, height] in metres. */
const itemSizes = {
  desk: [1.6, 0.8, 0.74],
  workplace: [1.6, 0.8, 0.74],
  table: [1.4, 0.8, 0.74],
  'round table': [1.2, 1.2, 0.74],
  chair: [0.45, 0.5, 0.8],
  'office chair': [0.65, 0.65, 1.0],
  cupboard: [1.2, 0.42, 0.9],
  bookcase: [1.2, 0.32, 1.9],
  sofa: [1.9, 0.82, 0.8],
  bench: [1.6, 0.45, 0.45],
  partition: [1.6, 0.04, 1.4],
  plant: [0.8, 0.8, 1.5],
  column: [0.4, 0.4, 0],
  'round column': [0.4, 0.4, 0],
};

/** Which of width, depth and height a person may choose. */
export const sizesOf = {
  desk: 'wdh', workplace: 'wd', table: 'wdh', 'round table': 'wh', chair: '', 'office chair': '', cupboard: 'wdh',
  bookcase: 'wdh', sofa: 'w', bench: 'wdh', partition: 'wh', plant: 'h', column: 'wd', 'round column': 'w',
}; // prettier-ignore

export function usualItem(kind, [x, z], height, turn = 0) {
  const [width, depth, own] = itemSizes[kind];
  return { kind, x, z, turn, size: [width, depth, own || height] };
}

export function usualOpening(kind, wall, at) {
  return kind === 'door'
    ? { kind, wall, at, width: 0.95, sill: 0, height: 2.1 }
    : { kind, wall, at, width: 1.6, sill: 0.9, height: 1.35 };
}

const usualFinishes = {
  ceiling: { reflectance: 0.7, colour: '#f7f6f2' },
  walls: { reflectance: 0.5, colour: '#e9e6df' },
  floor: { reflectance: 0.2, colour: '#8d8b88' },
};

/** An empty room with this outline. */
export function planOf(outline, height, name = '') {
  return {
    name,
    outline: outline.map((corner) => [...corner]),
    height,
    finishes: structuredClone(usualFinishes),
    openings: [],
    items: [],
    mount: { kind: 'ceiling', spacing: 0.6, luminaire: 0.6, drop: 0.5, rows: 1.8, origin: [0, 0], turn: 0 },
    plane: { height: 0.75, rim: 0.5 },
    tasks: [],
  };
}

/** What walls are called: by the compass where there are four along the axes, else numbered. */
export function wallName({ outline }, wall) {
  const alongAxes = outline.every(([x, z], i) => {
    const [nx, nz] = outline[(i + 1) % outline.length];
    return x === nx || z === nz;
  });
  if (outline.length !== 4 || !alongAxes) return `wall ${wall + 1}`;
  const [[ax, az], [bx, bz]] = [outline[wall], outline[(wall + 1) % 4]];
  return `wall ${bx > ax ? 'north' : bz > az ? 'east' : bx < ax ? 'south' : 'west'}`;
}

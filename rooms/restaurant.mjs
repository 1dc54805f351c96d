// A restaurant at night, 10 x 7 x 3 m: nine laid tables, a banquette, a bar; dark walls, the windows black.
// Pendants hang 1.3 m below the ceiling, in a grid of 0.7 m whose places lie above the tables' middles (140 sites).
import { paintings } from './art.mjs';
import { roundTable, table } from '../web/room-maker/furniture.mjs';
import { floorPlant } from '../web/room-maker/plants.mjs';
import { createRandom } from '../web/room-maker/random.mjs';
import * as patterns from './patterns.mjs';
import { backBar, banquette, bar, barStool, diningChair, setting } from './restaurant-furniture.mjs';
import { Room } from './room.mjs';
import { Shape, turned } from '../web/room-maker/shape.mjs';
import { door, gridFrame, panel, slab, wall, wallFrames } from '../web/room-maker/walls.mjs';

const [width, height, depth] = [10, 3, 7];
const pitch = 0.7; // m between places for pendants
const drop = 1.3; // m, of a pendant
const tableHeight = 0.74;

const own = {
  'olive plaster': { paint: () => patterns.plaster('#6b7259', 71), tile: [3, 3], reflectance: 0.16 },
  'terracotta plaster': { paint: () => patterns.plaster('#b0694a', 72), tile: [3, 3], reflectance: 0.21 },
  'evening ceiling': { paint: () => patterns.plaster('#d9cfbd', 73), tile: [3, 3], reflectance: 0.5 },
  'herringbone oak': { paint: () => patterns.planks('#8e6b48', 74), tile: [1.8, 0.96], reflectance: 0.17 },
  'walnut panelling': {
    paint: () => patterns.veneer('#6e4a31', 75, true),
    tile: [0.5, 1],
    reflectance: 0.12,
    roughness: 0.55,
  },
  'petrol velvet': { paint: () => patterns.weave('#1f4f57', 76), tile: [0.2, 0.2], reflectance: 0.08 },
  'table oak': { paint: () => patterns.veneer('#b98a5a', 77), tile: [1.2, 0.6], reflectance: 0.32, roughness: 0.5 }, // prettier-ignore
  'bar stone': { paint: () => patterns.marble('#d8d4cb', 78), tile: [1.2, 1.2], reflectance: 0.5, roughness: 0.4 }, // prettier-ignore
  brass: { colour: '#b08a45', reflectance: 0.3, roughness: 0.35, metallic: 0.4 },
  china: { colour: '#f3f0ea', reflectance: 0.75, roughness: 0.35 },
  linen: { colour: '#c9bda5', reflectance: 0.45 },
  'green bottle': { colour: '#2f4a2c', reflectance: 0.07, roughness: 0.2 },
  'amber bottle': { colour: '#8a4f1d', reflectance: 0.12, roughness: 0.2 },
  'clear bottle': { colour: '#aeb9b8', reflectance: 0.35, roughness: 0.2 },
};

const place = (column, row) => [0.45 + pitch * column, 0.35 + pitch * row]; // of the grid of pendants, in plan

/** Tables by kind: their middles lie below places of the grid. */
const windowTables = [place(2, 1), place(6, 1), place(10, 1)];
const roundTables = [place(6, 5), place(10, 5)];
const benchTables = [place(5, 8), place(7, 8), place(9, 8), place(11, 8)];

function windows(shape, frame) {
  return [0, 1, 2].map((i) => {
    const opening = [0.75 + 2.8 * i, 0.95, 2.95 + 2.8 * i, 2.6];
    gridFrame(shape, frame, opening, {
      material: 'dark steel', paneMaterial: 'glass', bar: 0.045, at: -0.1, pane: -0.13, columns: 2,
    }); // prettier-ignore
    return opening;
  });
}

/** Framed pictures [left, bottom, width, height, painter] of a wall; returns their openings. */
function pictures(room, frame, frames, list, start) {
  return list.map(([u, v, w, h, painter], i) => {
    const opening = [u, v, u + w, v + h];
    const material = room.defineMaterial(`painting ${start + i}`, paintings[painter](500 + start + i, w / h));
    const options = { material: 'brass', bar: 0.025, at: 0.03, pane: 0.018 };
    const [pane] = gridFrame(frames, frame, opening, options);
    const picture = new Shape();
    panel(picture, frame, material, pane, 0.018, true);
    room.place(`picture ${start + i}`, picture, { fiatlux: { surface: 'pictures' } });
    return opening;
  });
}

function shell(room) {
  const frames = wallFrames(width, depth);
  const [panelling, glazing, doors, frameShape] = [new Shape(), new Shape(), new Shape(), new Shape()];
  const openings = {
    north: windows(glazing, frames.north),
    south: [
      door(doors, frames.south, [8.05, 0, 9.0, 2.15], { material: 'walnut panelling', frameMaterial: 'walnut veneer', metal: 'brass' }), // prettier-ignore
      ...pictures(room, frames.south, frameShape, [[1.3, 1.35, 0.8, 1.0, 2], [2.7, 1.35, 0.8, 1.0, 6], [4.1, 1.35, 0.8, 1.0, 1], [5.5, 1.35, 0.8, 1.0, 5]], 1), // prettier-ignore
    ],
    west: [],
    east: pictures(room, frames.east, frameShape, [[2.4, 1.3, 2.2, 1.3, 0]], 5),
  };
  const paint = { north: 'olive plaster', south: 'olive plaster', west: 'olive plaster', east: 'terracotta plaster' }; // prettier-ignore
  for (const [name, frame] of Object.entries(frames)) {
    const shape = new Shape();
    wall(shape, panelling, frame, height, openings[name], {
      material: paint[name], skirting: 'walnut panelling', skirtingHeight: 0.95,
    }); // prettier-ignore
    room.place(`wall ${name}`, shape);
  }
  room.place('panelling', panelling, { fiatlux: { surface: 'panelling' } });
  room.place('windows', glazing, { fiatlux: { surface: 'windows' } });
  room.place('door', doors, { fiatlux: { surface: 'door' } });
  room.place('frames', frameShape, { fiatlux: { surface: 'frames' } });
  room.place('floor', slab('herringbone oak', [0, 0, width, depth], 0));
  room.place('ceiling', slab('evening ceiling', [0, 0, width, depth], height, 'down'), {
    fiatlux: { mount: true, siteSpacing: pitch, drop },
  });
}

/** Tables, what lies on them, and the chairs of each: { x, z, turn } about the table's middle. */
function tables(room) {
  const chair = diningChair('tan leather', 'walnut veneer');
  const dishes = { china: 'china', linen: 'linen', vase: 'green bottle', leaf: 'leaf' };
  const random = createRandom(12);
  const numbers = { table: 0, chair: 0 };
  const stand = ([x, z], { top, body }, laid, seats) => {
    const number = ++numbers.table;
    const at = [x, 0, z];
    room.place(`table ${number}`, top, { at });
    room.place(`table ${number} frame`, body, { at, fiatlux: { surface: 'table frames' } });
    room.place(`table ${number} setting`, laid, { at: [x, tableHeight, z], fiatlux: { surface: 'settings' } }); // prettier-ignore
    for (const seat of seats)
      room.place(`chair ${++numbers.chair}`, chair, {
        at: [x + seat.x + random.between(-0.02, 0.02), 0, z + seat.z + random.between(-0.02, 0.02)],
        turn: seat.turn + random.between(-0.12, 0.12),
        fiatlux: { surface: 'chairs' },
      });
  };

  // Guests look at the middle of the table: their places lie towards them.
  const wood = { board: 'table oak', legs: 'dark steel', tube: 0.035 };
  const four = [-0.3, 0.3].flatMap((x) => [{ x, z: 0.62, turn: Math.PI }, { x, z: -0.62, turn: 0 }]); // prettier-ignore
  const laidFour = four.map(({ x, z }) => ({ x, z: 0.24 * Math.sign(z), turn: z > 0 ? 0 : Math.PI }));
  const [long, longLaid] = [table(1.3, 0.8, tableHeight, wood), setting(laidFour, dishes, turned)];
  for (const at of windowTables) stand(at, long, longLaid, four);

  const three = [0.4, 2.5, 4.6].map((angle) => ({ angle, x: Math.sin(angle), z: Math.cos(angle) }));
  const around = (radius, facing) => three.map(({ angle, x, z }) => ({ x: radius * x, z: radius * z, turn: angle + facing })); // prettier-ignore
  const round = roundTable(0.5, tableHeight, { board: 'table oak', metal: 'dark steel' });
  const roundLaid = setting(around(0.31, 0), dishes, turned);
  for (const at of roundTables) stand(at, round, roundLaid, around(0.7, Math.PI));

  const two = [{ x: 0, z: 0.18, turn: 0 }, { x: 0, z: -0.18, turn: Math.PI }]; // prettier-ignore
  const [small, smallLaid] = [table(0.7, 0.7, tableHeight, wood), setting(two, dishes, turned)];
  for (const at of benchTables) stand(at, small, smallLaid, [{ x: 0, z: -0.56, turn: 0 }]);
}

function barAndBanquette(room) {
  const seats = banquette(6, { fabric: 'petrol velvet', wood: 'walnut veneer', seats: 6 });
  room.place('banquette', seats, { at: [6.05, 0, depth - 0.01], turn: Math.PI, fiatlux: { surface: 'banquette' } }); // prettier-ignore

  const [x, z] = place(1, 5);
  const counter = bar([3.1, 1.1, 0.62], { board: 'bar stone', wood: 'walnut veneer', metal: 'brass' });
  const turn = Math.PI / 2;
  room.place('bar', counter.top, { at: [x + 0.1, 0, z], turn });
  room.place('bar front', counter.body, { at: [x + 0.1, 0, z], turn, fiatlux: { surface: 'bar front' } });
  const shelves = backBar([3.1, 2.15, 0.26], {
    wood: 'walnut veneer',
    back: 'picture frame',
    board: 'brass',
    bottles: ['green bottle', 'amber bottle', 'clear bottle', 'green bottle'],
    random: createRandom(4),
  });
  room.place('back bar', shelves, { at: [0.01, 0, z], turn, fiatlux: { surface: 'back bar' } });
  const stool = barStool('tan leather', 'dark steel');
  [-1.05, -0.35, 0.35, 1.05].forEach((along, i) =>
    room.place(`stool ${i + 1}`, stool, { at: [x + 0.66, 0, z + along], fiatlux: { surface: 'stools' } }),
  );
  const plants = [[9.5, 0.55, 1.1], [0.5, 0.55, 1]]; // prettier-ignore
  plants.forEach(
    ([px, pz, size], i) =>
    room.place(`plant ${i + 1}`, floorPlant(120 + i, size), { at: [px, 0, pz], fiatlux: { surface: 'plants' } }), // prettier-ignore
  );
}

export function makeRoom() {
  const room = new Room('Restaurant');
  for (const [name, specification] of Object.entries(own)) room.defineMaterial(name, specification);
  shell(room);
  tables(room);
  barAndBanquette(room);
  // where the staff walk, between the tables by the windows and those in the middle
  const aisle = slab('measuring plane', [2.6, 2.25, 9.6, 2.85], 0.75);
  room.place('aisle', aisle, { fiatlux: { measure: true } });
  return room;
}

// A building for tests: two storeys of three rooms each, with inner doors, windows of glass, a stair through an opening
// of the slab, furniture; walls and slabs are solids that face outward. The rooms of the lower storey have floors of
// their own, named for them; above, the slab is the floor of all. node tests/rooms/made-building.mjs FILE writes it.
import { writeFileSync } from 'node:fs';
import { cupboard, shellChair, swivelChair, monitor, table } from '../../web/room-maker/furniture.mjs';
import { GltfRoom } from '../../web/room-maker/gltf-room.mjs';
import { plainMaterials } from '../../web/room-maker/plain-materials.mjs';
import { Shape } from '../../web/room-maker/shape.mjs';

/** Within the outer walls, m; floors at 0 and at `storey`, ceilings `clear` above them. */
export const building = { width: 12, depth: 9, clear: 2.7, storey: 3 };
const { width, depth, clear, storey } = building;
const outer = 0.3; // m, thickness of the outer walls
const inner = 0.16;
const doorTop = 2.05;

const materials = {
  ...plainMaterials,
  plaster: { colour: '#efece5', reflectance: 0.7 },
  concrete: { colour: '#b9b6b0', reflectance: 0.5 },
  oak: { colour: '#b78b5c', reflectance: 0.3 },
  tiles: { colour: '#8f979c', reflectance: 0.3 },
  cloth: { colour: '#50688c', reflectance: 0.15 },
  pane: { colour: '#dfeef5', reflectance: 0.8, alpha: 0.2 },
};

/** A wall from one point of the plan to another, along x or z, with its openings [from, to, sill, top] along it. */
function wall(room, name, [x0, z0], [x1, z1], y, openings = []) {
  const alongX = x1 - x0 > z1 - z0;
  const [start, end] = alongX ? [x0, x1] : [z0, z1];
  const shape = new Shape();
  const block = (from, to, low, high) => {
    if (to - from < 1e-9 || high - low < 1e-9) return;
    const [a, b] = alongX ? [[from, z0], [to, z1]] : [[x0, from], [x1, to]]; // prettier-ignore
    shape.box('plaster', [a[0], y + low, a[1]], [b[0], y + high, b[1]]);
  };
  let at = start;
  for (const [from, to, sill, top] of openings) {
    block(at, from, 0, clear);
    block(from, to, 0, sill);
    block(from, to, top, clear);
    at = to;
    if (sill === 0) continue;
    const middle = alongX ? (z0 + z1) / 2 : (x0 + x1) / 2;
    const corners = alongX
      ? [[from, sill, middle], [to, sill, middle], [to, top, middle], [from, top, middle]]
      : [[middle, sill, from], [middle, sill, to], [middle, top, to], [middle, top, from]]; // prettier-ignore
    const pane = new Shape().quad(
      'pane',
      corners.map(([x, v, z]) => [x, y + v, z]),
    );
    room.place(`${name} pane at ${from}`, pane);
  }
  block(at, end, 0, clear);
  room.place(name, shape);
}

/** The walls of a storey whose floor is at y: one room in the west, two in the east. */
function walls(room, name, y) {
  const [w, d] = [width, depth];
  wall(room, `${name} north`, [-outer, -outer], [w + outer, 0], y, [[2, 4, 0.9, 2.2], [8, 10, 0.9, 2.2]]); // prettier-ignore
  wall(room, `${name} south`, [-outer, d], [w + outer, d + outer], y, [[2, 4, 0.9, 2.2], [8, 10, 0.9, 2.2]]); // prettier-ignore
  wall(room, `${name} west`, [-outer, 0], [0, d], y, [[5, 7, 0.9, 2.2]]);
  wall(room, `${name} east`, [w, 0], [w + outer, d], y, [[2, 3.2, 0.9, 2.2]]);
  wall(room, `${name} between`, [6, 0], [6 + inner, d], y, [[1, 1.9, 0, doorTop], [6, 6.9, 0, doorTop]]); // prettier-ignore
  wall(room, `${name} across`, [6 + inner, 4.5], [w, 4.5 + inner], y, [[10, 10.9, 0, doorTop]]);
}

/** A level plate with its upper side at y, with the opening of the stair or without. */
function plate(room, name, y, opening) {
  const [x0, x1, z0, z1] = [-outer, width + outer, -outer, depth + outer];
  const [low, high] = [y - (storey - clear), y];
  const shape = new Shape();
  const block = (a, b, c, e) => shape.box('concrete', [a, low, c], [b, high, e]);
  if (!opening) block(x0, x1, z0, z1);
  else {
    const [a, b, c, e] = opening;
    block(x0, a, z0, z1);
    block(b, x1, z0, z1);
    block(a, b, z0, c);
    block(a, b, e, z1);
  }
  room.place(name, shape, { fiatlux: y > 0 ? { mount: true, siteSpacing: 1.5 } : null });
}

/** A floor of its own on the plate. */
function floor(room, name, [x0, z0, x1, z1], material) {
  const y = 0.005;
  room.place(name, new Shape().quad(material, [[x0, y, z1], [x1, y, z1], [x1, y, z0], [x0, y, z0]])); // prettier-ignore
}

function furnish(room, y, name) {
  const { top, body } = table(1.6, 0.8, 0.74, { board: 'oak', legs: 'dark steel' });
  for (const [i, [x, z]] of [
    [3, 2],
    [9, 2],
    [9, 7],
  ].entries()) {
    // prettier-ignore
    room.place(`${name} table top ${i}`, top, { at: [x, y, z] });
    room.place(`${name} table ${i}`, body, { at: [x, y, z] });
    room.place(`${name} screen ${i}`, monitor('screen', 'black plastic'), { at: [x, y + 0.741, z - 0.1] });
    room.place(`${name} chair ${i}`, swivelChair('cloth', 'black plastic'), { at: [x, y, z + 0.8], turn: Math.PI }); // prettier-ignore
  }
  room.place(`${name} seat`, shellChair('cloth', 'dark steel'), { at: [4.6, y, 7], turn: 0.6 });
  const front = { carcass: 'white lacquer', front: 'white lacquer', legs: 'dark steel', columns: 3 };
  room.place(`${name} cupboard`, cupboard([1.8, 1.9, 0.5], front), { at: [0.02, y, 2], turn: Math.PI / 2 });
}

/** Steps along the west wall, from the lower floor to the upper one. */
function stair(room, [x0, x1, z0, z1]) {
  const steps = 16;
  const shape = new Shape();
  for (let i = 0; i < steps; i++) {
    const [near, far] = [z1 - ((z1 - z0) * i) / steps, z1 - ((z1 - z0) * (i + 1)) / steps];
    const top = (storey * (i + 1)) / steps;
    shape.box('oak', [x0 + 0.02, Math.max(0.002, top - 0.3), far], [x1 - 0.02, top, near]);
  }
  room.place('stair', shape);
}

export function makeBuilding() {
  const room = new GltfRoom('Building', { generator: 'Fiat Lux tests', materials });
  const opening = [0.05, 1.05, 3.6, 8];
  plate(room, 'ground plate', 0, null);
  plate(room, 'slab', storey, opening);
  plate(room, 'roof', 2 * storey, null);
  for (const [name, y] of [
    ['lower', 0],
    ['upper', storey],
  ]) {
    // prettier-ignore
    walls(room, name, y);
    furnish(room, y, name);
  }
  floor(room, 'Hall floor', [0, 0, 6, depth], 'tiles');
  floor(room, 'Kitchen floor', [6 + inner, 0, width, 4.5], 'tiles');
  floor(room, 'Study floor', [6 + inner, 4.5 + inner, width, depth], 'oak');
  stair(room, opening);
  return room;
}

if (process.argv[1]?.endsWith('made-building.mjs'))
  writeFileSync(process.argv[2], await makeBuilding().bytes());

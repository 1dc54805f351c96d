// What can stand in a made room: each kind's parts as shapes around the centre of its footprint, front towards +z, feet
// on y = 0. The same kind and size gives the same shapes, so that a row of desks shares its meshes.
import { bench, bookcase, cupboard, keyboardAndMouse, monitor, roundTable, shellChair, sofa, swivelChair, table } from './furniture.mjs'; // prettier-ignore
import { floorPlant } from './plants.mjs';
import { createRandom } from './random.mjs';
import { Shape, circle, moved } from './shape.mjs';
import { rotated } from './polygon.mjs';

const gap = 0.001; // m between solids, so that no ray slips into one
const columnSegments = 24;
const board = 'oak board';
const chairOut = 0.25; // m from the edge of a workplace to the centre of its chair

/** m, of the circle on the floor around a swivel chair. */
export const chairRadius = 0.33;

/** m by which a piece reaches beyond its size [at its back, at its front]: by a chair, a leaning back, grips. */
const beyond = { workplace: [0, chairOut + chairRadius], chair: [0.05, 0], cupboard: [0, 0.02] };

/** A part: `surface` groups it with others of that name; a part without one is a surface of its own, for intentions. */
const part = (shape, surface, suffix = '') => ({ shape, surface, suffix });

const tableOf = ({ top, body }) => [part(top), part(body, 'table frames', ' frame')];

const makers = {
  desk: ([w, d, h]) => tableOf(table(w, d, h, { board, legs: 'dark steel' })),
  workplace([w, d, h]) {
    const computer = monitor('screen', 'black plastic').add(
      keyboardAndMouse('black plastic'),
      moved(0, 0, 0.26),
    );
    const onDesk = new Shape().add(computer, moved(0, h, -d / 2 + 0.2));
    const chair = new Shape().add(swivelChair('charcoal fabric', 'black plastic'), (p) => [-p[0], p[1], d / 2 + chairOut - p[2]]); // prettier-ignore
    return [
      ...makers.desk([w, d, h]),
      part(onDesk, 'computers', ' computer'),
      part(chair, 'chairs', ' chair'),
    ];
  },
  table: ([w, d, h]) => tableOf(table(w, d, h, { board, legs: 'pale steel' })),
  'round table': ([w, , h]) => tableOf(roundTable(w / 2, h, { board, metal: 'dark steel' })),
  chair: () => [part(shellChair('blue lacquer', 'pale steel'), 'chairs')],
  'office chair': () => [part(swivelChair('charcoal fabric', 'black plastic'), 'chairs')],
  cupboard([w, d, h]) {
    const columns = Math.max(1, Math.round(w / 0.5));
    const parts = { carcass: 'white lacquer', front: 'grey lacquer', legs: 'dark steel', columns };
    return [part(new Shape().add(cupboard([w, h, d], parts), moved(0, 0, -d / 2)), 'cupboards')];
  },
  bookcase([w, d, h]) {
    const colours = ['blue lacquer', 'white lacquer', 'mustard fabric', 'grey lacquer', 'charcoal fabric'];
    const shelves = Math.max(1, Math.round(h / 0.42));
    const shape = bookcase([w, h, d], { board, colours, random: createRandom(9), shelves });
    return [part(new Shape().add(shape, moved(0, 0, -d / 2)), 'bookcases')];
  },
  sofa: ([w]) => [part(sofa(w, 'blue lacquer', 'mustard fabric', 'dark steel'), 'sofas')],
  bench: ([w, d, h]) => [part(bench(w, d, h, board, 'dark steel'), 'benches')],
  partition: ([w, d, h]) => [
    part(new Shape().box('felt', [-w / 2, gap, -d / 2], [w / 2, h, d / 2]), 'partitions'),
  ],
  plant: ([, , h]) => [part(floorPlant(100, h / 1.5), 'plants')],
};

export const itemMaterials = {
  'oak board': { colour: '#d2aa78', reflectance: 0.42, roughness: 0.6 },
  'blue lacquer': { colour: '#3f6f96', reflectance: 0.15, roughness: 0.5 },
  'charcoal fabric': { colour: '#56595e', reflectance: 0.1 },
  'mustard fabric': { colour: '#c9992f', reflectance: 0.34 },
  felt: { colour: '#7d9a84', reflectance: 0.3 },
};

export const isColumn = ({ kind }) => kind.endsWith('column');

/** The parts of furniture, made once for each kind and size. */
export class ItemShapes {
  #made = new Map();

  of({ kind, size }) {
    const key = `${kind} ${size}`;
    if (!this.#made.has(key)) this.#made.set(key, makers[kind](size));
    return this.#made.get(key);
  }
}

const rectangle = (x0, z0, x1, z1) => [[x0, z0], [x1, z0], [x1, z1], [x0, z1]]; // prettier-ignore

/** From an item's own axes to the plan. */
const placed = (points, { x, z, turn }) => rotated(points, turn).map(([px, pz]) => [px + x, pz + z]);

/** Corners of an item's own size, in the sense of outlines. */
export function footprint(item) {
  const [w, d] = item.size;
  const corners = item.kind.startsWith('round')
    ? circle(w / 2, 0, columnSegments)
        .map(([cx, , cz]) => [cx, cz])
        .reverse()
    : rectangle(-w / 2, -d / 2, w / 2, d / 2);
  return placed(corners, item);
}

/** [left, back, right, front] m in an item's own axes, of all that is modelled: with a workplace's chair. */
export function reachOf({ kind, size: [w, d] }) {
  const [back, front] = beyond[kind] ?? [0, 0];
  return [-w / 2, -d / 2 - back, w / 2, d / 2 + front];
}

/** Corners of the floor that an item needs: its footprint and what reaches beyond it. */
export function floorOf(item) {
  return item.kind in beyond ? placed(rectangle(...reachOf(item)), item) : footprint(item);
}

/** Where the chair of a workplace stands; null where an item has none of its own. */
export function chairOf(item) {
  return item.kind === 'workplace' ? placed([[0, item.size[1] / 2 + chairOut]], item)[0] : null;
}

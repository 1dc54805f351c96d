// A picture gallery, 14 x 9 x 4 m: pictures on all walls, a free-standing wall, sculptures on plinths.
// The luminaires hang from the ceiling in a grid of 1 m (126 sites).
import { paintings } from './art.mjs';
import { bench } from '../web/room-maker/furniture.mjs';
import { Room } from './room.mjs';
import { beads, knot, twist } from './sculptures.mjs';
import { Shape } from '../web/room-maker/shape.mjs';
import { gridFrame, panel, panelWithHoles, slab, wall, wallFrames } from '../web/room-maker/walls.mjs';

const [width, height, depth] = [14, 4, 9];
const eyeHeight = 1.6; // m, where the middle of a picture hangs
const free = { x0: 4.4, x1: 9.6, z0: 4.4, z1: 4.72, height: 3 }; // the free-standing wall
const plinths = [
  { x: 2.6, z: 6.4, edge: 0.5, height: 1.0, sculpture: () => knot('bronze', 'dark steel', 0.5) },
  { x: 11.6, z: 6.2, edge: 0.5, height: 0.85, sculpture: () => twist('marble', 0.85) },
  { x: 11.4, z: 2.5, edge: 0.45, height: 1.05, sculpture: () => beads('red enamel', 0.75) },
];

/** Pictures by wall: the middle along the wall, width and height (m), and the painter's number. */
const hanging = {
  north: [
    { u: 1.9, size: [1.1, 1.4], painter: 0 },
    { u: 5.0, size: [1.8, 1.2], painter: 2 },
    { u: 8.6, size: [1.8, 1.2], painter: 5 },
    { u: 12.0, size: [1.3, 1.3], painter: 1 },
  ],
  west: [
    { u: 2.4, size: [1.5, 1.5], painter: 4 },
    { u: 6.4, size: [2.2, 1.5], painter: 3 },
  ],
  east: [
    { u: 2.6, size: [1.4, 1.4], painter: 6 },
    { u: 6.4, size: [1.2, 1.6], painter: 0 },
  ],
  south: [
    { u: 2.6, size: [1.6, 1.1], painter: 2 },
    { u: 11.4, size: [1.2, 1.2], painter: 5 },
  ],
  front: [{ u: (free.x1 - free.x0) / 2, size: [2.6, 1.5], painter: 1 }],
  back: [{ u: (free.x1 - free.x0) / 2, size: [2.4, 1.5], painter: 3 }],
};

/** Hangs one wall's pictures and returns their openings. */
function hang(room, frame, list, frames, counter) {
  return list.map(({ u, size: [w, h], painter }) => {
    const number = ++counter.pictures;
    const rectangle = [u - w / 2, eyeHeight - h / 2, u + w / 2, eyeHeight + h / 2];
    const material = room.defineMaterial(`painting ${number}`, paintings[painter](300 + number, w / h));
    const options = {
      material: number % 2 ? 'picture frame' : 'oak veneer',
      bar: 0.025,
      at: 0.035,
      pane: 0.02,
    };
    const [pane] = gridFrame(frames, frame, rectangle, options);
    const picture = new Shape();
    panel(picture, frame, material, pane, 0.02, true);
    room.place(`picture ${number}`, picture);
    return rectangle;
  });
}

function freeStandingWall(room, frames, counter) {
  const { x0, x1, z0, z1, height: top } = free;
  const faces = {
    front: { length: x1 - x0, point: (u, v, d) => [x0 + u, v, z1 + d] },
    back: { length: x1 - x0, point: (u, v, d) => [x1 - u, v, z0 - d] },
  };
  for (const [name, frame] of Object.entries(faces)) {
    const shape = new Shape();
    const openings = hang(room, frame, hanging[name], frames, counter);
    panelWithHoles(shape, frame, 'blue plaster', [0, 0, frame.length, top], openings);
    room.place(`free-standing wall ${name}`, shape);
  }
  const edges = new Shape().box('gallery plaster', [x0, 0, z0], [x1, top, z1], '-y -z +z');
  room.place('free-standing wall edges', edges, { fiatlux: { surface: 'free-standing wall edges' } });
}

function shell(room) {
  const frames = wallFrames(width, depth);
  const [skirting, pictureFrames, entrance] = [new Shape(), new Shape(), new Shape()];
  const paint = {
    north: 'gallery plaster',
    south: 'gallery plaster',
    west: 'teal plaster',
    east: 'gallery plaster',
  };
  const counter = { pictures: 0 };
  for (const [name, frame] of Object.entries(frames)) {
    const shape = new Shape();
    const openings = hang(room, frame, hanging[name], pictureFrames, counter);
    if (name === 'south') {
      const opening = [6.0, 0, 8.0, 2.5];
      openings.push(opening);
      const glazing = {
        material: 'dark steel',
        paneMaterial: 'glass',
        bar: 0.05,
        at: -0.06,
        pane: -0.085,
        columns: 2,
      };
      gridFrame(entrance, frame, opening, glazing);
    }
    const finish = { material: paint[name], skirting: 'dark skirting', skirtingHeight: 0.05 };
    wall(shape, skirting, frame, height, openings, finish);
    room.place(`wall ${name}`, shape);
  }
  freeStandingWall(room, pictureFrames, counter);
  room.place('picture frames', pictureFrames, { fiatlux: { surface: 'picture frames' } });
  room.place('skirting', skirting, { fiatlux: { surface: 'skirting' } });
  room.place('entrance', entrance, { fiatlux: { surface: 'entrance' } });
  room.place('ceiling', slab('smooth ceiling', [0, 0, width, depth], height, 'down'), {
    fiatlux: { mount: true, siteSpacing: 1 },
  });
}

/** The floor, open where the free-standing wall and the plinths stand on it. */
function floor(room) {
  const plan = { point: (u, v, d) => [u, d, depth - v] };
  const footprints = [[free.x0, free.z0, free.x1, free.z1]];
  for (const { x, z, edge } of plinths)
    footprints.push([x - edge / 2, z - edge / 2, x + edge / 2, z + edge / 2]);
  const holes = footprints.map(([x0, z0, x1, z1]) => [x0, depth - z1, x1, depth - z0]);
  const shape = new Shape();
  panelWithHoles(shape, plan, 'oak planks', [0, 0, width, depth], holes);
  room.place('floor', shape);
}

export function makeRoom() {
  const room = new Room('Gallery');
  shell(room);
  floor(room);
  plinths.forEach(({ x, z, edge, height: top, sculpture }, i) => {
    const block = new Shape().box(
      'white lacquer',
      [-edge / 2, 0, -edge / 2],
      [edge / 2, top, edge / 2],
      '-y',
    );
    room.place(`plinth ${i + 1}`, block, { at: [x, 0, z], fiatlux: { surface: 'plinths' } });
    const surface = `sculpture ${i + 1}`;
    room.place(surface, sculpture(), { at: [x, top, z], turn: 0.4 + i, fiatlux: { surface } });
  });
  const seat = bench(1.8, 0.45, 0.44, 'walnut veneer', 'dark steel');
  room.place('bench 1', seat, { at: [7, 0, 6.6], fiatlux: { surface: 'benches' } });
  room.place('bench 2', seat, { at: [7, 0, 2.4], fiatlux: { surface: 'benches' } });
  return room;
}

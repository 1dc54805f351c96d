// A classroom, 9 x 7.2 x 3.2 m: a whiteboard wall, twelve tables for two and the teacher's desk.
// The luminaires hang in the 0.6 m grid of the ceiling (180 sites); a working plane lies at 0.75 m.
import { paintings } from './art.mjs';
import { bookcase, cupboard, keyboardAndMouse, monitor, shellChair, swivelChair, table } from '../web/room-maker/furniture.mjs'; // prettier-ignore
import { floorPlant } from '../web/room-maker/plants.mjs';
import { createRandom } from '../web/room-maker/random.mjs';
import { Room } from './room.mjs';
import { Shape, moved } from '../web/room-maker/shape.mjs';
import { door, gridFrame, panel, panelWithHoles, slab, wall, wallFrames } from '../web/room-maker/walls.mjs';

const [width, height, depth] = [9, 3.2, 7.2];
const rim = 0.5; // m left out of the working plane along the walls
const tableHeight = 0.72;

/** Windows with blinds drawn down to different heights. */
function glaze(shape, frame) {
  const random = createRandom(21);
  return [0, 1, 2].map((i) => {
    const opening = [0.7 + 2.7 * i, 0.9, 2.9 + 2.7 * i, 2.75];
    const options = { material: 'white lacquer', bar: 0.05, at: -0.12, pane: -0.15, columns: 2 };
    for (const [u0, v0, u1, v1] of gridFrame(shape, frame, opening, options)) {
      const edge = v1 - random.between(0.45, 0.95);
      panel(shape, frame, 'glass', [u0, v0, u1, edge], -0.15);
      panel(shape, frame, 'blind', [u0, edge, u1, v1], -0.15);
    }
    return opening;
  });
}

/** A cork board with four posters. */
function pinBoard(room, frame, frameShape) {
  const opening = [2.3, 1.05, 5.1, 2.15];
  const options = { material: 'beech veneer', bar: 0.035, at: 0.025, pane: 0.012 };
  const [pane] = gridFrame(frameShape, frame, opening, options);
  const [cork, posters] = [new Shape(), new Shape()];
  const sheets = [
    [2.5, 0.59, 0.75],
    [3.2, 0.52, 0.7],
    [3.86, 0.42, 0.6],
    [4.42, 0.5, 0.7],
  ].map(([u, w, h], i) => {
    const low = 1.23 + 0.06 * (i % 2);
    const material = room.defineMaterial(`poster ${i + 1}`, paintings[[6, 2, 4, 1][i]](40 + i, w / h));
    panel(posters, frame, material, [u, low, u + w, low + h], 0.012, true);
    return [u, low, u + w, low + h];
  });
  panelWithHoles(cork, frame, 'cork', pane, sheets, 0.012);
  room.place('pin board', cork);
  room.place('posters', posters, { fiatlux: { surface: 'posters' } });
  return opening;
}

function whiteboard(room, frame, frameShape) {
  const opening = [1.6, 0.9, 5.6, 2.15];
  const options = { material: 'board frame', bar: 0.03, at: 0.03, pane: 0.018 };
  const [pane] = gridFrame(frameShape, frame, opening, options);
  const board = new Shape();
  panel(board, frame, 'white board', pane, 0.018);
  room.place('whiteboard', board);
  return opening;
}

function shell(room) {
  const frames = wallFrames(width, depth);
  const [skirting, windows, doors, frameShape] = [new Shape(), new Shape(), new Shape(), new Shape()];
  const doorParts = { material: 'blue lacquer', frameMaterial: 'white lacquer', metal: 'dark steel' };
  const openings = {
    north: glaze(windows, frames.north),
    south: [door(doors, frames.south, [6.9, 0, 7.85, 2.1], doorParts)],
    west: [whiteboard(room, frames.west, frameShape)],
    east: [pinBoard(room, frames.east, frameShape)],
  };
  const paint = {
    north: 'white plaster',
    south: 'warm plaster',
    west: 'white plaster',
    east: 'warm plaster',
  };
  for (const [name, frame] of Object.entries(frames)) {
    const shape = new Shape();
    wall(shape, skirting, frame, height, openings[name], { material: paint[name], skirting: 'grey lacquer' });
    room.place(`wall ${name}`, shape);
  }
  room.place('skirting', skirting, { fiatlux: { surface: 'skirting' } });
  room.place('windows', windows, { fiatlux: { surface: 'windows' } });
  room.place('door', doors, { fiatlux: { surface: 'door' } });
  room.place('frames', frameShape, { fiatlux: { surface: 'frames' } });
  room.place('floor', slab('linoleum', [0, 0, width, depth], 0));
  room.place('ceiling', slab('ceiling tiles 0.6', [0, 0, width, depth], height, 'down'), {
    fiatlux: { mount: true, siteSpacing: 0.6 },
  });
}

/** Four rows of three tables; everybody looks towards -x. */
function pupils(room) {
  const { top, body } = table(1.3, 0.55, tableHeight, {
    board: 'beech veneer',
    legs: 'pale steel',
    tube: 0.035,
  });
  const chair = shellChair('blue lacquer', 'pale steel');
  const random = createRandom(8);
  let number = 0;
  for (const x of [2.75, 4.15, 5.55, 6.95])
    for (const z of [1.5, 3.6, 5.7]) {
      number++;
      const turn = -Math.PI / 2;
      room.place(`table ${number}`, top, { at: [x, 0, z], turn });
      room.place(`table ${number} frame`, body, {
        at: [x, 0, z],
        turn,
        fiatlux: { surface: 'table frames' },
      });
      for (const seat of [-1, 1]) {
        const at = [x + random.between(0.4, 0.5), 0, z + seat * 0.32 + random.between(-0.04, 0.04)];
        const name = `chair ${2 * number + (seat - 1) / 2}`;
        room.place(name, chair, {
          at,
          turn: turn + random.between(-0.2, 0.2),
          fiatlux: { surface: 'chairs' },
        });
      }
    }
}

function teacherAndStorage(room) {
  const { top, body } = table(1.5, 0.7, tableHeight, { board: 'beech veneer', legs: 'dark steel' });
  const [x, z] = [1.45, 5.9];
  const turn = Math.PI / 2;
  room.place('teachers desk', top, { at: [x, 0, z], turn });
  room.place('teachers desk frame', body, { at: [x, 0, z], turn, fiatlux: { surface: 'table frames' } });
  const display = monitor('screen', 'black plastic', 0.5, 0.3).add(
    keyboardAndMouse('black plastic'),
    moved(0, 0, 0.26),
  );
  const screenAt = { at: [x + 0.12, tableHeight, z + 0.3], turn: -turn, fiatlux: { surface: 'computer' } };
  room.place('computer', display, screenAt);
  const chair = swivelChair('charcoal fabric', 'black plastic');
  room.place('teachers chair', chair, {
    at: [x - 0.72, 0, z - 0.05],
    turn: turn - 0.25,
    fiatlux: { surface: 'chairs' },
  });

  const colours = [
    'blue fabric',
    'red enamel',
    'white lacquer',
    'mustard fabric',
    'felt green',
    'teal plaster',
  ];
  const shelves = bookcase([1.4, 1.9, 0.32], { board: 'beech veneer', colours, random: createRandom(3) });
  room.place('bookcase', shelves, {
    at: [width - 0.01, 0, 1.1],
    turn: -turn,
    fiatlux: { surface: 'bookcase' },
  });
  const low = cupboard([1.3, 0.85, 0.42], {
    carcass: 'beech veneer',
    front: 'white lacquer',
    legs: 'dark steel',
  });
  for (let i = 0; i < 2; i++) {
    const at = [width - 0.01, 0, 3.05 + 1.31 * i];
    room.place(`cabinet ${i + 1}`, low, { at, turn: -turn, fiatlux: { surface: 'cabinets' } });
  }
  room.place('plant 1', floorPlant(104, 1.05), { at: [8.45, 0, 6.6], fiatlux: { surface: 'plants' } });
  room.place('plant 2', floorPlant(105, 0.95), { at: [0.5, 0, 0.5], fiatlux: { surface: 'plants' } });
}

export function makeRoom() {
  const room = new Room('Classroom');
  shell(room);
  pupils(room);
  teacherAndStorage(room);
  const plane = slab('measuring plane', [rim, rim, width - rim, depth - rim], 0.75);
  room.place('working plane', plane, { fiatlux: { measure: true, border: rim } });
  return room;
}

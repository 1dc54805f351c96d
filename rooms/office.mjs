// An open office, 12 x 7.8 x 2.8 m: twelve desks in three blocks, a meeting corner and a lounge, at dusk.
// The luminaires hang in the 0.6 m grid of the ceiling (260 sites); a working plane lies at 0.75 m.
import { paintings } from './art.mjs';
import { bookcase, cupboard, keyboardAndMouse, monitor, roundTable, shellChair, sofa, swivelChair, table } from '../web/room-maker/furniture.mjs'; // prettier-ignore
import { floorPlant } from '../web/room-maker/plants.mjs';
import { createRandom } from '../web/room-maker/random.mjs';
import { Room } from './room.mjs';
import { Shape, moved } from '../web/room-maker/shape.mjs';
import { door, gridFrame, panel, slab, wall, wallFrames } from '../web/room-maker/walls.mjs';

const [width, height, depth] = [12, 2.8, 7.8];
const rim = 0.5; // m left out of the working plane along the walls
const deskHeight = 0.73;
const deskMiddle = 2.44; // m from the windows: no point of the plane's EN 12464-1 grid between a monitor and its screen

function shell(room) {
  const frames = wallFrames(width, depth);
  const walls = Object.fromEntries(Object.keys(frames).map((name) => [name, new Shape()]));
  const [skirting, windows, doors, pictureFrames] = [new Shape(), new Shape(), new Shape(), new Shape()];

  const openings = { north: [], south: [], west: [], east: [] };
  for (let i = 0; i < 4; i++) {
    const window = [0.6 + 2.8 * i, 0.85, 3.0 + 2.8 * i, 2.45];
    openings.north.push(window);
    gridFrame(windows, frames.north, window, {
      material: 'white lacquer', paneMaterial: 'glass', bar: 0.055, at: -0.1, pane: -0.13, columns: 2,
    }); // prettier-ignore
  }
  openings.south.push(
    door(doors, frames.south, [0.9, 0, 1.85, 2.1], {
      material: 'oak door', frameMaterial: 'white lacquer', metal: 'dark steel',
    }), // prettier-ignore
  );
  const board = [2.4, 0.95, 5.0, 2.15];
  openings.west.push(board);
  const [boardPane] = gridFrame(pictureFrames, frames.west, board, { material: 'board frame', bar: 0.03, at: 0.03, pane: 0.018 }); // prettier-ignore
  const whiteboard = new Shape();
  panel(whiteboard, frames.west, 'white board', boardPane, 0.018);
  room.place('whiteboard', whiteboard);

  [[4.75, 1.1, 5.75, 2.1], [6.1, 1.1, 7.1, 2.1]].forEach((rect, i) => {
    openings.east.push(rect);
    const material = room.defineMaterial(`painting ${i + 1}`, paintings[i](70 + i, 1));
    const [pane] = gridFrame(pictureFrames, frames.east, rect, { material: 'picture frame', bar: 0.02, at: 0.03, pane: 0.018 }); // prettier-ignore
    const picture = new Shape();
    panel(picture, frames.east, material, pane, 0.018, true);
    room.place(`picture ${i + 1}`, picture);
  }); // prettier-ignore

  const paint = {
    north: 'white plaster',
    south: 'white plaster',
    west: 'white plaster',
    east: 'sage plaster',
  };
  for (const [name, frame] of Object.entries(frames)) {
    wall(walls[name], skirting, frame, height, openings[name], {
      material: paint[name],
      skirting: 'skirting',
    });
    room.place(`wall ${name}`, walls[name]);
  }
  room.place('skirting', skirting, { fiatlux: { surface: 'skirting' } });
  room.place('windows', windows, { fiatlux: { surface: 'windows' } });
  room.place('door', doors, { fiatlux: { surface: 'door' } });
  room.place('frames', pictureFrames, { fiatlux: { surface: 'frames' } });
  room.place('floor', slab('grey carpet', [0, 0, width, depth], 0));
  room.place('ceiling', slab('ceiling tiles 0.6', [0, 0, width, depth], height, 'down'), {
    fiatlux: { mount: true, siteSpacing: 0.6 },
  });
}

/** Three blocks of four desks; within a block two pairs face each other over a felt screen. */
function desks(room) {
  const [deskWidth, deskDepth] = [1.6, 0.8];
  const { top, body } = table(deskWidth, deskDepth, deskHeight, { board: 'oak veneer', legs: 'dark steel' });
  const chair = swivelChair('charcoal fabric', 'black plastic');
  const display = monitor('screen', 'black plastic').add(
    keyboardAndMouse('black plastic'),
    moved(0, 0, 0.24),
  );
  const screen = new Shape().box('felt green', [-1.58, 0.62, -0.016], [1.58, 1.14, 0.016]);
  const random = createRandom(5);
  let number = 0;
  [2.2, 5.4, 8.6].forEach((x, block) => {
    for (const side of [-1, 1])
      for (const along of [-1, 1]) {
        number++;
        const turn = (side * Math.PI) / 2;
        const at = [x + side * (deskDepth / 2 + 0.02), 0, deskMiddle + along * (deskWidth / 2 + 0.001)];
        room.place(`desk ${number}`, top, { at, turn });
        room.place(`desk ${number} frame`, body, { at, turn, fiatlux: { surface: 'desk frames' } });
        const monitorAt = [x + side * 0.26, deskHeight, at[2] + random.between(-0.08, 0.08)];
        room.place(`monitor ${number}`, display, { at: monitorAt, turn, fiatlux: { surface: 'monitors' } });
        const chairAt = [x + side * random.between(1.14, 1.3), 0, at[2] + random.between(-0.15, 0.15)];
        const away = -turn + random.between(-0.5, 0.5);
        room.place(`chair ${number}`, chair, { at: chairAt, turn: away, fiatlux: { surface: 'chairs' } });
      }
    const at = [x, 0, deskMiddle];
    room.place(`screen ${block + 1}`, screen, { at, turn: Math.PI / 2, fiatlux: { surface: 'screens' } });
  });
}

function meetingCorner(room) {
  const { top, body } = roundTable(0.6, deskHeight, { board: 'white lacquer', metal: 'dark steel' });
  const chair = shellChair('beech veneer', 'dark steel');
  const [x, z] = [10, 5.8];
  room.place('meeting table', top, { at: [x, 0, z] });
  room.place('meeting table frame', body, { at: [x, 0, z], fiatlux: { surface: 'desk frames' } });
  for (let i = 0; i < 4; i++) {
    const angle = 0.6 + (Math.PI / 2) * i;
    const at = [x + 0.78 * Math.sin(angle), 0, z + 0.78 * Math.cos(angle)];
    room.place(`meeting chair ${i + 1}`, chair, {
      at,
      turn: angle + Math.PI,
      fiatlux: { surface: 'chairs' },
    });
  }
}

function storageAndLounge(room) {
  const low = cupboard([1.2, 0.9, 0.42], {
    carcass: 'white lacquer',
    front: 'grey lacquer',
    legs: 'dark steel',
  });
  for (let i = 0; i < 3; i++) {
    const at = [4.6 + 1.21 * i, 0, depth - 0.01];
    room.place(`cabinet ${i + 1}`, low, { at, turn: Math.PI, fiatlux: { surface: 'cabinets' } });
  }
  const colours = [
    'blue fabric',
    'clay plaster',
    'white lacquer',
    'mustard fabric',
    'teal plaster',
    'charcoal fabric',
  ];
  const shelves = bookcase([1.2, 1.9, 0.32], { board: 'oak veneer', colours, random: createRandom(9) });
  room.place('bookcase', shelves, {
    at: [8.45, 0, depth - 0.01],
    turn: Math.PI,
    fiatlux: { surface: 'bookcase' },
  });
  const couch = sofa(1.9, 'blue fabric', 'mustard fabric', 'dark steel');
  room.place('sofa', couch, { at: [0.52, 0, 6.1], turn: Math.PI / 2, fiatlux: { surface: 'sofa' } });
  const coffee = roundTable(0.4, 0.4, { board: 'oak veneer', metal: 'dark steel' });
  room.place('coffee table', coffee.top, { at: [1.75, 0, 6.1] });
  room.place('coffee table frame', coffee.body, { at: [1.75, 0, 6.1], fiatlux: { surface: 'desk frames' } });
  const plants = [[0.45, 0.5, 1], [11.5, 0.55, 1.1], [3.7, 7.35, 1]]; // prettier-ignore
  plants.forEach(([x, z, size], i) => {
    const at = [x, 0, z];
    room.place(`plant ${i + 1}`, floorPlant(100 + i, size), { at, fiatlux: { surface: 'plants' } });
  });
}

export function makeRoom() {
  const room = new Room('Open office');
  shell(room);
  desks(room);
  meetingCorner(room);
  storageAndLounge(room);
  const plane = slab('measuring plane', [rim, rim, width - rim, depth - rim], 0.75);
  room.place('working plane', plane, { fiatlux: { measure: true, border: rim } });
  return room;
}

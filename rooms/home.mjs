// A living room at home, 7.2 x 5.4 x 2.6 m, in the evening: a corner to read in, a sofa, a table to eat at.
// The luminaires hang in a grid of 0.6 m (108 sites); where a book is held, a measuring plane lies at 0.75 m.
import { paintings } from './art.mjs';
import { bookcase, cupboard, roundTable, shellChair, sofa, table } from '../web/room-maker/furniture.mjs';
import { armchair, bowl, curtain, footstool, pile, rug, vase } from './home-furniture.mjs';
import { linearFromHex } from '../web/document/linear-colour.mjs';
import { floorPlant } from '../web/room-maker/plants.mjs';
import { createRandom } from '../web/room-maker/random.mjs';
import * as patterns from './patterns.mjs';
import { Room } from './room.mjs';
import { Shape, moved } from '../web/room-maker/shape.mjs';
import { paintPicture, shade } from './texture.mjs';
import { door, gridFrame, panel, slab, wall, wallFrames } from '../web/room-maker/walls.mjs';

const [width, height, depth] = [7.2, 2.6, 5.4];
const reader = { x: 6.1, z: 1.35, turn: -0.85 }; // the armchair, seen from which the room lies ahead

/** Bands of two tones across a rug, woven. */
function bands(hex, other, seed) {
  const [ground, band] = [linearFromHex(hex), linearFromHex(other)];
  const cloth = patterns.weave('#ffffff', seed);
  return paintPicture(192, 192, (u, v) => {
    const edge = Math.min(v, 1 - v);
    const inBand = edge < 0.05 || (edge > 0.1 && edge < 0.12) || Math.abs(v - 0.5) < 0.09;
    const at = 3 * ((Math.floor(v * 192) % 96) * 96 + (Math.floor(u * 192) % 96));
    return shade(inBand ? band : ground, 0.55 + 0.45 * cloth.pixels[at]);
  });
}

const own = {
  'dove plaster': { paint: () => patterns.plaster('#d8d2c6', 91), tile: [3, 3], reflectance: 0.55 },
  'forest plaster': { paint: () => patterns.plaster('#5e7263', 92), tile: [3, 3], reflectance: 0.2 },
  'home ceiling': { paint: () => patterns.plaster('#f3efe7', 93), tile: [3, 3], reflectance: 0.75 },
  'home oak': { paint: () => patterns.planks('#b98f60', 94), tile: [2.4, 1.28], reflectance: 0.28 },
  'rust fabric': { paint: () => patterns.weave('#b0603a', 95), tile: [0.2, 0.2], reflectance: 0.2 },
  'sand fabric': { paint: () => patterns.weave('#b9a98e', 96), tile: [0.2, 0.2], reflectance: 0.38 },
  curtain: { paint: () => patterns.weave('#d9cdb8', 97), tile: [0.15, 0.15], reflectance: 0.5 },
  'banded rug': { paint: () => bands('#c8b79a', '#8a4a33', 98), tile: [2.6, 1.8], reflectance: 0.3 },
  'reading rug': { paint: () => bands('#4f6a70', '#d9cdb8', 99), tile: [1.7, 1.7], reflectance: 0.16 },
  stoneware: { colour: '#cfc6b6', reflectance: 0.5, roughness: 0.6 },
};

/** A framed picture; returns its opening. */
function framed(room, frame, frames, number, [u, v, w, h], painter) {
  const opening = [u, v, u + w, v + h];
  const material = room.defineMaterial(`painting ${number}`, paintings[painter](700 + number, w / h));
  const options = { material: number % 2 ? 'oak veneer' : 'picture frame', bar: 0.025, at: 0.03, pane: 0.018 }; // prettier-ignore
  const [pane] = gridFrame(frames, frame, opening, options);
  const picture = new Shape();
  panel(picture, frame, material, pane, 0.018, true);
  room.place(`picture ${number}`, picture);
  return opening;
}

function shell(room) {
  const frames = wallFrames(width, depth);
  const [skirting, windows, doors, frameShape] = [new Shape(), new Shape(), new Shape(), new Shape()];
  const openings = { north: [], south: [], west: [], east: [] };
  const glazing = [1.3, 0.35, 4.5, 2.3];
  openings.north.push(glazing);
  gridFrame(windows, frames.north, glazing, {
    material: 'white lacquer', paneMaterial: 'glass', bar: 0.055, at: -0.1, pane: -0.13, columns: 3,
  }); // prettier-ignore
  const leaf = { material: 'oak door', frameMaterial: 'white lacquer', metal: 'dark steel' };
  openings.south.push(door(doors, frames.south, [5.7, 0, 6.6, 2.1], leaf));
  openings.west.push(framed(room, frames.west, frameShape, 1, [1.35, 1.15, 1.7, 1.1], 2));
  openings.south.push(framed(room, frames.south, frameShape, 2, [1.15, 1.15, 0.8, 1], 1));
  openings.south.push(framed(room, frames.south, frameShape, 3, [2.1, 1.15, 0.8, 1], 6));
  const paint = { north: 'dove plaster', south: 'dove plaster', west: 'dove plaster', east: 'forest plaster' }; // prettier-ignore
  for (const [name, frame] of Object.entries(frames)) {
    const shape = new Shape();
    wall(shape, skirting, frame, height, openings[name], { material: paint[name], skirting: 'skirting' });
    room.place(`wall ${name}`, shape);
  }
  room.place('skirting', skirting, { fiatlux: { surface: 'skirting' } });
  room.place('window', windows, { fiatlux: { surface: 'window' } });
  room.place('door', doors, { fiatlux: { surface: 'door' } });
  room.place('frames', frameShape, { fiatlux: { surface: 'frames' } });
  const drape = curtain('curtain', 0.6, 2.5);
  [0.95, 4.85].forEach((x, i) =>
    room.place(`curtain ${i + 1}`, drape, { at: [x, 0, 0.03], fiatlux: { surface: 'curtains' } }),
  );
  room.place('floor', slab('home oak', [0, 0, width, depth], 0));
  room.place('ceiling', slab('home ceiling', [0, 0, width, depth], height, 'down'), {
    fiatlux: { mount: true, siteSpacing: 0.6 },
  });
}

const spines = ['blue fabric', 'clay plaster', 'white lacquer', 'mustard fabric', 'teal plaster', 'red enamel']; // prettier-ignore

/** An armchair by the window and the books, a small table at its side. */
function readingCorner(room) {
  const { x, z, turn } = reader;
  const [s, c] = [Math.sin(turn), Math.cos(turn)];
  /** A point of the corner: `right` and `ahead` of who sits there, m. */
  const from = (right, ahead, y = 0) => [x + c * right + s * ahead, y, z - s * right + c * ahead];
  room.place('reading rug', rug('reading rug', 1.7, 1.7), { at: from(0, 0.35), turn, fiatlux: { surface: 'rugs' } }); // prettier-ignore
  const chair = armchair('rust fabric', 'mustard fabric', 'oak veneer');
  room.place('armchair', chair, { at: from(0, 0, 0.014), turn, fiatlux: { surface: 'armchair' } });
  const stool = footstool('rust fabric', 'oak veneer');
  room.place('footstool', stool, { at: from(0.05, 0.9, 0.014), turn: turn + 0.15, fiatlux: { surface: 'armchair' } }); // prettier-ignore

  const side = roundTable(0.24, 0.52, { board: 'walnut veneer', metal: 'dark steel' });
  const [tx, , tz] = from(-0.78, 0.1);
  room.place('side table', side.top, { at: [tx, 0.014, tz] });
  room.place('side table frame', side.body, { at: [tx, 0.014, tz], fiatlux: { surface: 'table frames' } });
  const books = pile(['blue fabric', 'white lacquer', 'red enamel'], createRandom(6));
  room.place('books', books, { at: [tx - 0.03, 0.534, tz + 0.02], turn: 0.5, fiatlux: { surface: 'books' } });

  const shelves = bookcase([1.2, 2, 0.3], { board: 'oak veneer', colours: spines, random: createRandom(21) });
  room.place('bookcase', shelves, { at: [width - 0.01, 0, 3.05], turn: -Math.PI / 2, fiatlux: { surface: 'bookcase' } }); // prettier-ignore
  room.place('plant 1', floorPlant(131, 1.05), { at: [6.7, 0, 0.5], fiatlux: { surface: 'plants' } });
  const page = slab('measuring plane', [-0.25, -0.2, 0.25, 0.2], 0.75);
  room.place('reading place', page, { at: from(0, 0.25), turn, fiatlux: { measure: true } });
}

function sofaAndTable(room) {
  const couch = sofa(2.3, 'sand fabric', 'rust fabric', 'oak veneer');
  room.place('sofa', couch, { at: [0.52, 0, 3.15], turn: Math.PI / 2, fiatlux: { surface: 'sofa' } });
  room.place('rug', rug('banded rug', 2.6, 1.8), { at: [2.3, 0, 3.15], turn: Math.PI / 2, fiatlux: { surface: 'rugs' } }); // prettier-ignore
  const coffee = roundTable(0.45, 0.38, { board: 'walnut veneer', metal: 'dark steel' });
  room.place('coffee table', coffee.top, { at: [1.95, 0.014, 3.15] });
  room.place('coffee table frame', coffee.body, { at: [1.95, 0.014, 3.15], fiatlux: { surface: 'table frames' } }); // prettier-ignore
  const things = new Shape().add(pile(['mustard fabric', 'charcoal fabric'], createRandom(8)), moved(-0.15, 0, 0.1)).add(vase('stoneware', 0.7), moved(0.14, 0, -0.08)); // prettier-ignore
  room.place('things', things, { at: [1.95, 0.394, 3.15], fiatlux: { surface: 'things' } });
  room.place('plant 2', floorPlant(132, 0.95), { at: [0.45, 0, 0.55], fiatlux: { surface: 'plants' } });

  const low = cupboard([1.6, 0.72, 0.4], { carcass: 'walnut veneer', front: 'walnut veneer', legs: 'dark steel', columns: 3 }); // prettier-ignore
  room.place('sideboard', low, { at: [5.1, 0, depth - 0.01], turn: Math.PI, fiatlux: { surface: 'sideboard' } }); // prettier-ignore
  const still = new Shape().add(vase('blue lacquer', 1.1), moved(-0.5, 0, 0)).add(pile(['teal plaster', 'white lacquer', 'clay plaster'], createRandom(9)), moved(0.4, 0, 0)); // prettier-ignore
  room.place('still life', still, { at: [5.1, 0.72, depth - 0.22], turn: Math.PI, fiatlux: { surface: 'things' } }); // prettier-ignore
}

function diningTable(room) {
  const [x, z] = [4.65, 3.75];
  const { top, body } = table(1.5, 0.85, 0.74, { board: 'oak veneer', legs: 'dark steel' });
  room.place('dining table', top, { at: [x, 0, z] });
  room.place('dining table frame', body, { at: [x, 0, z], fiatlux: { surface: 'table frames' } });
  const fruit = bowl('stoneware');
  room.place('bowl', fruit, { at: [x, 0.74, z], fiatlux: { surface: 'things' } });
  const chair = shellChair('beech veneer', 'dark steel');
  const random = createRandom(15);
  let number = 0;
  for (const side of [-0.35, 0.35])
    for (const end of [-1, 1])
      room.place(`chair ${++number}`, chair, {
        at: [x + side, 0, z + end * random.between(0.62, 0.66)],
        turn: (end > 0 ? Math.PI : 0) + random.between(-0.15, 0.15),
        fiatlux: { surface: 'chairs' },
      });
}

export function makeRoom() {
  const room = new Room('Home');
  for (const [name, specification] of Object.entries(own)) room.defineMaterial(name, specification);
  shell(room);
  readingCorner(room);
  sofaAndTable(room);
  diningTable(room);
  return room;
}

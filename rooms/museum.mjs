// A cabinet of works on paper, 12 x 8 x 3.8 m: eight framed sheets that may have 50 lx, bronzes that may have more.
// The luminaires are spots on the ceiling in a grid of 1 m (96 sites), 1.5 m and more before the pictures they aim at.
import { paintings } from './art.mjs';
import { bench } from '../web/room-maker/furniture.mjs';
import * as patterns from './patterns.mjs';
import { Room } from './room.mjs';
import { beads, knot } from './sculptures.mjs';
import { paintPicture } from './texture.mjs';
import { linearFromHex } from '../web/document/linear-colour.mjs';
import { Shape } from '../web/room-maker/shape.mjs';
import { gridFrame, panel, panelWithHoles, slab, wall, wallFrames } from '../web/room-maker/walls.mjs';

const [width, height, depth] = [12, 3.8, 8];
const eyeHeight = 1.55; // m, where the middle of a picture hangs
const plinths = [
  { x: 3.5, z: 4, edge: 0.5, height: 0.95, sculpture: () => beads('bronze', 0.8) },
  { x: 8.5, z: 4, edge: 0.5, height: 1.0, sculpture: () => knot('bronze', 'dark steel', 0.46) },
];

const own = {
  'museum blue': { paint: () => patterns.plaster('#3d4f63', 81), tile: [3, 3], reflectance: 0.11 },
  'museum red': { paint: () => patterns.plaster('#7a3630', 82), tile: [3, 3], reflectance: 0.1 },
  'museum ceiling': { paint: () => patterns.plaster('#8d8d8b', 83), tile: [3, 3], reflectance: 0.3 },
  'fumed oak': { paint: () => patterns.planks('#9a7650', 84), tile: [2.4, 1.28], reflectance: 0.2 },
  gilt: { colour: '#b58f47', reflectance: 0.3, roughness: 0.4, metallic: 0.3 },
  'museum skirting': { colour: '#2c333c', reflectance: 0.05 },
};

/** Sheets by wall: the middle along the wall, width and height of the frame (m), and the painter's number. */
const hanging = {
  north: [
    { u: 2.5, size: [0.95, 1.2], painter: 2 },
    { u: 6, size: [1.5, 1.1], painter: 5 },
    { u: 9.5, size: [0.95, 1.2], painter: 1 },
  ],
  west: [
    { u: 2.5, size: [1.2, 0.95], painter: 2 },
    { u: 5.5, size: [0.95, 1.2], painter: 0 },
  ],
  east: [
    { u: 2.5, size: [0.95, 1.2], painter: 5 },
    { u: 5.5, size: [1.2, 0.95], painter: 6 },
  ],
  south: [{ u: 9.5, size: [1.2, 0.95], painter: 3 }],
};

const paper = linearFromHex('#e9e3d4');
const cut = linearFromHex('#f6f3ea');

/** A sheet in a mount of card: `margin` m on all sides of a frame of w x h m. */
function mounted({ paint, roughness }, [w, h], margin) {
  const whole = () => {
    const sheet = paint();
    const scale = sheet.width / (w - 2 * margin);
    return paintPicture(Math.round(w * scale), Math.round(h * scale), (u, v) => {
      const [x, y] = [(u * w - margin) / (w - 2 * margin), (v * h - margin) / (h - 2 * margin)];
      if (x >= 0 && y >= 0 && x < 1 && y < 1) {
        const at = 3 * (Math.floor(y * sheet.height) * sheet.width + Math.floor(x * sheet.width));
        return [...sheet.pixels.subarray(at, at + 3)];
      }
      const off = Math.max(-x * (w - 2 * margin), (x - 1) * (w - 2 * margin), -y * (h - 2 * margin), (y - 1) * (h - 2 * margin)); // prettier-ignore
      return off < 0.008 ? cut : paper;
    });
  };
  return { paint: whole, roughness };
}

/** Hangs one wall's sheets and returns their openings. */
function hang(room, frame, list, frames, counter) {
  return list.map(({ u, size: [w, h], painter }) => {
    const number = ++counter.pictures;
    const rectangle = [u - w / 2, eyeHeight - h / 2, u + w / 2, eyeHeight + h / 2];
    const [bar, margin] = [0.03, 0.13];
    const sheet = [w - 2 * bar, h - 2 * bar];
    const aspect = (sheet[0] - 2 * margin) / (sheet[1] - 2 * margin);
    const specification = mounted(paintings[painter](620 + number, aspect), sheet, margin);
    const material = room.defineMaterial(`sheet ${number}`, specification);
    const options = { material: 'gilt', bar, at: 0.035, pane: 0.02 };
    const [pane] = gridFrame(frames, frame, rectangle, options);
    const picture = new Shape();
    panel(picture, frame, material, pane, 0.02, true);
    room.place(`picture ${number}`, picture);
    return rectangle;
  });
}

function shell(room) {
  const frames = wallFrames(width, depth);
  const [skirting, pictureFrames, entrance] = [new Shape(), new Shape(), new Shape()];
  const paint = { north: 'museum red', south: 'museum blue', west: 'museum blue', east: 'museum blue' };
  const counter = { pictures: 0 };
  for (const [name, frame] of Object.entries(frames)) {
    const shape = new Shape();
    const openings = hang(room, frame, hanging[name], pictureFrames, counter);
    if (name === 'south') {
      const opening = [4.9, 0, 7.1, 2.6];
      openings.push(opening);
      const glazing = { material: 'dark steel', paneMaterial: 'glass', bar: 0.05, at: -0.06, pane: -0.085, columns: 2 }; // prettier-ignore
      gridFrame(entrance, frame, opening, glazing);
    }
    const finish = { material: paint[name], skirting: 'museum skirting', skirtingHeight: 0.16 };
    wall(shape, skirting, frame, height, openings, finish);
    room.place(`wall ${name}`, shape);
  }
  room.place('picture frames', pictureFrames, { fiatlux: { surface: 'picture frames' } });
  room.place('skirting', skirting, { fiatlux: { surface: 'skirting' } });
  room.place('entrance', entrance, { fiatlux: { surface: 'entrance' } });
  room.place('ceiling', slab('museum ceiling', [0, 0, width, depth], height, 'down'), {
    fiatlux: { mount: true, siteSpacing: 1 },
  });
}

/** The floor, open where the plinths stand on it. */
function floor(room) {
  const plan = { point: (u, v, d) => [u, d, depth - v] };
  const holes = plinths.map(({ x, z, edge }) => [x - edge / 2, depth - z - edge / 2, x + edge / 2, depth - z + edge / 2]); // prettier-ignore
  const shape = new Shape();
  panelWithHoles(shape, plan, 'fumed oak', [0, 0, width, depth], holes);
  room.place('floor', shape);
}

export function makeRoom() {
  const room = new Room('Museum');
  for (const [name, specification] of Object.entries(own)) room.defineMaterial(name, specification);
  shell(room);
  floor(room);
  plinths.forEach(({ x, z, edge, height: top, sculpture }, i) => {
    const half = edge / 2;
    const block = new Shape().box('white lacquer', [-half, 0, -half], [half, top, half], '-y');
    room.place(`plinth ${i + 1}`, block, { at: [x, 0, z], fiatlux: { surface: 'plinths' } });
    const surface = `sculpture ${i + 1}`;
    room.place(surface, sculpture(), { at: [x, top, z], turn: 0.4 + i, fiatlux: { surface } });
  });
  const seat = bench(1.8, 0.45, 0.44, 'walnut veneer', 'dark steel');
  room.place('bench 1', seat, { at: [6, 0, 3.2], fiatlux: { surface: 'benches' } });
  room.place('bench 2', seat, { at: [6, 0, 5.2], fiatlux: { surface: 'benches' } });
  return room;
}

// A warehouse, 60 x 40 x 10 m: eight rows of racks four storeys high, aisles of 3.2 m between them and a free end before
// the gates. The luminaires hang in a grid of 2 m under the ceiling (600 sites). No room of the gallery: it is made
// where somebody asks for it (docs/halls.md).
import { createRandom } from '../web/room-maker/random.mjs';
import { Shape } from '../web/room-maker/shape.mjs';
import { door, slab, wall, wallFrames } from '../web/room-maker/walls.mjs';
import { Room } from './room.mjs';

const [width, height, depth] = [60, 10, 40];
const racks = { from: 3, to: 48, depth: 1.2, pitch: 4.4, first: 3.6, count: 8 }; // along x; m
const storeys = { count: 4, height: 1.75, beam: 0.12 };
const bay = 5.625; // m: eight of them
const pallets = ['beech veneer', 'cork', 'white lacquer', 'blue lacquer'];

function shell(room) {
  const frames = wallFrames(width, depth);
  const [skirting, gates] = [new Shape(), new Shape()];
  const parts = { material: 'blue lacquer', frameMaterial: 'white lacquer', metal: 'dark steel' };
  const openings = { east: [6, 16, 26].map((u) => door(gates, frames.east, [u, 0, u + 4, 4.2], parts)) };
  for (const [name, frame] of Object.entries(frames)) {
    const shape = new Shape();
    const options = { material: 'grey plaster', skirting: 'dark skirting' };
    wall(shape, skirting, frame, height, openings[name] ?? [], options);
    room.place(`wall ${name}`, shape);
  }
  room.place('skirting', skirting, { fiatlux: { surface: 'skirting' } });
  room.place('gates', gates, { fiatlux: { surface: 'gates' } });
  room.place('floor', slab('stone tiles', [0, 0, width, depth], 0));
  room.place('ceiling', slab('white plaster', [0, 0, width, depth], height, 'down'), {
    fiatlux: { mount: true, siteSpacing: 2 },
  });
}

/** Posts between the bays, and on every storey a beam with what lies on it. Nothing touches anything else. */
function rack(random) {
  const [frame, goods] = [new Shape(), new Shape()];
  const bays = Math.round((racks.to - racks.from) / bay);
  const top = storeys.count * storeys.height;
  for (let i = 0; i <= bays; i++)
    for (const z of [-0.62, 0.52])
      frame.box('dark steel', [i * bay - 0.05, 0.001, z], [i * bay + 0.05, top, z + 0.1]);
  for (let storey = 0; storey < storeys.count; storey++) {
    const y = storey * storeys.height + 0.15;
    frame.box('red enamel', [0.06, y, -0.5], [bays * bay - 0.06, y + storeys.beam, 0.5]);
    for (let i = 0; i < bays; i++) {
      if (random.between(0, 1) < 0.12) continue; // an empty place
      const [low, high] = [y + storeys.beam + 0.01, y + storeys.beam + random.between(0.7, 1.35)];
      const material = pallets[Math.min(pallets.length - 1, Math.floor(random.between(0, pallets.length)))];
      goods.box(material, [i * bay + 0.2, low, -0.46], [(i + 1) * bay - 0.2, high, 0.46]);
    }
  }
  return { frame, goods };
}

export function makeRoom() {
  const room = new Room('Hall');
  shell(room);
  const random = createRandom(33);
  for (let i = 0; i < racks.count; i++) {
    const { frame, goods } = rack(random);
    const at = [racks.from, 0, racks.first + racks.depth / 2 + i * racks.pitch];
    room.place(`rack ${i + 1} frame`, frame, { at, fiatlux: { surface: 'rack frames' } });
    room.place(`rack ${i + 1} goods`, goods, { at, fiatlux: { surface: `goods ${i + 1}` } });
  }
  // What is to be read while walking: the aisles, without what lies under the racks.
  for (let i = 0; i + 1 < racks.count; i++) {
    const from = racks.first + racks.depth + i * racks.pitch + 0.1;
    const area = [racks.from, from, racks.to, from + racks.pitch - racks.depth - 0.2];
    const extras = { fiatlux: { surface: 'aisles', measure: true } };
    room.place(`aisle ${i + 1}`, slab('stone tiles', area, 0.75), extras);
  }
  return room;
}

// A box of 4 x 4 x 4 m with a red and a green wall and two blocks, for a first look at interreflected light.
// The luminaires hang from the ceiling in a grid of 0.4 m (100 sites).
import { Room } from './room.mjs';
import { Shape } from '../web/room-maker/shape.mjs';
import { panel, slab, wallFrames } from '../web/room-maker/walls.mjs';

const edge = 4; // m

export function makeRoom() {
  const room = new Room('Box');
  const paint = {
    north: 'white plaster',
    south: 'white plaster',
    west: 'red plaster',
    east: 'green plaster',
  };
  for (const [name, frame] of Object.entries(wallFrames(edge, edge))) {
    const shape = new Shape();
    panel(shape, frame, paint[name], [0, 0, edge, edge]);
    room.place(`wall ${name}`, shape);
  }
  room.place('floor', slab('box floor', [0, 0, edge, edge], 0));
  room.place('ceiling', slab('smooth ceiling', [0, 0, edge, edge], edge, 'down'), {
    fiatlux: { mount: true, siteSpacing: 0.4 },
  });

  const block = (side, height) =>
    new Shape().box('white plaster', [-side / 2, 0.001, -side / 2], [side / 2, height, side / 2]);
  const named = (surface) => ({ fiatlux: { surface } });
  room.place('tall block', block(1.2, 2.4), { at: [1.35, 0, 1.4], turn: 0.29, ...named('tall block') });
  room.place('low block', block(1.2, 1.2), { at: [2.7, 0, 2.65], turn: -0.29, ...named('low block') });
  return room;
}

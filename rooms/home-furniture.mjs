// What only a home has: an armchair with its footstool, curtains, a rug, books that lie about. Closed solids a millimetre
// apart, as in furniture.mjs: around the origin, front towards +z, feet on y = 0.
import { Shape, chain, leaned, moved } from '../web/room-maker/shape.mjs';

const gap = 0.001; // m

function legs(shape, wood, x, z, top) {
  for (const side of [-x, x])
    for (const end of [-z, z]) shape.rod(wood, [side, gap, end], [side, top, end], 0.018);
}

/** A deep chair with a high back. */
export function armchair(fabric, accent, wood) {
  const shape = new Shape();
  legs(shape, wood, 0.3, 0.3, 0.149);
  shape.cushion(fabric, [0.8, 0.14, 0.8], 0.15, 0.07, 0.02);
  const arm = new Shape().cushion(fabric, [0.13, 0.29, 0.78], 0.291, 0.06, 0.03);
  for (const side of [-1, 1]) shape.add(arm, moved(side * 0.33, 0, 0));
  shape.add(new Shape().cushion(fabric, [0.524, 0.15, 0.6], 0.291, 0.06, 0.035), moved(0, 0, 0.09));
  shape.add(new Shape().cushion(fabric, [0.524, 0.68, 0.16], 0.291, 0.06, 0.05), moved(0, 0, -0.3));
  const pillow = new Shape().cushion(accent, [0.4, 0.1, 0.36], 0, 0.08, 0.045);
  return shape.add(pillow, chain(leaned(Math.PI / 2 - 0.25), moved(0, 0.64, -0.13)));
}

export function footstool(fabric, wood) {
  const shape = new Shape();
  legs(shape, wood, 0.2, 0.14, 0.199);
  return shape.cushion(fabric, [0.55, 0.19, 0.42], 0.2, 0.07, 0.035);
}

/** A curtain in pleats, `width` m wide as it hangs; its back on z = 0. */
export function curtain(fabric, width, height) {
  const pleats = Math.max(2, Math.round(width / 0.13));
  const each = width / pleats;
  const shape = new Shape();
  for (let i = 0; i < pleats; i++) {
    const depth = i % 2 ? 0.07 : 0.1;
    const pleat = new Shape().cushion(fabric, [each - gap, height - 0.03, depth], 0.02, 0.034, 0.004, 1);
    shape.add(pleat, moved(-width / 2 + (i + 0.5) * each, 0, depth / 2 + gap));
  }
  return shape;
}

/** Books that lie on one another. */
export function pile(colours, random) {
  const shape = new Shape();
  let y = gap;
  for (const colour of colours) {
    const [w, h, d] = [random.between(0.17, 0.24), random.between(0.018, 0.04), random.between(0.13, 0.17)];
    const [x, z] = [random.between(-0.015, 0.015), random.between(-0.015, 0.015)];
    shape.box(colour, [x - w / 2, y, z - d / 2], [x + w / 2, y + h, z + d / 2]);
    y += h + gap;
  }
  return shape;
}

export const rug = (material, width, depth) =>
  new Shape().cushion(material, [width, 0.012, depth], gap, 0.02, 0.003, 1);

export const bowl = (material) =>
  new Shape().lathe(material, [[0.06, gap], [0.07, 0.012], [0.15, 0.075], [0.155, 0.085]], 20); // prettier-ignore

export const vase = (material, size = 1) =>
  new Shape().lathe(material, [[0.05, gap], [0.09, 0.1], [0.095, 0.15], [0.04, 0.25], [0.045, 0.28]].map(([r, y]) => [r * size, y * size]), 16); // prettier-ignore

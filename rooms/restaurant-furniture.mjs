// What only a restaurant has: a banquette, bar, stools and bottles, and what lies on the tables. Closed solids a millimetre
// apart, as in furniture.mjs: around the origin, front towards +z, feet on y = 0.
import { Shape, moved } from '../web/room-maker/shape.mjs';

const gap = 0.001; // m

/** A bench with upholstered seats and a back of upright channels; its back on z = 0. */
export function banquette(width, { fabric, wood, seats = 4, channel = 0.43 }) {
  const [half, depth] = [width / 2, 0.68];
  const shape = new Shape().box(wood, [-half, gap, 0], [half, 0.3, depth - 0.08]);
  const each = width / seats;
  for (let i = 0; i < seats; i++) {
    const seat = new Shape().cushion(fabric, [each - gap, 0.15, depth - 0.15], 0.301, 0.03, 0.03, 1);
    shape.add(seat, moved(-half + (i + 0.5) * each, 0, 0.15 + (depth - 0.15) / 2));
  }
  const channels = Math.round(width / channel);
  const pad = new Shape().cushion(fabric, [width / channels - gap, 0.62, 0.13], 0.301, 0.055, 0.03, 1);
  for (let i = 0; i < channels; i++) shape.add(pad, moved(-half + ((i + 0.5) * width) / channels, 0, 0.066));
  return shape;
}

/** A chair of square timber with a round-cornered seat and a board to lean on. */
export function diningChair(fabric, wood) {
  const [half, t, seatHeight] = [0.2, 0.034, 0.43];
  const shape = new Shape();
  for (const side of [-1, 1]) {
    const [x0, x1] = side > 0 ? [half - t, half] : [-half, -half + t];
    shape.box(wood, [x0, gap, half - t], [x1, seatHeight - gap, half]);
    shape.box(wood, [x0, gap, -half - t], [x1, 0.85, -half]);
  }
  const seat = new Shape().cushion(
    fabric,
    [2 * half + 0.02, 0.05, 2 * half - 0.01],
    seatHeight,
    0.05,
    0.015,
    1,
  );
  shape.add(seat, moved(0, 0, 0.006));
  const board = new Shape().box(wood, [-half + t + gap, 0.62, -half - t + 0.008], [half - t - gap, 0.82, -half - 0.008]); // prettier-ignore
  return shape.add(board);
}

/** A stool for a bar of 1.1 m. */
export function barStool(leather, metal) {
  const foot = [[0.2, gap], [0.2, 0.012], [0.035, 0.032], [0.024, 0.06], [0.024, 0.69], [0.1, 0.699]]; // prettier-ignore
  const seat = [[0.15, 0.7], [0.185, 0.72], [0.185, 0.752], [0.16, 0.77]]; // prettier-ignore
  const shape = new Shape().lathe(metal, foot, 14).lathe(leather, seat, 18);
  const rest = Array.from({ length: 28 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 28;
    return [0.15 * Math.cos(angle), 0.3, 0.15 * Math.sin(angle)];
  });
  return shape.tube(metal, rest, 0.011, { segments: 5, loop: true });
}

/** A counter with battens on its front and a rail for the feet: { top, body } as table(). */
export function bar([width, height, depth], { board, wood, metal }) {
  const [x, z] = [width / 2, depth / 2];
  const top = new Shape().quad(board, [[-x, height, z], [x, height, z], [x, height, -z], [-x, height, -z]]); // prettier-ignore
  const body = new Shape().box(board, [-x, height - 0.04, -z], [x, height, z], '+y');
  const [side, front, under] = [x - 0.03, z - 0.2, height - 0.04 - gap];
  body.box(wood, [-side, gap, -z + 0.03], [side, under, front]);
  const count = Math.round((2 * side) / 0.24);
  for (let i = 0; i < count; i++) {
    const middle = -side + ((i + 0.5) * 2 * side) / count;
    body.box(wood, [middle - 0.08, 0.1, front + gap], [middle + 0.08, under - 0.02, front + 0.02]);
  }
  const rail = [front + 0.12, 0.2];
  body.rod(metal, [-side, rail[1], rail[0]], [side, rail[1], rail[0]], 0.018, 8);
  return { top, body };
}

const bottle = (material, size) =>
  new Shape().lathe(material, [[0.036, gap], [0.037, 0.19], [0.014, 0.235], [0.013, 0.3]].map(([r, y]) => [r, y * size]), 6); // prettier-ignore

/** Cupboards with shelves of bottles above; back on z = 0. random: see random.mjs. */
export function backBar([width, height, depth], { wood, back, board, bottles, random }) {
  const [half, t, low] = [width / 2, 0.03, 0.9];
  const shape = new Shape().box(back, [-half, gap, 0], [half, height, 0.008]);
  shape.box(wood, [-half, gap, 0.009], [half, low, depth + 0.14]);
  for (const side of [-1, 1]) {
    const x = side > 0 ? half - t : -half;
    shape.box(wood, [x, low + gap, 0.009], [x + t, height, depth]);
  }
  shape.box(wood, [-half + t + gap, low + gap, 0.009], [half - t - gap, height, 0.02]);
  const kinds = bottles.map((material) => [0.92, 1, 1.08].map((size) => bottle(material, size)));
  const levels = 3;
  for (let i = 0; i < levels; i++) {
    const y = low + 0.06 + (i * (height - low - 0.06)) / levels;
    shape.box(board, [-half + t + gap, y, 0.021], [half - t - gap, y + t, depth]);
    for (let x = -half + 0.12; x < half - 0.12; x += random.between(0.2, 0.36))
      shape.add(random.pick(random.pick(kinds)), moved(x, y + t, depth / 2 + random.between(-0.03, 0.05)));
  }
  return shape;
}

/** A place laid for a guest who sits at +z: a plate, a napkin and a cup. */
function place(china, linen) {
  const shape = new Shape().lathe(china, [[0.07, gap], [0.118, 0.014], [0.12, 0.018]], 14); // prettier-ignore
  shape.box(linen, [-0.2, gap, -0.09], [-0.14, 0.01, 0.09]);
  const cup = [[0.026, gap], [0.036, 0.07], [0.036, 0.085]]; // prettier-ignore
  return shape.add(new Shape().lathe(china, cup, 10), moved(0.16, 0, -0.12));
}

/** Places at { x, z, turn }, m from the middle of the table and radians, and a vase with a twig in the middle. */
export function setting(places, { china, linen, vase, leaf }, turned) {
  const shape = new Shape();
  const one = place(china, linen);
  for (const { x, z, turn } of places) shape.add(one, (p) => moved(x, 0, z)(turned(turn)(p)));
  shape.lathe(vase, [[0.026, gap], [0.034, 0.05], [0.014, 0.11], [0.016, 0.125]], 10); // prettier-ignore
  for (const [x, z] of [[0.05, 0.01], [-0.03, 0.04], [-0.01, -0.05]]) // prettier-ignore
    shape.tube(leaf, [[x * 0.1, 0.127, z * 0.1], [x * 0.6, 0.19, z * 0.6], [x, 0.23, z]], [0.003, 0.012, 0.002], { segments: 4 }); // prettier-ignore
  return shape;
}

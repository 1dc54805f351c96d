// Abstract paintings for the sample rooms, painted from a seed. Each entry of `paintings` is
// (seed, aspect) => material specification; aspect: width / height of the canvas. Pictures do not tile.
import { createRandom, fractal, noise } from '../web/room-maker/random.mjs';
import { linearFromHex } from '../web/document/linear-colour.mjs';
import { mix, paintPicture, shade } from './texture.mjs';

const side = 224; // pixels of the shorter edge
const round = (value, levels) => Math.round(value * levels) / levels;
const smooth = (low, high, x) => {
  const t = Math.min(1, Math.max(0, (x - low) / (high - low)));
  return t * t * (3 - 2 * t);
};

function canvas(seed, aspect, colourAt) {
  const [width, height] = aspect >= 1 ? [Math.round(side * aspect), side] : [side, Math.round(side / aspect)];
  const paint = () =>
    paintPicture(width, height, (u, v) => {
      const brush = 0.06 * round(noise(u * 40, v * 90, 40, 90, seed + 77), 5);
      return shade(colourAt(u, v, aspect), 1 + brush);
    });
  return { paint, roughness: 0.8 };
}
const palette = (...hexes) => hexes.map(linearFromHex);

/** Hazy blocks of colour floating over one another. */
function colourField(seed, aspect) {
  const random = createRandom(seed);
  const [ground, ...blocks] = random.pick([
    palette('#7a1f1a', '#d2542c', '#e7a33b', '#a3271f'),
    palette('#1d2f4a', '#35618c', '#d9c9a3', '#16243a'),
    palette('#c9b48a', '#e6d7b3', '#b4552f', '#3e4f4a'),
  ]);
  const cuts = [0.05, random.between(0.3, 0.42), random.between(0.58, 0.7), 0.95];
  return canvas(seed, aspect, (u, v) => {
    const edge = 0.02 * fractal(u, v, 5, 5, 3, seed);
    let colour = ground;
    for (let i = 0; i < 3; i++) {
      const inside =
        smooth(0.05, 0.09, u + edge) * smooth(0.05, 0.09, 1 - u + edge) *
        smooth(cuts[i] + 0.015, cuts[i] + 0.045, v + edge) * smooth(0.015, 0.045, cuts[i + 1] - v + edge); // prettier-ignore
      const cloud = 0.85 + 0.2 * round(fractal(u, v, 4, 6, 4, seed + i), 16);
      colour = mix(colour, shade(blocks[i], cloud), inside * 0.93);
    }
    return colour;
  });
}

/** Overlapping discs and half discs on a pale ground. */
function discs(seed, aspect) {
  const random = createRandom(seed);
  const colours = palette('#d8452e', '#24507a', '#e9b233', '#20242a', '#5f9a8c', '#d98f73');
  const ground = linearFromHex('#ece4d3');
  const list = Array.from({ length: 9 }, () => ({
    x: random.between(0.1, 0.9) * aspect,
    y: random.between(0.1, 0.9),
    r: random.between(0.08, 0.26),
    hole: random.next() < 0.35 ? random.between(0.4, 0.75) : 0,
    cut: random.next() < 0.4 ? random.between(0, Math.PI) : null,
    colour: random.pick(colours),
  }));
  return canvas(seed, aspect, (u, v) => {
    let colour = ground;
    for (const { x, y, r, hole, cut, colour: own } of list) {
      const [dx, dy] = [u * aspect - x, v - y];
      const distance = Math.hypot(dx, dy) / r;
      const kept = cut === null || dx * Math.cos(cut) + dy * Math.sin(cut) > 0;
      if (distance < 1 && distance > hole && kept) colour = mix(colour, own, 0.9);
    }
    return colour;
  });
}

/** Layers of hills towards a pale sky. */
function hills(seed, aspect) {
  const random = createRandom(seed);
  const [sky, far, near] = random.pick([
    palette('#f0d9b5', '#c98d6b', '#2d3a4a'),
    palette('#dfe6e4', '#8fb0b3', '#1f3d43'),
    palette('#f3c9a0', '#b9637a', '#33264d'),
  ]);
  const layers = 6;
  return canvas(seed, aspect, (u, v) => {
    let colour = mix(sky, shade(sky, 0.8), smooth(0.5, 0, v));
    const [sx, sy] = [0.68 * aspect, 0.26];
    if (Math.hypot(u * aspect - sx, v - sy) < 0.085) colour = shade(mix(sky, far, 0.35), 1.15);
    for (let i = 0; i < layers; i++) {
      const ridge = 0.38 + 0.11 * i + (0.1 - 0.006 * i) * fractal(u, 0.5, 3 + i, 1, 4, seed + 13 * i);
      if (v > ridge) colour = mix(shade(mix(far, near, i / (layers - 1)), 1.25), mix(far, near, i / (layers - 1)), smooth(ridge, ridge + 0.1, v)); // prettier-ignore
    }
    return colour;
  });
}

/** Waving bands. */
export function waves(seed, aspect) {
  const random = createRandom(seed);
  const colours = random.pick([
    palette('#12355b', '#f2efe6', '#d64933', '#f2efe6', '#e0a458', '#f2efe6'),
    palette('#1f2421', '#e7e2d3', '#5c8d89', '#e7e2d3', '#c06e52', '#e7e2d3'),
  ]);
  const bands = random.integer(12, 18);
  return canvas(seed, aspect, (u, v) => {
    const bend = 0.12 * Math.sin(2 * Math.PI * (u * 0.9 + 0.2)) + 0.16 * fractal(u, v, 2, 2, 2, seed);
    const band = Math.floor((v + bend + 1) * bands);
    return colours[band % colours.length];
  });
}

/** A grid of black bars with a few filled fields. */
export function grid(seed, aspect) {
  const random = createRandom(seed);
  const colours = palette('#c8281f', '#1f4788', '#e8b923', '#efeadd', '#efeadd', '#efeadd', '#cfd3d1');
  const cuts = (count) => {
    const list = [0];
    for (let i = 0; i < count; i++) list.push(list[i] + random.between(0.5, 1.6));
    return list.map((c) => c / list[count]);
  };
  const [us, vs] = [cuts(Math.max(3, Math.round(4 * aspect))), cuts(4)];
  const fields = us.map(() => vs.map(() => random.pick(colours)));
  const bar = linearFromHex('#17181a');
  return canvas(seed, aspect, (u, v) => {
    const i = us.findLastIndex((c) => c <= u);
    const j = vs.findLastIndex((c) => c <= v);
    const near = (list, x, scale) => list.slice(1, -1).some((c) => Math.abs(c - x) * scale < 0.012);
    return near(us, u, aspect) || near(vs, v, 1) ? bar : fields[i][j];
  });
}

/** Strokes and splashes over a washed ground. */
function strokes(seed, aspect) {
  const random = createRandom(seed);
  const colours = palette('#1b1d20', '#1b1d20', '#b8392b', '#2f5d62', '#d9a441');
  const ground = linearFromHex('#e6e0d2');
  const list = Array.from({ length: 26 }, () => {
    const angle = random.between(-0.9, 0.9) + (random.next() < 0.3 ? Math.PI / 2 : 0);
    return {
      x: random.between(0.1, 0.9) * aspect,
      y: random.between(0.1, 0.9),
      c: Math.cos(angle),
      s: Math.sin(angle),
      long: random.between(0.06, 0.3),
      thick: random.between(0.006, 0.03),
      curve: random.between(-2.5, 2.5),
      colour: random.pick(colours),
    };
  });
  return canvas(seed, aspect, (u, v) => {
    let colour = shade(ground, 0.94 + 0.1 * round(fractal(u, v, 4, 4, 4, seed), 14));
    const bristle = 0.5 * noise(u * 60, v * 60, 60, 60, seed + 3);
    for (const { x, y, c, s, long, thick, curve, colour: own } of list) {
      const [dx, dy] = [u * aspect - x, v - y];
      const a = c * dx + s * dy;
      const b = c * dy - s * dx + curve * a * a;
      const end = 1 - Math.abs(a) / long;
      if (end > 0 && Math.abs(b) < thick * (0.55 + 0.6 * Math.sqrt(end) + 0.4 * bristle))
        colour = mix(colour, own, 0.88);
    }
    return colour;
  });
}

/** Quarter rings in square fields. */
export function quarters(seed, aspect) {
  const random = createRandom(seed);
  const colours = palette('#274c5e', '#e3a857', '#c4523a', '#efe6d5', '#7ba098', '#2c2b30');
  const rows = 4;
  const columns = Math.max(2, Math.round(rows * aspect));
  const cells = Array.from({ length: rows * columns }, () => ({
    corner: random.integer(0, 3),
    rings: Array.from({ length: 4 }, () => random.pick(colours)),
  }));
  return canvas(seed, aspect, (u, v) => {
    const [i, j] = [Math.floor(u * columns), Math.floor(v * rows)];
    const { corner, rings } = cells[j * columns + i];
    const [a, b] = [u * columns - i, v * rows - j];
    const distance = Math.hypot(corner & 1 ? 1 - a : a, corner & 2 ? 1 - b : b);
    return rings[Math.min(3, Math.floor(distance * 3.2))];
  });
}

export const paintings = [colourField, discs, hills, waves, grid, strokes, quarters];

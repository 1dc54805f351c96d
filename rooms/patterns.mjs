// Seamless procedural textures: each returns a picture in linear light that repeats in both directions.
// Tones are rounded to a few levels, which keeps the PNG files small without being visible.
import { fractal, hash, noise } from '../web/room-maker/random.mjs';
import { linearFromHex } from '../web/document/linear-colour.mjs';
import { mix, paintPicture, shade } from './texture.mjs';

const round = (value, levels) => Math.round(value * levels) / levels;
const chance = (...integers) => hash(...integers) / 4294967296;
const fraction = (x) => x - Math.floor(x);

/** Painted plaster: broad, hardly visible clouds. */
export function plaster(hex, seed) {
  const colour = linearFromHex(hex);
  return paintPicture(128, 128, (u, v) => shade(colour, 1 + 0.024 * round(fractal(u, v, 3, 3, 5, seed), 12)));
}

/** A mineral-fibre ceiling tile with the shadow line of its grid. */
export function ceilingTile(seed) {
  const colour = linearFromHex('#f4f3ef');
  return paintPicture(160, 160, (u, v) => {
    const edge = Math.min(u, v, 1 - u, 1 - v);
    if (edge < 0.01) return shade(colour, 0.55);
    if (edge < 0.022) return shade(colour, 0.93);
    const pore = noise(u * 64, v * 64, 64, 64, seed) > 0.62 ? 0.9 : 1;
    return shade(colour, pore * (1 + 0.02 * round(fractal(u, v, 8, 8, 2, seed), 10)));
  });
}

/** Two by two stone slabs with narrow joints. */
export function stoneTiles(hex, seed) {
  const colour = linearFromHex(hex);
  return paintPicture(320, 320, (u, v) => {
    const [a, b] = [fraction(2 * u), fraction(2 * v)];
    if (Math.min(a, b, 1 - a, 1 - b) < 0.006) return shade(colour, 0.55);
    const slab = chance(seed, Math.floor(2 * u), Math.floor(2 * v));
    const cloud = fractal(u, v, 5, 5, 5, seed + Math.floor(4 * slab));
    const fleck = noise(u * 150, v * 150, 150, 150, seed + 9);
    const dark = fleck > 0.7 ? -0.16 : fleck < -0.72 ? 0.14 : 0;
    return shade(colour, 0.94 + 0.12 * slab + 0.14 * round(cloud, 24) + dark);
  });
}

/** Carpet tiles of half a metre, laid in alternating directions. */
export function carpetTiles(hex, seed) {
  const colour = linearFromHex(hex);
  return paintPicture(256, 256, (u, v) => {
    const [i, j] = [Math.floor(2 * u), Math.floor(2 * v)];
    const across = (i + j) % 2 === 0;
    const [a, b] = across ? [u, v] : [v, u];
    const rib = noise(a * 32, b * 128, 32, 128, seed);
    const cloud = fractal(u, v, 6, 6, 3, seed + 5);
    const tone = 0.95 + 0.1 * chance(seed, i, j);
    return shade(colour, tone + 0.3 * round(rib, 8) + 0.1 * round(cloud, 8));
  });
}

/** Eight courses of staggered boards with grain. */
export function planks(hex, seed) {
  const colour = linearFromHex(hex);
  const dark = shade(colour, 0.62);
  return paintPicture(512, 384, (u, v) => {
    const course = Math.floor(8 * v);
    const b = fraction(8 * v);
    const shifted = fraction(u + 0.5 * (course % 2) + 0.37 * chance(seed, course));
    const board = Math.floor(2 * shifted);
    const a = fraction(2 * shifted);
    if (b < 0.03 || a < 0.0025) return shade(colour, 0.42);
    const id = hash(seed, course, board) % 1000;
    const wave = 0.6 * noise(u * 6, v * 24, 6, 24, seed + id);
    const grain = noise(u * 14, v * 160 + 4 * wave, 14, 160, seed + id);
    const pores = noise(u * 60, v * 192, 60, 192, seed + 3);
    const tone = 0.84 + 0.3 * chance(seed, course, board, 7);
    const t = 0.28 + 0.28 * round(grain, 10) + (pores > 0.55 ? 0.16 : 0);
    return shade(mix(colour, dark, Math.max(0, t)), tone);
  });
}

/** A sheet of wood without joints; the grain runs across, or upright. */
export function veneer(hex, seed, upright = false) {
  const colour = linearFromHex(hex);
  const dark = shade(colour, 0.68);
  return paintPicture(256, 256, (x, y) => {
    const [u, v] = upright ? [y, x] : [x, y];
    const wave = noise(u * 3, v * 6, 3, 6, seed);
    const grain = noise(u * 5, v * 48 + 3 * wave, 5, 48, seed + 1);
    const fine = noise(u * 24, v * 128, 24, 128, seed + 2);
    return mix(colour, dark, Math.max(0, 0.3 + 0.3 * round(grain, 10) + 0.12 * round(fine, 4)));
  });
}

/** Marbled linoleum. */
export function linoleum(hex, seed) {
  const colour = linearFromHex(hex);
  return paintPicture(256, 256, (u, v) => {
    const warp = 0.05 * fractal(u, v, 4, 4, 3, seed + 8);
    const cloud = fractal(fraction(u + warp), fraction(v - warp), 14, 26, 3, seed);
    const fleck = noise(u * 100, v * 128, 100, 128, seed + 4) > 0.7 ? 0.14 : 0;
    return shade(colour, 1 + 0.13 * round(cloud, 14) + 0.7 * fleck);
  });
}

/** Plain weave of a fabric. */
export function weave(hex, seed) {
  const colour = linearFromHex(hex);
  return paintPicture(96, 96, (u, v) => {
    const over = (Math.floor(32 * u) + Math.floor(32 * v)) % 2 === 0;
    const fibre = noise(u * 48, v * 48, 48, 48, seed);
    return shade(colour, (over ? 1.1 : 0.88) + 0.2 * round(fibre, 6));
  });
}

/** Cork: dense grains of several browns. */
export function cork(hex, seed) {
  const colour = linearFromHex(hex);
  return paintPicture(160, 160, (u, v) => {
    const grain = noise(u * 56, v * 56, 56, 56, seed);
    const cloud = fractal(u, v, 12, 12, 2, seed + 2);
    return shade(colour, 1 + 0.3 * round(grain, 6) + 0.15 * round(cloud, 6));
  });
}

/** Horizontal slats of a blind, eight to a tile. */
export function slats(hex) {
  const colour = linearFromHex(hex);
  return paintPicture(8, 128, (u, v) => {
    const t = fraction(8 * v);
    return shade(colour, t > 0.88 ? 0.5 : 1.06 - 0.22 * t);
  });
}

/** White stone with grey veins. */
export function marble(hex, seed) {
  const colour = linearFromHex(hex);
  return paintPicture(192, 192, (u, v) => {
    const vein = Math.abs(fractal(u, v, 3, 3, 5, seed));
    return shade(colour, round(0.72 + 0.28 * Math.min(1, vein * 7), 40));
  });
}

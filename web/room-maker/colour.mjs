// Colours in linear light, and how much of the light they give back.

const linearFromSrgb = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);

/** Relative luminance of a linear colour (Rec. 709). */
export const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/** Linear colour of '#rrggbb'. */
export function linearFromHex(hex) {
  return [1, 3, 5].map((i) => linearFromSrgb(parseInt(hex.slice(i, i + 2), 16) / 255));
}

/** The colour scaled to a luminance; without one it stays as it is. Channels stay within 1. */
export function withReflectance(colour, reflectance) {
  if (reflectance === undefined) return colour;
  const factor = reflectance / luminance(colour);
  return colour.map((c) => Math.min(1, c * factor));
}

/** A colour of exactly this luminance: what scaling alone would cut off is made up for by white. */
export function tintOf(hex, reflectance) {
  const colour = linearFromHex(hex);
  const own = luminance(colour);
  if (own < 1e-6) return [reflectance, reflectance, reflectance];
  const scaled = colour.map((c) => (c * reflectance) / own);
  const most = Math.max(...scaled);
  if (most <= 1) return scaled;
  // note: mixed with the grey of the same luminance, which leaves the luminance as it is
  const share = (1 - reflectance) / (most - reflectance);
  return scaled.map((c) => reflectance + share * (c - reflectance));
}

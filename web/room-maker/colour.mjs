// Colours of so much luminance.
import { linearFromHex, luminance } from '../document/linear-colour.mjs';

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

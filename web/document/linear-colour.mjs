// Colours as linear light, for the page and for the generators of rooms, which run in plain Node.

/** A channel of sRGB, 0 to 1, as linear light. */
export const linearFromSrgb = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);

/** Relative luminance of a linear colour (Rec. 709). */
export const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/** Linear colour of '#rrggbb'. */
export function linearFromHex(hex) {
  return [1, 3, 5].map((i) => linearFromSrgb(parseInt(hex.slice(i, i + 2), 16) / 255));
}

// Pictures in linear light, and their way into a PNG file of a stated mean reflectance.
// A picture is { width, height, pixels }: pixels holds linear red, green, blue per pixel, row by row.
import { PNG } from 'pngjs';
import { luminance } from '../web/document/linear-colour.mjs';

const srgbFromLinear = (c) => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);

export const mix = (a, b, t) => a.map((c, i) => c + (b[i] - c) * t);
export const shade = (colour, factor) => colour.map((c) => c * factor);

/** Paints pixel by pixel: colourAt(u, v) of the pixel's centre, u to the right, v downwards, in [0, 1). */
export function paintPicture(width, height, colourAt) {
  const pixels = new Float64Array(width * height * 3);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++)
      pixels.set(colourAt((x + 0.5) / width, (y + 0.5) / height), 3 * (y * width + x));
  return { width, height, pixels };
}

/** PNG bytes of a picture, scaled so that its mean luminance is the reflectance (when one is given). */
export function encodePng({ width, height, pixels }, reflectance) {
  let factor = 1;
  if (reflectance !== undefined) {
    let sum = 0;
    for (let i = 0; i < pixels.length; i += 3) sum += luminance([pixels[i], pixels[i + 1], pixels[i + 2]]);
    factor = reflectance / (sum / (width * height));
  }
  const png = new PNG({ width, height, colorType: 2, inputHasAlpha: false });
  png.data = Buffer.alloc(width * height * 3);
  for (let i = 0; i < pixels.length; i++)
    png.data[i] = Math.round(255 * srgbFromLinear(Math.min(1, Math.max(0, pixels[i] * factor))));
  return new Uint8Array(
    PNG.sync.write(png, {
      width,
      height,
      colorType: 2,
      inputColorType: 2,
      inputHasAlpha: false,
      deflateLevel: 9,
    }),
  );
}

/**
 * Colour maps of the false-colour view, as tables of 256 sRGB colours computed once from published fits:
 * viridis and inferno by M. Zucker's sextics, turbo by A. Mikhailov's quintic, cividis by the quintic of d3.
 */
import type { ColorMap } from '../../document/types.ts';

export const tableSize = 256;

/** Coefficients of red, green and blue for t^0, t^1, ... with t in 0..1 and colours in 0..1. */
type Polynomial = readonly (readonly [number, number, number])[];

const viridis: Polynomial = [
  [0.2777273272, 0.0054073445, 0.3340998053],
  [0.1050930431, 1.4046135299, 1.3845901627],
  [-0.3308618287, 0.2148475595, 0.095095163],
  [-4.634230499, -5.7991009734, -19.3324409563],
  [6.2282699363, 14.1799333668, 56.6905526007],
  [4.77638499767, -13.745145377746, -65.353032633372],
  [-5.435455855935, 4.645852612179, 26.3124352496],
];

const inferno: Polynomial = [
  [0.000218940369, 0.001651004631, -0.019480898437],
  [0.106513419486, 0.563956436788, 3.932712388889],
  [11.602493082472, -3.972853965666, -15.942394106291],
  [-41.703996131395, 17.436398882053, 44.354145198728],
  [77.162935699427, -33.402358942101, -81.807309257389],
  [-71.319428244992, 32.626064263977, 73.20951985803],
  [25.131126224773, -12.242668952386, -23.070325002872],
];

const turbo: Polynomial = [
  [0.13572138, 0.09140261, 0.1066733],
  [4.6153926, 2.19418839, 12.64194608],
  [-42.66032258, 4.84296658, -60.58204836],
  [132.13108234, -14.18503333, 110.36276771],
  [-152.94239396, 4.27729857, -89.90310912],
  [59.28637943, 2.82956604, 27.34824973],
];

const cividis: Polynomial = [
  [-4.54 / 255, 32.49 / 255, 81.24 / 255],
  [-35.34 / 255, 170.73 / 255, 442.36 / 255],
  [2381.73 / 255, 52.82 / 255, -2482.43 / 255],
  [-6402.7 / 255, -131.46 / 255, 6167.24 / 255],
  [7024.72 / 255, 176.58 / 255, -6614.94 / 255],
  [-2710.57 / 255, -67.37 / 255, 2475.67 / 255],
];

const polynomials: Record<ColorMap, Polynomial> = { viridis, cividis, inferno, turbo };

const byte = (value: number): number => Math.round(255 * Math.min(1, Math.max(0, value)));

function evaluate(polynomial: Polynomial, t: number): [number, number, number] {
  const color: [number, number, number] = [0, 0, 0];
  for (let power = polynomial.length - 1; power >= 0; power--) {
    const term = polynomial[power]!;
    for (let channel = 0; channel < 3; channel++) color[channel] = color[channel]! * t + term[channel]!;
  }
  return color;
}

const tables = new Map<ColorMap, Uint8Array>();

/** 256 x RGBA, sRGB bytes, from the low end of the map to the high one. */
export function colorTable(map: ColorMap): Uint8Array {
  let table = tables.get(map);
  if (!table) {
    table = new Uint8Array(4 * tableSize);
    for (let i = 0; i < tableSize; i++) {
      const [red, green, blue] = evaluate(polynomials[map], i / (tableSize - 1));
      table.set([byte(red), byte(green), byte(blue), 255], 4 * i);
    }
    tables.set(map, table);
  }
  return table;
}

/** sRGB bytes at t in 0..1. */
export function mapColor(map: ColorMap, t: number): [number, number, number] {
  const table = colorTable(map);
  const at = 4 * Math.round(Math.min(1, Math.max(0, t)) * (tableSize - 1));
  return [table[at]!, table[at + 1]!, table[at + 2]!];
}

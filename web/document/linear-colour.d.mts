/** Linear red, green and blue. */
export type Rgb = readonly [number, number, number];

export function linearFromSrgb(channel: number): number;
export function luminance(colour: Rgb): number;
export function linearFromHex(hex: string): Rgb;

// Outlines to start from, and "6 x 4 x 2.8" as it is typed.

/** Corners of a room of width x depth (m); what is cut out of it (m) makes the letter. */
export const outlines = {
  rectangle: (w, d) => [[0, 0], [w, 0], [w, d], [0, d]],
  L: (w, d, cutW = w / 2, cutD = d / 2) => [[0, 0], [w, 0], [w, d - cutD], [w - cutW, d - cutD], [w - cutW, d], [0, d]],
  U: (w, d, cutW = w / 3, cutD = d / 2) => [
    [0, 0], [w, 0], [w, d], [(w + cutW) / 2, d], [(w + cutW) / 2, d - cutD], [(w - cutW) / 2, d - cutD],
    [(w - cutW) / 2, d], [0, d],
  ],
  T: (w, d, cutW = w / 3, cutD = d / 2) => [
    [0, 0], [w, 0], [w, d - cutD], [w - cutW, d - cutD], [w - cutW, d], [cutW, d], [cutW, d - cutD], [0, d - cutD],
  ],
}; // prettier-ignore

const units = { m: 1, cm: 0.01, mm: 0.001 };
const usualHeight = 2.8;

/** m, of rooms that are typed: the shortest side or height, the longest side, the tallest. */
export const sizeBounds = { least: 0.5, longest: 500, tallest: 50 };

/** The unit of lengths that were typed without one. */
function guessedUnit([width, depth, height]) {
  if (width < 100 || depth < 100) return units.m;
  const isLarge = (width >= 1000 && depth >= 1000) || height > 1000; // more than 10 m: no room's height in centimetres
  const isRoom = [width, depth, height ?? Infinity].every((value) => value * units.mm >= sizeBounds.least);
  return isLarge && isRoom ? units.mm : units.cm;
}

/** Three lengths as they were typed, in metres; null where they cannot be understood. */
function readLengths(text) {
  const clean = text.trim().toLowerCase().replace(/,/g, '.');
  const found = /^([\d.]+)\s*(mm|cm|m)?\s*(?:x|×|\*|by)\s*([\d.]+)\s*(mm|cm|m)?(?:\s*(?:x|×|\*|by)\s*([\d.]+)\s*(mm|cm|m)?)?$/.exec(clean); // prettier-ignore
  if (!found) return null;
  const [, w, wUnit, d, dUnit, h, hUnit] = found;
  const unit = hUnit ?? dUnit ?? wUnit;
  const lengths = [w, d, h ?? 'none'].map((each) => (each === 'none' ? null : Number(each)));
  if (lengths.some(Number.isNaN)) return null;
  const factor = unit ? units[unit] : guessedUnit(lengths);
  const [width, depth, height] = lengths.map((value) => Math.round((value ?? 0) * factor * 1000) / 1000);
  return { width, depth, height: lengths[2] === null ? usualHeight : height };
}

/**
 * "6 x 4 x 2.8", "6 × 4", "600 x 400 x 280 cm", "6,5 by 4 m" -> { size: { width, depth, height } } in metres, or
 * { fault }: 'unread', or 'outside' of what a room may be. Without a height it is 2.8 m; without a unit metres,
 * or, from 100 on, centimetres, or, from 1000 on, millimetres where these make a room.
 */
export function readSize(text) {
  const size = readLengths(text);
  if (!size) return { fault: 'unread' };
  const { least, longest, tallest } = sizeBounds;
  const { width, depth, height } = size;
  const fits = Math.min(width, depth, height) >= least && Math.max(width, depth) <= longest;
  return fits && height <= tallest ? { size } : { fault: 'outside' };
}

// Seeded randomness for the sample rooms: the same seed gives the same room on every machine.
// A small counter-based integer hash serves both the generator and the lattice of the noise.

/** Mixes integers into one unsigned 32-bit hash. */
export function hash(...integers) {
  let h = 0x9e3779b9;
  for (const value of integers) {
    h = Math.imul(h ^ (value | 0), 0x85ebca6b);
    h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
    h ^= h >>> 16;
  }
  return h >>> 0;
}

/** A stream of numbers in [0, 1) with a few distributions on top. */
export function createRandom(seed) {
  let counter = 0;
  const next = () => hash(seed, counter++) / 4294967296;
  return {
    next,
    between: (low, high) => low + (high - low) * next(),
    integer: (low, high) => low + Math.floor((high - low + 1) * next()),
    pick: (list) => list[Math.floor(list.length * next())],
  };
}

const ease = (t) => t * t * t * (t * (t * 6 - 15) + 10);
const wrap = (i, period) => ((i % period) + period) % period;

/** Value noise in [-1, 1] that repeats after periodX, periodY lattice cells. */
export function noise(x, y, periodX, periodY, seed) {
  const i = Math.floor(x);
  const j = Math.floor(y);
  const at = (di, dj) => hash(seed, wrap(i + di, periodX), wrap(j + dj, periodY)) / 2147483648 - 1;
  const s = ease(x - i);
  const t = ease(y - j);
  const low = at(0, 0) + s * (at(1, 0) - at(0, 0));
  const high = at(0, 1) + s * (at(1, 1) - at(0, 1));
  return low + t * (high - low);
}

/** Sum of octaves of noise over the unit square, seamless; cellsX, cellsY: lattice cells of the first octave. */
export function fractal(u, v, cellsX, cellsY, octaves, seed) {
  let sum = 0;
  let weight = 1;
  let total = 0;
  for (let octave = 0; octave < octaves; octave++) {
    const [px, py] = [cellsX << octave, cellsY << octave];
    sum += weight * noise(u * px, v * py, px, py, seed + octave);
    total += weight;
    weight *= 0.5;
  }
  return sum / total;
}

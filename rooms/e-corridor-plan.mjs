// The plan of the E corridor. The catalogue reads it too, before any package is there.

export const cell = 0.75; // m
export const height = 4; // cells
export const spine = { width: 6, length: 43 }; // cells along x and z
export const arms = [
  { start: 0, width: 6 },
  { start: 19, width: 5 },
  { start: 37, width: 6 },
]; // cells along z; every arm leaves the spine at x = 6
export const armDepth = 11; // cells along x

/** Words beside numbers: quantities, bounds, counts, what a standard asks. */
import { counted } from '../numbers.ts';

export const values = {
  corner: 'south-west corner, at floor level',
  bounds: (n: number) => counted(n, 'bound', 'bounds'),
  luminaires: (n: number) => counted(n, 'luminaire', 'luminaires'),
  points: (n: number) => counted(n, 'point', 'points'),
};

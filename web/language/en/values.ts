/** Words beside numbers: quantities, bounds, counts, what a standard asks. */
import { counted } from '../numbers.ts';

export const values = {
  corner: 'south-west corner, at floor level',
  bounds: (n: number) => counted(n, 'bound', 'bounds'),
  luminaires: (n: number) => counted(n, 'luminaire', 'luminaires'),
  points: (n: number) => counted(n, 'point', 'points'),
  unmet: 'not met',
  wholeRoom: 'the whole room',
  atMost: (value: string) => `At most ${value}`,
  atLeast: (value: string) => `At least ${value}`,
  readAs: (value: string) => `Read as ${value}`,
  labelAtLeast: (label: string) => `${label} at least`,
  noLower: 'no lower bound',
  labelAtMost: (label: string) => `${label} at most`,
  noUpper: 'no upper bound',
};

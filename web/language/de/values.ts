/** Words beside numbers: quantities, bounds, counts, what a standard asks. */
import { counted } from '../numbers.ts';
import type { Words } from '../en.ts';

export const values: Words['values'] = {
  corner: 'der Südwestecke, auf Bodenhöhe',
  bounds: (n) => counted(n, 'Vorgabe', 'Vorgaben'),
  luminaires: (n) => counted(n, 'Leuchte', 'Leuchten'),
  points: (n) => counted(n, 'Punkt', 'Punkte'),
  unmet: 'nicht erfüllt',
  wholeRoom: 'der ganze Raum',
  atMost: (value) => `Höchstens ${value}`,
  atLeast: (value) => `Mindestens ${value}`,
  readAs: (value) => `Gelesen als ${value}`,
  labelAtLeast: (label) => `${label} mindestens`,
  noLower: 'keine untere Grenze',
  labelAtMost: (label) => `${label} höchstens`,
  noUpper: 'keine obere Grenze',
};

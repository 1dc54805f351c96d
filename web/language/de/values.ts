/** Words beside numbers: quantities, bounds, counts, what a standard asks. */
import { counted } from '../numbers.ts';
import type { Words } from '../en.ts';

export const values: Words['values'] = {
  corner: 'der Südwestecke, auf Bodenhöhe',
  bounds: (n) => counted(n, 'Vorgabe', 'Vorgaben'),
  luminaires: (n) => counted(n, 'Leuchte', 'Leuchten'),
  points: (n) => counted(n, 'Punkt', 'Punkte'),
};

/** The ends of the legend where nobody has locked them. */
import type { Shown } from '../../solver/protocol.ts';
import { niceCeiling } from '../words/format.ts';
import type { Store } from './store.ts';

/** The legend spans the light that is there, rounded, unless a person has locked it. */
export function fitLegend(store: Store, shown: Shown): void {
  const rows = shown.surfaces.filter((row) => row.name !== 'all');
  const area = rows.reduce((sum, row) => sum + row.area, 0);
  const mean = rows.reduce((sum, row) => sum + row.mean * row.area, 0) / (area || 1);
  const top = niceCeiling(Math.max(1, mean * 2.5));
  const { range } = store.display.peek();
  const fits = range[0] === 0 && range[1] >= mean * 2 && range[1] <= mean * 5;
  if (!fits) store.display.value = { ...store.display.peek(), range: [0, top] };
}

/** The ends of the legend where nobody has locked them. */
import type { Shown } from '../../solver/protocol.ts';
import { roundRange } from '../../viewer/light/false-color.ts';
import type { Store } from './store.ts';

/** The legend spans the light that is there, and that which it is compared with, rounded, unless a person has locked it. */
export function fitLegend(store: Store, shown: Shown): void {
  if (!store.display.peek().rangeFollows) return;
  const mean = Math.max(meanOf(shown), meanOf(store.other.peek() ?? shown));
  const display = store.display.peek();
  const range = roundRange(Math.max(1, mean * 2.5), display.logarithmic, display.steps);
  // Ends that still hold the light stay: a legend that twitches at every answer cannot be read.
  const [low, high] = display.range;
  const round = roundRange(high, display.logarithmic, display.steps);
  const isRound = low === round[0] && high === round[1];
  if (!isRound || high < mean * 2 || high > mean * 5) store.display.value = { ...display, range };
}

function meanOf({ surfaces }: Shown): number {
  const rows = surfaces.filter((row) => row.name !== 'all');
  const area = rows.reduce((sum, row) => sum + row.area, 0);
  return rows.reduce((sum, row) => sum + row.mean * row.area, 0) / (area || 1);
}

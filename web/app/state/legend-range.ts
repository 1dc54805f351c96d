/** The ends of the legend where nobody has locked them. */
import { leavesOf } from '../../document/surface-names.ts';
import type { Shown, SurfaceResult } from '../../solver/protocol.ts';
import { roundRange } from '../../viewer/light/false-color.ts';
import type { Store } from './store.ts';

const ofRoom = 2.5; // times the mean of all surfaces
const ofNamed = 1.25; // times the mean of what an intention names: the brightest of these is what is looked for

/** The legend spans the light that is there, and that which it is compared with, rounded, unless a person has locked it. */
export function fitLegend(store: Store, shown: Shown): void {
  if (!store.display.peek().rangeFollows) return;
  const wanted = Math.max(1, wantedFor(store, shown), wantedFor(store, store.other.peek() ?? shown));
  const display = store.display.peek();
  const range = roundRange(wanted, display.logarithmic, display.steps);
  // Ends that still hold the light stay: a legend that twitches at every answer cannot be read.
  const [low, high] = display.range;
  const round = roundRange(high, display.logarithmic, display.steps);
  const isRound = low === round[0] && high === round[1];
  if (!isRound || high < wanted * 0.8 || high > wanted * 2) store.display.value = { ...display, range };
}

/** A room of few lit works is dark by far, and its works are what it is about. */
function wantedFor(store: Store, { surfaces }: Shown): number {
  const leaves = store.sceneWithAreas.peek()?.surfaces ?? [];
  const named = store.document
    .peek()
    .cards.map((card) => meanOf(leavesOf(card.surfaces, leaves).flatMap((leaf) => surfaces[leaf] ?? [])));
  return Math.max(
    ofRoom * meanOf(surfaces.filter((row) => row.name !== 'all')),
    ofNamed * Math.max(0, ...named),
  );
}

function meanOf(rows: readonly SurfaceResult[]): number {
  const area = rows.reduce((sum, row) => sum + row.area, 0);
  return rows.reduce((sum, row) => sum + row.mean * row.area, 0) / (area || 1);
}

/** From the document's words to the core's numbers: names become leaf indices, missing bounds become infinite. */
import { boundedBy } from '../document/intentions.ts';
import { paintByLeaf } from '../document/paint.ts';
import { usualInRow } from '../document/ties.ts';
import type {
  Constraint,
  Glare,
  Intentions,
  Layout,
  Luminaires,
  Paint,
  SceneInfo,
} from '../document/types.ts';
import { codes, type CoreGlare, type CoreIntentions, type CoreLayout, type CoreShown } from './core.ts';
import type {
  GridResult,
  IntentionResult,
  ObserverResult,
  PaintGain,
  PlaneResult,
  Shown,
} from './protocol.ts';
import { surfaceSetOf, type NamedSurface } from '../document/surface-names.ts';

/** Who looks; null for nobody. */
export function coreGlare(glare: Glare | undefined): CoreGlare | null {
  if (!glare) return null;
  const { observers = [] } = glare;
  return {
    inRoom: observers.length === 0,
    names: observers.map(({ name }) => name),
    observers: Float64Array.from(observers.flatMap(({ position, direction }) => [...position, ...direction])),
  };
}

/** Two numbers a painted leaf: its index and its reflectance. */
export function corePaint(
  paint: readonly Paint[] | undefined,
  surfaces: SceneInfo['surfaces'],
): Float64Array {
  const byLeaf = [...paintByLeaf(paint, surfaces)].sort(([a], [b]) => a - b);
  return Float64Array.from(byLeaf.flatMap(([leaf, { reflectance }]) => [leaf, reflectance]));
}

export function coreLuminaires(luminaires: Luminaires): CoreIntentions['luminaires'] {
  return {
    count: luminaires.count,
    countHigh: luminaires.most ?? 0,
    rule: codes.rule[luminaires.arrangement?.rule ?? 'free'],
    axis: codes.axis[luminaires.arrangement?.axis ?? 'found'],
    leastInRow: luminaires.arrangement?.leastInRow ?? usualInRow,
    flux: Float64Array.of(luminaires.flux),
    dimmingLow: luminaires.dimming[0],
    dimmingHigh: luminaires.dimming[1],
    pinned: Uint32Array.from(luminaires.pinned),
    excluded: Uint32Array.from(luminaires.excluded),
    minDistance: luminaires.minDistance,
    types: [], // note: those who have candidates know them (MountedSession)
    ofType: new Uint32Array(),
  };
}

/** Throws one readable line where a name is not in the room. */
export function coreIntentions(asked: Intentions, leaves: readonly NamedSurface[]): CoreIntentions {
  const surfaces = (of: Pick<Constraint, 'surfaces' | 'over' | 'quantity'>) => ({
    surfaces: surfaceSetOf(of.surfaces, leaves),
    over: surfaceSetOf(of.over ?? [], leaves),
    quantity: of.quantity === undefined ? null : codes.quantity[of.quantity],
  });
  const { luminaires, glare } = asked;
  return {
    glare: coreGlare(glare),
    zones: leaves.flatMap(({ name, part }) => (part ? [{ name, ...part }] : [])),
    quantity: codes.quantity[asked.quantity],
    luminaires: coreLuminaires(luminaires),
    goals: asked.goals.map((goal) => ({
      statistic: codes.statistic[goal.statistic],
      sense: codes.sense[goal.sense],
      weight: goal.weight,
      target: goal.target ?? 0,
      ...surfaces(goal),
    })),
    constraints: boundedBy(asked).map((constraint) => ({
      statistic: codes.statistic[constraint.statistic],
      lower: constraint.min ?? -Infinity,
      upper: constraint.max ?? Infinity,
      alpha: constraint.alpha ?? 1,
      isLeast: constraint.of === 'minimum',
      direction: constraint.direction ?? null,
      onGrid: constraint.on === 'grid',
      ...surfaces(constraint),
    })),
  };
}

/** The three arguments by which the core takes a layout. */
export function coreLayout(layout: Layout): [Uint32Array, Float64Array, number] {
  return [Uint32Array.from(layout.sites), Float64Array.from(layout.flux), layout.dimming];
}

export function layoutOf({ sites, flux, dimming, ties, mountings }: CoreLayout): Layout {
  const tied = ties.length > 0 && { ties: [...ties] };
  return { sites: [...sites], flux: [...flux], dimming, ...tied, ...(mountings && { mountings }) };
}

// Rounding of the sums, and of bounds that are met exactly.
export const metUpTo = 1e-6;

/** `goal`: the weighted objective of the search; violation is the sum over the constraints. */
export function shownOf(
  core: CoreShown,
  goal: number,
  leaves: readonly (NamedSurface & { area: number })[],
): Shown {
  const total = leaves.reduce((sum, leaf) => sum + (leaf.measuring ? 0 : leaf.area), 0);
  const rows = [...leaves, { name: 'all', area: total }];
  const constraints = triples(core.constraints);
  return {
    layout: layoutOf(core.layout),
    illuminance: core.illuminance,
    ...(core.direct && { direct: core.direct }),
    surfaces: rows.map(({ name, area }, s) => ({
      name,
      area,
      mean: core.surfaces[4 * s] ?? 0,
      sigma: core.surfaces[4 * s + 1] ?? 0,
      min: core.surfaces[4 * s + 2] ?? 0,
      max: core.surfaces[4 * s + 3] ?? 0,
    })),
    goals: Array.from(core.goals, (value) => ({ value, met: true, violation: 0, margin: Infinity })),
    constraints,
    goal,
    violation: constraints.reduce((sum, { violation }) => sum + violation, 0),
    observers: observersOf(core.observers),
    grids: gridsOf(core.grids, leaves),
    planes: core.planes.map((numbers) => planeOf(numbers, leaves)),
  };
}

function planeOf(numbers: Float64Array, leaves: readonly NamedSurface[]): PlaneResult {
  const at = (i: number) => ({ mean: numbers[i] ?? 0, least: numbers[i + 1] ?? 0 });
  const verticals = Array.from({ length: (numbers.length - 8) / 5 }, (_, i) => {
    const [x = 0, y = 0, z = 0] = numbers.subarray(8 + 5 * i);
    return { direction: [x, y, z] as const, ...at(11 + 5 * i) };
  });
  const name = leaves[numbers[0] ?? 0]?.name ?? '';
  return {
    name,
    points: numbers[1] ?? 0,
    horizontal: at(2),
    cylindrical: at(4),
    modelling: at(6),
    verticals,
  };
}

function observersOf({ names, numbers }: CoreShown['observers']): ObserverResult[] {
  return names.map((name, i) => {
    const [x = 0, y = 0, z = 0, dx = 0, dy = 0, dz = 0, ugr = 0, background = 0, cylindrical = 0] =
      numbers.subarray(9 * i);
    return {
      name,
      position: [x, y, z],
      direction: [dx, dy, dz],
      ugr: Number.isFinite(ugr) ? ugr : null,
      background,
      cylindrical,
    };
  });
}

function gridsOf(numbers: Float64Array, leaves: readonly NamedSurface[]): GridResult[] {
  return Array.from({ length: numbers.length / 7 }, (_, i) => {
    const [surface = 0, points = 0, spacing = 0, rim = 0, mean = 0, min = 0, max = 0] = numbers.subarray(
      7 * i,
    );
    return { name: leaves[surface]?.name ?? '', points, spacing, rim, mean, min, max };
  });
}

function triples(numbers: Float64Array): IntentionResult[] {
  return Array.from({ length: numbers.length / 3 }, (_, i) => {
    const violation = numbers[3 * i + 1] ?? 0;
    const met = violation <= metUpTo;
    const margin = numbers[3 * i + 2] ?? 0;
    return { value: numbers[3 * i] ?? 0, met, violation: met ? 0 : violation, margin };
  });
}

/** What the core tells of each surface in a row: its leaf, and what goals and constraints gain. */
export function gainsOf(
  numbers: Float64Array,
  { goals, constraints }: Pick<CoreIntentions, 'goals' | 'constraints'>,
): PaintGain[] {
  const width = 1 + goals.length + constraints.length;
  return Array.from({ length: numbers.length / width }, (_, row) => {
    const [surface = 0, ...gained] = numbers.subarray(row * width, (row + 1) * width);
    return { surface, goals: gained.slice(0, goals.length), constraints: gained.slice(goals.length) };
  });
}

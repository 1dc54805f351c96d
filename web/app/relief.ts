/**
 * Wishes that no layout meets: which of their bounds conflict, and what would do instead. Nothing is guessed: a bound is
 * said to conflict when the others can be met without it, and every number that is offered was searched for and met.
 */
import { isOfSquares } from '../document/intentions.ts';
import { isRatio } from '../document/statistics.ts';
import type { Constraint, Intentions, Layout } from '../document/types.ts';
import type { Outcome } from '../solver/protocol.ts';
import { askedAlone, evaluationsAlone } from './best-figures.ts';
import { roundFlux, roundSteps } from './words/round-steps.ts';

/** A change that was seen to meet everything, and the layout that does. */
export interface Way<Change> {
  readonly change: Change;
  readonly layout: Layout;
}

/** A bound of constraint i as it would do; null: only without it. */
export interface EasedBound {
  readonly constraint: number;
  readonly bound: number | null;
}

/** A rule about places as it would do: m between luminaires, or the room without its areas in plan. */
export type EasedRule =
  | { readonly rule: 'apart'; readonly least: number }
  | { readonly rule: 'places'; readonly excluded: readonly number[] };

/** What it costs is told, too. */
export type RuleWay = Way<EasedRule>;

export interface Relief {
  readonly of: Intentions; // that were asked for
  readonly rules: readonly RuleWay[]; // each alone does, and every bound is met
  /** Constraints that cannot be met together, while without any of them the others can; or, `isEach`, none of them alone. */
  readonly conflict: readonly number[];
  readonly isEach: boolean; // there are several that cannot be met even if nothing else is asked
  readonly isCrossed: boolean; // they are the least and the most of one figure, the least above the most
  readonly single: readonly Way<EasedBound>[]; // each alone does
  readonly patches: readonly Way<number>[]; // constraints that do as true minima or maxima instead of by statistics
  readonly flux: Way<number> | null; // lm of each luminaire
  readonly together: Way<readonly EasedBound[]> | null; // where no single bound is in the way
}

/** What a short search reaches for other intentions; null where the rules leave no layout. */
export type TryOne = (asked: Intentions, evaluations?: number) => Promise<Outcome | null>;

/**
 * `reached`: the value of each constraint in the layout shown, and whether it is met there. `withoutAreas`: the places kept
 * free one by one, where areas in plan keep others free; else null.
 */
export async function findRelief(
  of: Intentions,
  reached: readonly { readonly value: number; readonly met: boolean; readonly margin: number }[],
  tryOne: TryOne,
  withoutAreas: readonly number[] | null = null,
): Promise<Relief> {
  const rules = await easedRules(of, withoutAreas, tryOne);
  const layoutFor = async (asked: Intentions) => {
    const outcome = await tryOne(asked);
    return outcome?.met ? outcome.layout : null;
  };
  const missed = [...of.constraints.keys()].filter((i) => !reached[i]?.met);
  const crossed = crossedBounds(of.constraints);
  const found = crossed
    ? { conflict: crossed, isEach: false }
    : await conflictOf(of, reached, missed, tryOne, layoutFor);
  const { isEach } = found;
  const conflict = [...found.conflict].sort((a, b) => (reached[a]?.margin ?? 0) - (reached[b]?.margin ?? 0));

  const single: Way<EasedBound>[] = [];
  for (const constraint of isEach ? [] : conflict) {
    const way = await easedAlone(of, constraint, reached[constraint]?.value ?? Number.NaN, layoutFor);
    if (way) single.push(way);
  }
  const patches: Way<number>[] = [];
  for (const constraint of isEach ? [] : conflict) {
    const layout =
      of.constraints[constraint]?.statistic === 'chebyshev' && (await layoutFor(byPatches(of, constraint)));
    if (layout) patches.push({ change: constraint, layout });
  }
  const flux = await moreFlux(of, conflict, layoutFor);
  const together = single.length === 0 ? await easedTogether(of, missed, reached, layoutFor) : null;
  return { of, rules, conflict, isEach, isCrossed: crossed !== null, single, patches, flux, together };
}

/** A least and a most of one figure, the least above the most: no layout of any room meets both. */
function crossedBounds(constraints: readonly Constraint[]): readonly [number, number] | null {
  const figureOf = (constraint: Constraint) => {
    const unbounded = { ...constraint, min: null, max: null, surfaces: [...constraint.surfaces].sort() };
    return JSON.stringify(Object.entries(unbounded).sort());
  };
  for (const [i, one] of constraints.entries()) {
    const isAbove = ({ max }: Constraint) => one.min !== undefined && max !== undefined && one.min > max;
    const j = constraints.findIndex((other) => isAbove(other) && figureOf(other) === figureOf(one));
    if (j >= 0) return [i, j];
  }
  return null;
}

/** Bounds that cannot be met together, while without any of them the others can; `isEach`: none of them alone. */
async function conflictOf(
  of: Intentions,
  reached: readonly { readonly margin: number }[],
  missed: readonly number[],
  tryOne: TryOne,
  layoutFor: LayoutFor,
): Promise<Pick<Relief, 'conflict' | 'isEach'>> {
  const without = (some: readonly number[]) => withConstraints(of, (_, i) => !some.includes(i));
  // What is met with most to spare is the least likely to stand in the way of the others.
  const order = [...of.constraints.keys()].sort(
    (a, b) => (reached[b]?.margin ?? 0) - (reached[a]?.margin ?? 0),
  );
  const conflict: number[] = [];
  let dropped: number[] = [];
  for (const constraint of order) {
    if (await layoutFor(without([...dropped, constraint]))) conflict.push(constraint);
    else dropped = [...dropped, constraint];
  }
  const alone = conflict.length === 1 ? [...conflict] : []; // it is beyond the room by itself; others may be, too
  for (const constraint of missed)
    if (alone.length > 0 && !alone.includes(constraint) && !(await canBeMetAlone(of, constraint, tryOne)))
      alone.push(constraint);
  const isEach = alone.length > 1;
  return { conflict: isEach ? alone : conflict, isEach };
}

/** Searched for as long as the verdict does, which says of a row whether it can be met. */
async function canBeMetAlone(of: Intentions, constraint: number, tryOne: TryOne): Promise<boolean> {
  const asked = of.constraints[constraint];
  if (!asked) return true;
  const outcome = await tryOne(askedAlone(of, asked), evaluationsAlone);
  return outcome?.met === true;
}

/** Distances below one, m, to a tenth; the last one is none. */
const shorterThan = (apart: number): number[] => {
  const tenths = Math.ceil(10 * apart - 1e-9) - 1;
  const stride = Math.max(1, Math.ceil(tenths / 10));
  const steps = Array.from({ length: Math.floor(tenths / stride) }, (_, i) => (tenths - i * stride) / 10);
  return [...steps.filter((step) => step > 0), 0];
};

/** How near together, or where else, luminaires would have to hang for every bound to be met. */
async function easedRules(
  of: Intentions,
  withoutAreas: readonly number[] | null,
  tryOne: TryOne,
): Promise<RuleWay[]> {
  const { luminaires } = of;
  const ways: RuleWay[] = [];
  const under = async (change: EasedRule) => {
    const eased = change.rule === 'apart' ? { minDistance: change.least } : { excluded: change.excluded };
    const outcome = await tryOne({ ...of, luminaires: { ...luminaires, ...eased } });
    return outcome?.met ? outcome.layout : null;
  };
  const tried: EasedRule[][] = [];
  if (luminaires.minDistance > 0)
    tried.push(shorterThan(luminaires.minDistance).map((least) => ({ rule: 'apart', least })));
  if (withoutAreas) tried.push([{ rule: 'places', excluded: withoutAreas }]);
  for (const changes of tried) {
    const way = await firstThatDoes(changes, under);
    if (way) ways.push(way);
  }
  return ways;
}

type LayoutFor = (asked: Intentions) => Promise<Layout | null>;

function withConstraints(of: Intentions, keep: (constraint: Constraint, i: number) => boolean): Intentions {
  return { ...of, constraints: of.constraints.filter(keep) };
}

/** The same with a guarantee that is asked of every patch. */
function byPatches(of: Intentions, guarantee: number): Intentions {
  const constraints = of.constraints.map((constraint, i): Constraint => {
    if (i !== guarantee) return constraint;
    const { alpha: _, ...rest } = constraint;
    return { ...rest, statistic: rest.max === undefined ? 'minimum' : 'maximum' };
  });
  return { ...of, constraints };
}

/** The same with other bounds on some constraints. */
function withBounds(of: Intentions, eased: readonly EasedBound[]): Intentions {
  const constraints = of.constraints.flatMap((constraint, i): Constraint[] => {
    const change = eased.find((each) => each.constraint === i);
    if (!change) return [constraint];
    if (change.bound === null) return [];
    return [{ ...constraint, [endOf(constraint)]: change.bound }];
  });
  return { ...of, constraints };
}

/** A card's bound is one end of a constraint. */
const endOf = ({ max }: Constraint): 'min' | 'max' => (max === undefined ? 'min' : 'max');

const boundOf = (constraint: Constraint): number => constraint[endOf(constraint)] ?? 0;

/** The round number nearest to what is asked with which everything is met. */
async function easedAlone(
  of: Intentions,
  constraint: number,
  reached: number,
  layoutFor: LayoutFor,
): Promise<Way<EasedBound> | null> {
  const asked = of.constraints[constraint];
  if (!asked) return null;
  const steps = roundSteps(boundOf(asked), endOf(asked), isRatio(asked.statistic), reached);
  const changes = [...steps, null].map((bound): EasedBound => ({ constraint, bound }));
  return firstThatDoes(changes, (change) => layoutFor(withBounds(of, [change])));
}

/** With more of everything every lower bound on light is lifted; light alone can be what is missing. */
async function moreFlux(
  of: Intentions,
  conflict: readonly number[],
  layoutFor: LayoutFor,
): Promise<Way<number> | null> {
  const isOfLight = (constraint: Constraint | undefined) =>
    constraint?.min !== undefined && ['mean', 'chebyshev', 'minimum'].includes(constraint.statistic);
  const { luminaires } = of;
  if (
    !isOfSquares(luminaires) ||
    conflict.length === 0 ||
    !conflict.every((i) => isOfLight(of.constraints[i]))
  )
    return null;
  return firstThatDoes(roundFlux(luminaires.flux), (flux) =>
    layoutFor({ ...of, luminaires: { ...luminaires, flux } }),
  );
}

/** All bounds that are missed, at round numbers just beyond what is reached. */
async function easedTogether(
  of: Intentions,
  broken: readonly number[],
  reached: readonly { readonly value: number }[],
  layoutFor: LayoutFor,
): Promise<Way<readonly EasedBound[]> | null> {
  const changes = [0, 1, 2, 4].map((beyond) =>
    broken.map((constraint): EasedBound => {
      const asked = of.constraints[constraint]!;
      const value = reached[constraint]?.value ?? Number.NaN;
      const steps = roundSteps(boundOf(asked), endOf(asked), isRatio(asked.statistic), value).filter(
        (step) => (endOf(asked) === 'min' ? step <= value : step >= value),
      );
      return { constraint, bound: steps[beyond] ?? null };
    }),
  );
  return firstThatDoes(changes, (change) => layoutFor(withBounds(of, change)));
}

/** The first of changes that ask for less and less with which everything is met, by halving. */
async function firstThatDoes<Change>(
  changes: readonly Change[],
  layoutOf: (change: Change) => Promise<Layout | null>,
): Promise<Way<Change> | null> {
  const at = async (index: number): Promise<Way<Change> | null> => {
    const change = changes[index];
    const layout = change === undefined ? null : await layoutOf(change);
    return layout && change !== undefined ? { change, layout } : null;
  };
  let [low, high] = [-1, changes.length - 1]; // low does not do, high does
  let best = await at(high);
  while (best && high - low > 1) {
    const middle = (low + high) >> 1;
    const way = await at(middle);
    if (way) [best, high] = [way, middle];
    else low = middle;
  }
  return best;
}

/**
 * From cards to what the core is asked: a verb is a goal, everything else on a card is a constraint. Each constraint
 * remembers the card and the bound it came from, so that a bound that cannot be met can be named and eased.
 */
import { isRatio } from './statistics.ts';
import type {
  Card,
  Constraint,
  FiatLuxDocument,
  Goal,
  Intentions,
  Luminaires,
  PlaneBounds,
  PlaneStatistic,
  Quantity,
  Verb,
} from './types.ts';

export type BoundField =
  | 'mean.min'
  | 'mean.max'
  | 'spread.min'
  | 'spread.max'
  | 'guarantee.min'
  | 'guarantee.max'
  | 'uniformity'
  | 'contrast'
  | PlaneField;

/** Of the mean of a plane's points, or of the least of them. */
export type PlaneField = `${PlaneStatistic}.${'min' | 'max' | 'least'}`;

export const planeStatistics = ['cylindrical', 'modelling', 'vertical'] as const;
const planeEnds = ['min', 'max', 'least'] as const;

/** The statistic and the end of a bound that is of planes. */
function planeField(field: BoundField): [PlaneStatistic, 'min' | 'max' | 'least'] | null {
  const [statistic, end] = field.split('.');
  return planeStatistics.some((each) => each === statistic)
    ? [statistic as PlaneStatistic, end as 'min' | 'max' | 'least']
    : null;
}

/** In which unit a bound is; null of a ratio. What is told of planes is always illuminance. */
export function quantityOfBound(field: BoundField, quantity: Quantity): Quantity | null {
  if (field === 'uniformity' || field === 'contrast') return null;
  const ofPlanes = planeField(field);
  if (!ofPlanes) return quantity;
  return isRatio(ofPlanes[0]) ? null : 'illuminance';
}

/** A bound that is missed by no more counts as met to a person: of the bound. */
export const metWithin = 0.001;

/** What is asked of every patch is met or not. */
export const isOfPatches = ({ statistic }: Pick<Constraint, 'statistic'>): boolean =>
  statistic === 'minimum' || statistic === 'maximum' || statistic === 'uniformity';

/** Whether a bound is the most that there may be. */
export const isUpper = (field: BoundField): boolean => field.endsWith('.max');

/** Where a constraint comes from: one field of one card, so that constraint i answers origins[i]. */
export interface Origin {
  readonly card: string;
  readonly field: BoundField;
}

export interface TracedIntentions {
  readonly intentions: Intentions;
  readonly goalCards: readonly (string | null)[]; // id of the card of each goal; null = saving power
  readonly origins: readonly Origin[];
}

export const keepTolerance = 0.1; // keep = mean within +-10 % of the one at the time of asking

const goalOfVerb: Record<Verb, Pick<Goal, 'statistic' | 'sense'> | null> = {
  illuminate: { statistic: 'mean', sense: 'max' },
  overshadow: { statistic: 'mean', sense: 'min' },
  homogenize: { statistic: 'sigma', sense: 'min' },
  vary: { statistic: 'sigma', sense: 'max' },
  keep: null,
};

// How much more the mean that is aimed at counts than the spread beside it: the spread decides among layouts near the aim.
const aimWeight = 10;

/**
 * What a card's verb asks for: an extreme; where a mean is aimed at, to come near to it, in the place of the most or the
 * least of it, and before the spread.
 */
function goalsOf(card: Card): Goal[] {
  const { verb, aim, weight } = card;
  const where = whereOf(card);
  const goal = goalOfVerb[verb];
  if (!goal || !(weight > 0)) return [];
  if (aim === undefined) return [{ ...goal, weight, ...where }];
  const near = { statistic: 'mean', sense: 'near', target: aim, ...where } as const;
  if (goal.statistic === 'mean') return [{ ...near, weight }];
  return [
    { ...near, weight: aimWeight * weight },
    { ...goal, weight, ...where },
  ];
}

/** The surfaces that a card speaks of, and of which light there. */
function whereOf({ surfaces, direct }: Card): Pick<Goal, 'surfaces' | 'quantity'> {
  return { surfaces, ...(direct && { quantity: 'direct' }) };
}

/** Whether any of them needs direct light apart. */
export function asksForDirect({ goals, constraints, quantity }: Intentions): boolean {
  return [quantity, ...[...goals, ...constraints].map((each) => each.quantity)].includes('direct');
}

/** One constraint a bound, in the order of the fields. A bound that asks for nothing (a mean of at least 0) is left out. */
function constraintsOf(card: Card): { field: BoundField; constraint: Constraint }[] {
  const { mean, spread, guarantee, uniformity, contrast } = card;
  const where = whereOf(card);
  const onGrid = card.onGrid && ({ on: 'grid' } as const);
  const list: { field: BoundField; constraint: Constraint }[] = [];
  const add = (field: BoundField, constraint: Omit<Constraint, 'surfaces'>) =>
    list.push({ field, constraint: { ...constraint, ...where } });
  if (mean?.min) add('mean.min', { statistic: 'mean', min: mean.min, ...onGrid });
  if (mean?.max !== undefined) add('mean.max', { statistic: 'mean', max: mean.max, ...onGrid });
  if (spread?.min) add('spread.min', { statistic: 'sigma', min: spread.min });
  if (spread?.max !== undefined) add('spread.max', { statistic: 'sigma', max: spread.max });
  if (guarantee) {
    const { by, alpha } = guarantee;
    const chebyshev = { statistic: 'chebyshev', alpha } as const;
    if (guarantee.min)
      add('guarantee.min', {
        ...(by === 'chebyshev' ? chebyshev : { statistic: 'minimum', ...onGrid }),
        min: guarantee.min,
      });
    if (guarantee.max !== undefined)
      add('guarantee.max', {
        ...(by === 'chebyshev' ? chebyshev : { statistic: 'maximum' }),
        max: guarantee.max,
      });
  }
  if (uniformity) add('uniformity', { statistic: 'uniformity', min: uniformity, ...onGrid });
  if (contrast?.min) add('contrast', { statistic: 'contrast', min: contrast.min, over: contrast.over });
  return [...list, ...planeConstraintsOf(card)];
}

/** Of the points of the measuring planes that a card is on. */
function planeConstraintsOf(card: Card): { field: BoundField; constraint: Constraint }[] {
  const { surfaces, vertical } = card;
  return planeStatistics.flatMap((statistic) => {
    const bounds = card[statistic];
    const direction = statistic === 'vertical' && vertical ? { direction: vertical.direction } : {};
    return planeEnds.flatMap((end) => {
      const value = bounds?.[end];
      if (value === undefined || (end !== 'max' && value === 0)) return [];
      const bound = end === 'max' ? { max: value } : { min: value };
      const constraint: Constraint = {
        statistic,
        surfaces,
        ...bound,
        ...(end === 'least' && { of: 'minimum' }),
        ...direction,
      };
      return [{ field: `${statistic}.${end}` as const, constraint }];
    });
  });
}

/** What must be known of which measuring planes: their statistics, whatever the bounds. */
export function planesAskedOf({ constraints }: Intentions): readonly unknown[] {
  return constraints
    .filter(({ statistic }) => planeStatistics.some((each) => each === statistic))
    .map(({ statistic, surfaces, direction }) => [statistic, surfaces, direction ?? null]);
}

/** All that is bounded, in the order in which the solver answers: glare stands after all others. */
export function boundedBy({ constraints, glare }: Intentions): readonly Constraint[] {
  const ugr = glare?.max === undefined ? [] : [{ statistic: 'ugr', max: glare.max, surfaces: [] } as const];
  return [...constraints, ...ugr];
}

export function intentionsOf(document: FiatLuxDocument): TracedIntentions {
  const goals: Goal[] = [];
  const goalCards: (string | null)[] = [];
  const constraints: Constraint[] = [];
  const origins: Origin[] = [];
  for (const card of document.cards) {
    for (const goal of goalsOf(card)) {
      goals.push(goal);
      goalCards.push(card.id);
    }
    for (const { field, constraint } of constraintsOf(card)) {
      constraints.push(constraint);
      origins.push({ card: card.id, field });
    }
  }
  if (document.saving) {
    goals.push({ statistic: 'power', sense: 'min', weight: 1, surfaces: [] });
    goalCards.push(null);
  }
  const { quantity } = document;
  const luminaires = askedLuminaires(document);
  const { glare, paint, taskAreas } = document;
  const beside = {
    ...(glare && { glare }),
    ...(paint?.length && { paint }),
    ...(taskAreas && { taskAreas }),
  };
  const intentions = { luminaires, goals, constraints, quantity, ...beside };
  return { intentions, goalCards, origins };
}

/** The same for luminaires that may not hang on these sites. */
export function withExcluded(traced: TracedIntentions, excluded: readonly number[]): TracedIntentions {
  const { intentions } = traced;
  if (intentions.luminaires.excluded === excluded) return traced;
  return { ...traced, intentions: { ...intentions, luminaires: { ...intentions.luminaires, excluded } } };
}

/** Least power of luminaires that cannot be dimmed means fewer of them, where their number is not free anyway. */
export function savesByCount({
  saving,
  luminaires,
}: Pick<FiatLuxDocument, 'saving' | 'luminaires'>): boolean {
  return saving && luminaires.most === undefined && luminaires.dimming[0] === luminaires.dimming[1];
}

function askedLuminaires(document: FiatLuxDocument): Luminaires {
  const { luminaires } = document;
  const { count, most, pinned } = luminaires;
  if (savesByCount(document)) return { ...luminaires, count: Math.max(1, pinned.length), most: count };
  return most === undefined || most >= count ? luminaires : { ...luminaires, most: count };
}

/** The range that Keep asks for, from the mean that is there now; its ends have three digits, rounded towards the mean. */
export function keepRange(mean: number): { min: number; max: number } {
  return {
    min: toThreeDigits(mean * (1 - keepTolerance), Math.ceil),
    max: toThreeDigits(mean * (1 + keepTolerance), Math.floor),
  };
}

function toThreeDigits(value: number, round: typeof Math.ceil): number {
  if (!(value > 0)) return 0;
  const unit = 10 ** (Math.floor(Math.log10(value)) - 2);
  // What is round but for the last bits of a double stays what it is.
  const exact = Number((value / unit).toPrecision(12));
  return Number((round(exact) * unit).toPrecision(3));
}

/** The bound that a field of a card holds, if any. */
export function boundOf(card: Card, field: BoundField): number | undefined {
  const ofPlanes = planeField(field);
  if (ofPlanes) return card[ofPlanes[0]]?.[ofPlanes[1]];
  switch (field as Exclude<BoundField, PlaneField>) {
    case 'mean.min':
      return card.mean?.min;
    case 'mean.max':
      return card.mean?.max;
    case 'spread.min':
      return card.spread?.min;
    case 'spread.max':
      return card.spread?.max;
    case 'guarantee.min':
      return card.guarantee?.min;
    case 'guarantee.max':
      return card.guarantee?.max;
    case 'uniformity':
      return card.uniformity;
    case 'contrast':
      return card.contrast?.min;
  }
}

type Range = { min?: number; max?: number };

/** The range with one end set; an end of `undefined` is removed, and so is a range without ends. */
function withEnd(range: Range | undefined, end: 'min' | 'max', value: number | undefined): Range | undefined {
  const { [end]: _, ...rest } = range ?? {};
  const next: Range = value === undefined ? rest : { ...rest, [end]: value };
  return next.min === undefined && next.max === undefined ? undefined : next;
}

/** The card with a field set to `value` (undefined = no such bound). */
export function withBound(card: Card, field: BoundField, value: number | undefined): Card {
  const ofPlanes = planeField(field);
  if (ofPlanes) return withPlaneBound(card, ...ofPlanes, value);
  switch (field as Exclude<BoundField, PlaneField>) {
    case 'mean.min':
    case 'mean.max':
      return withOptional(card, 'mean', withEnd(card.mean, field === 'mean.min' ? 'min' : 'max', value));
    case 'spread.min':
    case 'spread.max':
      return withOptional(
        card,
        'spread',
        withEnd(card.spread, field === 'spread.min' ? 'min' : 'max', value),
      );
    case 'guarantee.min':
    case 'guarantee.max': {
      const { by = 'chebyshev', alpha = 2 } = card.guarantee ?? {};
      const range = withEnd(
        card.guarantee && endsOf(card.guarantee),
        field === 'guarantee.min' ? 'min' : 'max',
        value,
      );
      return withOptional(card, 'guarantee', range && { by, alpha, ...range });
    }
    case 'uniformity':
      return withOptional(card, 'uniformity', value);
    case 'contrast':
      return value === undefined || !card.contrast
        ? withOptional(card, 'contrast', undefined)
        : { ...card, contrast: { ...card.contrast, min: value } };
  }
}

/** Without any end the statistic is no longer asked for. */
function withPlaneBound(
  card: Card,
  statistic: PlaneStatistic,
  end: 'min' | 'max' | 'least',
  value: number | undefined,
): Card {
  const { [end]: _, ...rest }: PlaneBounds = card[statistic] ?? {};
  const next: PlaneBounds = value === undefined ? rest : { ...rest, [end]: value };
  const isEmpty = planeEnds.every((each) => next[each] === undefined);
  return withOptional(card, statistic, isEmpty ? undefined : (next as NonNullable<Card['vertical']>));
}

function endsOf({ min, max }: { min?: number; max?: number }): Range {
  return { ...(min !== undefined && { min }), ...(max !== undefined && { max }) };
}

/** The statistics of which a card may bound both ends. */
const ranges = ['mean', 'spread', 'guarantee', ...planeStatistics] as const;
export type RangeName = (typeof ranges)[number];

/** The ends of a range whose least is above its most, as a person may ask and no layout can meet; null where it is not so. */
export function crossedEnds(card: Card, range: RangeName): { min: number; max: number } | null {
  const [min, max] = [boundOf(card, `${range}.min`), boundOf(card, `${range}.max`)];
  return min !== undefined && max !== undefined && min > max ? { min, max } : null;
}

/** A value for an end of a range that is dragged: it stops at the other end. */
export function upToOther(card: Card, field: BoundField, value: number): number {
  const [group, end] = field.split('.');
  if (end === 'min') return Math.min(value, boundOf(card, `${group}.max` as BoundField) ?? Infinity);
  return end === 'max' ? Math.max(value, boundOf(card, `${group}.min` as BoundField) ?? 0) : value;
}

/** Sets an optional property of a card, or takes it away (never stores `undefined`). */
export function withOptional<
  Key extends 'aim' | 'mean' | 'spread' | 'guarantee' | 'uniformity' | 'contrast' | 'direct' | PlaneStatistic,
>(card: Card, key: Key, value: Card[Key] | undefined): Card {
  const { [key]: _, ...rest } = card;
  return (value === undefined ? rest : { ...rest, [key]: value }) as Card;
}

/** Whether no type may be used: luminaires are plain squares of light then. */
export const isOfSquares = ({ types }: Luminaires): boolean => !types?.some(({ isAllowed }) => isAllowed);

/** How many luminaires the types that may be used allow together; null where luminaires are squares of light. */
export function typeLimits(luminaires: Luminaires): readonly [least: number, most: number] | null {
  if (isOfSquares(luminaires)) return null;
  const used = (luminaires.types ?? []).filter(({ isAllowed }) => isAllowed);
  const sum = (end: 0 | 1) => used.reduce((all, { count }) => all + count[end], 0);
  return [sum(0), sum(1)];
}

/** Which paint helps most with what is asked, in words. */
import { boundedBy, planeStatistics, type TracedIntentions } from '../../document/intentions.ts';
import { isPaintable, leastPaint, mostPaint } from '../../document/paint.ts';
import { isRatio } from '../../document/statistics.ts';
import type { Constraint, Goal, Intentions, Quantity, SceneInfo, Statistic } from '../../document/types.ts';
import type { PaintGain, Shown } from '../../solver/protocol.ts';
import { words } from '../../language/language.ts';
import { fixed } from '../../language/numbers.ts';
import { compact, percent, unitOf } from './format.ts';
import { placesText } from './places.ts';

const told = 0.1; // of reflectance, that gains are told for
const worthTelling = 1e-3; // of the value
const reached = 0.005; // of a mean that is aimed at: nothing helps with what is there
const most = 6; // lines

/** One goal, or one bound that is missed. */
export interface Wish {
  readonly of: 'goals' | 'constraints';
  readonly index: number;
  readonly statistic: Statistic;
  readonly isDistance: boolean; // from a mean that is aimed at, as a share of it
  readonly value: number; // as it stands
  readonly sign: 1 | -1; // whether more of it is wanted, or less
  readonly text: string;
}

export interface GainLine {
  readonly surface: number; // leaf
  readonly name: string;
  readonly isLighter: boolean; // or darker
  readonly text: string; // "+12 lx"
  readonly share: number; // of the largest gain
}

type Asked = Pick<Constraint, 'statistic' | 'quantity'>;

const isOfPlanes = (statistic: Statistic) => planeStatistics.some((each) => each === statistic);

/** Whether it is of light that nothing has reflected: no paint changes that. */
const isOfDirect = ({ statistic, quantity }: Asked, of: Quantity) =>
  (quantity ?? of) === 'direct' && !['power', 'ugr'].includes(statistic) && !isOfPlanes(statistic);

/** Whether something is asked of direct light. */
export const asksBeyondPaint = ({ quantity, goals, constraints }: Intentions): boolean =>
  [...goals, ...constraints].some((each) => isOfDirect(each, quantity));

/**
 * What is asked above all: the bound that is missed most, of the opened card where it misses one; where none is missed the
 * goal of the opened card, or the first one, but no aim that is reached. null: nothing that paint could help.
 */
export function activeWish(
  { intentions, goalCards, origins }: TracedIntentions,
  shown: Shown,
  card: string | null,
): Wish | null {
  const canHelp = (asked: Asked) => asked.statistic !== 'power' && !isOfDirect(asked, intentions.quantity);
  const bounds = boundedBy(intentions);
  const missed = shown.constraints
    .map((result, index) => ({ result, index, asked: bounds[index] }))
    .filter(({ result, asked }) => !result.met && asked && canHelp(asked))
    .sort((a, b) => b.result.violation - a.result.violation);
  const bound = missed.find(({ index }) => origins[index]?.card === card) ?? missed[0];
  if (bound?.asked) return ofBound(bound.asked, bound.index, bound.result.value);
  const goals = intentions.goals.map((goal, index) => ({ goal, index }));
  const reachable = goals.filter(({ goal, index }) => {
    const isReached = goal.sense === 'near' && (shown.goals[index]?.value ?? 0) < reached;
    return canHelp(goal) && !isReached;
  });
  const own = reachable.find(({ index }) => goalCards[index] === card) ?? reachable[0];
  return own ? ofGoal(own.goal, own.index, shown.goals[own.index]?.value ?? 0) : null;
}

function ofBound(asked: Constraint, index: number, value: number): Wish {
  const isTooLow = asked.min !== undefined && value < asked.min;
  const { more, less, lessGlare } = words.value.paint;
  const { statistics } = words.value.intentions;
  const ofPlace = () => (isTooLow ? more : less)(statistics[asked.statistic], placesText(asked.surfaces));
  const text = asked.statistic === 'ugr' ? lessGlare : ofPlace();
  return {
    of: 'constraints',
    index,
    statistic: asked.statistic,
    isDistance: false,
    value,
    sign: isTooLow ? 1 : -1,
    text,
  };
}

function ofGoal({ statistic, sense, surfaces, target }: Goal, index: number, value: number): Wish {
  const where = placesText(surfaces);
  const { more, less, about } = words.value.paint;
  const { statistics } = words.value.intentions;
  const text = {
    max: more(statistics[statistic], where),
    min: less(statistics[statistic], where),
    near: about(compact(target ?? 0), where),
  }[sense];
  const isDistance = sense === 'near';
  return { of: 'goals', index, statistic, isDistance, value, sign: sense === 'max' ? 1 : -1, text };
}

/** The surfaces whose paint helps most with a wish, the best one first; `room` as it is painted. */
export function gainLines(
  gains: readonly PaintGain[],
  wish: Wish,
  room: SceneInfo,
  quantity: Quantity,
): GainLine[] {
  const scale = wish.isDistance ? 1 : Math.abs(wish.value);
  const helpful = gains.flatMap(({ surface, [wish.of]: gained }) => {
    const change = gained[wish.index] ?? 0;
    const leaf = room.surfaces[surface];
    const isLighter = change * wish.sign > 0;
    const roomLeft = leaf && (isLighter ? mostPaint - leaf.reflectance : leaf.reflectance - leastPaint);
    const isThere = leaf && isPaintable(leaf) && Math.abs(change) > worthTelling * scale;
    return isThere && (roomLeft ?? 0) > told / 10 ? [{ surface, name: leaf.name, isLighter, change }] : [];
  });
  helpful.sort((a, b) => Math.abs(b.change) - Math.abs(a.change));
  const largest = Math.abs(helpful[0]?.change ?? 1);
  return helpful.slice(0, most).map(({ change, ...line }) => ({
    ...line,
    text: changeText(line.isLighter ? change : -change, wish, quantity),
    share: Math.abs(change) / largest,
  }));
}

function changeText(change: number, { statistic, isDistance }: Wish, quantity: Quantity): string {
  const sign = change > 0 ? '+' : '−';
  const amount = Math.abs(change);
  if (isDistance) return words.value.paint.nearer(percent(amount));
  if (isRatio(statistic)) return `${sign}${fixed(amount, 3)}`;
  if (statistic === 'ugr') return `${sign}${fixed(amount, 2)} UGR`;
  return `${sign}${compact(amount)} ${unitOf(isOfPlanes(statistic) ? 'illuminance' : quantity)}`;
}

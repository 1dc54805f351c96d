/**
 * A layout placed by hand against the solver's for the same intentions. 100 is the solver's: of every goal the share of its
 * value that is reached (of a target: how much nearer or farther), weighed as the intentions weigh them; what bounds are
 * missed by more than the solver misses them is taken off.
 */
import type { Goal } from '../../document/types.ts';
import type { Shown } from '../../solver/protocol.ts';
import { words } from '../../language/language.ts';

type Reached = Pick<Shown, 'goals' | 'constraints' | 'violation'>;

export interface Best {
  readonly shown: Reached;
  readonly gap: number | null; // no layout is better than it by more than this share, proved; null: nothing is proved
}

const most = 2; // times the solver's value of one goal
const alike = 0.5; // points
const tiny = 1e-6;

/** Of one goal, 1 = as good as the solver. */
function shareOf({ sense, target }: Goal, value: number, best: number): number {
  if (target !== undefined || sense === 'near') return Math.max(0, 1 - (value - best));
  const [above, below] = sense === 'max' ? [value, best] : [best, value];
  if (below <= tiny) return above <= tiny ? 1 : most;
  return Math.min(most, above / below);
}

export function scoreOf(goals: readonly Goal[], own: Reached, { shown: best }: Best): number {
  const weight = goals.reduce((sum, goal) => sum + goal.weight, 0);
  const reached = goals.reduce(
    (sum, goal, i) => sum + goal.weight * shareOf(goal, own.goals[i]?.value ?? 0, best.goals[i]?.value ?? 0),
    0,
  );
  const missed = Math.max(0, own.violation - best.violation);
  return 100 * (weight > 0 ? reached / weight : 1) * Math.max(0, 1 - missed);
}

/** The score that no layout can pass, where that is proved; only of a single goal is the gap one of the score. */
export function highestScore(goals: readonly Goal[], { shown, gap }: Best): number | null {
  const [goal] = goals;
  if (goals.length !== 1 || !goal || gap === null || shown.violation > tiny) return null;
  if (goal.sense === 'max') return 100 * (1 + gap);
  return goal.sense === 'min' && gap < 1 ? 100 / (1 - gap) : null;
}

/** One sentence: how the two layouts compare. */
export function outcomeText(score: number, own: Reached, { shown: best }: Best): string {
  const unmet = own.constraints.filter(({ met }) => !met).length;
  if (unmet > 0 && best.violation <= tiny)
    return words.value.comparing.score.unmet(words.value.values.bounds(unmet));
  if (unmet > 0 && own.violation > best.violation + tiny) return words.value.comparing.score.worse;
  if (unmet > 0 && own.violation < best.violation - tiny) return words.value.comparing.score.nearer;
  if (unmet === 0 && best.violation > tiny) return words.value.comparing.score.meets;
  if (score > 100 + alike) return words.value.comparing.score.beaten;
  if (score >= 100 - alike) return words.value.comparing.score.equal;
  return words.value.comparing.score.better(words.value.values.points(Math.round(100 - score)));
}

/** One sentence: how good any layout could be. */
export function boundText(goals: readonly Goal[], best: Best): string {
  const highest = highestScore(goals, best);
  if (highest !== null) return words.value.comparing.score.above(Math.ceil(highest - tiny));
  if (best.gap === null || best.shown.violation > tiny) return words.value.comparing.score.unproved;
  const gap = Math.ceil(100 * best.gap - tiny);
  return words.value.comparing.score.gap(gap);
}

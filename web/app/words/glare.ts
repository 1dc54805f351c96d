/** What glares for whom, as a row of the verdict and as the worst of all. */
import type { ObserverResult } from '../../solver/protocol.ts';
import type { Verdict } from './verdict.ts';
import { observerText } from './places.ts';
import { words } from '../../language/language.ts';

const rank = ({ ugr }: ObserverResult) => ugr ?? -Infinity;

/** The worst first. */
export const byGlare = (observers: readonly ObserverResult[]): ObserverResult[] =>
  [...observers].sort((a, b) => rank(b) - rank(a));

export const worstOf = (observers: readonly ObserverResult[]): ObserverResult | null =>
  byGlare(observers)[0] ?? null;

const margin = 0.05; // what is shown as the limit is within it

/** `observers` are none where the room's file cannot tell what glares. */
export function glareVerdict(observers: readonly ObserverResult[], target: number): Verdict {
  const worst = worstOf(observers);
  const actual = worst && (worst.ugr ?? 0);
  return {
    where: worst ? observerText(worst.name) : words.value.results.places.task,
    what: words.value.values.glareMost,
    target,
    actual,
    unit: 'UGR',
    isMost: true,
    margin: null,
    met: actual === null ? null : actual < target + margin,
    alone: { ugr: target },
  };
}

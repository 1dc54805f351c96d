/** How many luminaires: what each number would cost, and whether it meets every bound. A click takes the number. */
import { useLayoutEffect, useRef } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { fewestMet, knownOf, withCount } from '../../app/comparing.ts';
import { wattsOf } from '../../app/state/power.ts';
import type { Comparison } from '../../app/state/store.ts';
import { typeLimits } from '../../document/intentions.ts';
import { typesRuleOut } from '../../document/ties.ts';
import { mostLuminaires } from '../../document/schema.ts';
import type { Intentions } from '../../document/types.ts';
import { compact } from '../../app/words/format.ts';
import { numbersOf } from './other-ways.tsx';
import { words } from '../../language/language.ts';

export function CountStrip() {
  const { store } = useApp();
  const strip = useRef<HTMLDivElement>(null);
  const shown = store.shown.value?.layout.sites.length;
  const isThere = (store.comparison.value?.counts.length ?? 0) > 1;
  useLayoutEffect(() => centre(strip.current), [shown, isThere]);
  const comparison = knownOf(store);
  if (!comparison) return null;
  const { pinned, types } = store.document.value.luminaires;
  if (pinned.length > 0 && !comparison.counts.some(({ count, outcome }) => outcome && count !== shown))
    return <p class="field-note">{words.value.luminaires.counts.pinned}</p>;
  if (comparison.counts.length < 2) return null;
  const isCurrent = comparison.of === store.traced.value.intentions;
  const isBounded = hasBounds(store.traced.value.intentions);
  // From the layout shown, so that those that stay keep their numbers: trials were made one from the other.
  const take = (count: number) =>
    store.edit(words.value.steps.count, ({ luminaires }) => {
      luminaires.count = count;
      delete luminaires.most;
    });
  const { counts, arrangement } = words.value.luminaires;
  const limits = typeLimits(comparison.of.luminaires);
  const isOutside = (count: number) => limits !== null && (count < limits[0] || count > limits[1]);
  return (
    <div class="field count-strip" data-current={isCurrent}>
      <div ref={strip} class="strip" role="group" aria-label={words.value.luminaires.counts.name}>
        {comparison.counts.map(({ count, outcome }) => {
          const watts = outcome && compact(wattsOf(outcome.layout, store.efficacy.value, types));
          const isRuledOut = typesRuleOut(withCount(comparison.of, count).luminaires);
          const why = isRuledOut ? counts.typesLimits : arrangement.noRoom;
          const cost = watts === null ? why : `${watts} W`;
          const judged = outcome && isBounded ? counts[outcome.met ? 'allMet' : 'notMet'](cost) : cost;
          return (
            <button
              key={count}
              class={outcome?.met && isBounded ? 'met' : 'unmet'}
              data-watts={watts ?? ''}
              aria-pressed={count === shown}
              aria-label={counts.of(count, judged)}
              title={counts.tip(count, judged)}
              onClick={() => take(count)}
            >
              <i style={{ height: `${heightOf(comparison, outcome?.lumens ?? 0)}px` }} />
              <span>{count}</span>
            </button>
          );
        })}
      </div>
      <p class="fine-print">{isBounded ? counts.key : counts.keyOfWatts}</p>
      {limits && comparison.counts.some(({ count }) => isOutside(count)) && (
        <p class="field-note">{counts.typesAllow(limitsText(limits))}</p>
      )}
      {isBounded ? (
        <Fewest comparison={comparison} take={take} />
      ) : (
        <p class="field-note">{words.value.luminaires.counts.noBounds}</p>
      )}
    </div>
  );
}

/** "11", "5–11"; "5 or more" where no type has a most. */
function limitsText([least, most]: readonly [number, number]): string {
  const { orMore } = words.value.luminaires.counts;
  return most >= mostLuminaires ? orMore(least) : numbersOf({ count: least, most });
}

/** Whether there is anything that a number of luminaires could miss. */
const hasBounds = ({ constraints, glare }: Intentions) => constraints.length > 0 || glare?.max !== undefined;

/** What is shown stands in the middle of what is in view. */
function centre(strip: HTMLElement | null): void {
  const pressed = strip?.querySelector<HTMLElement>('[aria-pressed="true"]');
  if (!strip || !pressed) return;
  const [all, one] = [strip.getBoundingClientRect(), pressed.getBoundingClientRect()];
  strip.scrollLeft += one.left + one.width / 2 - all.left - all.width / 2;
}

const tallest = 34; // px

function heightOf({ counts }: Comparison, lumens: number): number {
  const most = Math.max(...counts.map(({ outcome }) => outcome?.lumens ?? 0), 1);
  return 3 + Math.round((tallest * lumens) / most);
}

function Fewest({ comparison, take }: { comparison: Comparison; take: (count: number) => void }) {
  const { store } = useApp();
  const fewest = fewestMet(comparison);
  const { types } = store.document.value.luminaires;
  const cheapest = comparison.counts.reduce<{ count: number; watts: number } | null>(
    (best, { count, outcome }) => {
      if (!outcome?.met) return best;
      const watts = wattsOf(outcome.layout, store.efficacy.value, types);
      return !best || watts < best.watts - 0.01 ? { count, watts } : best;
    },
    null,
  );
  if (fewest === null || !cheapest) {
    const latest = store.isOfBefore.value ? null : store.shown.value;
    const { none, noneButShown } = words.value.luminaires.counts;
    return (
      <p class="field-note">
        {latest?.constraints.every(({ met }) => met) ? noneButShown(latest.layout.sites.length) : none}
      </p>
    );
  }
  return (
    <div class="row">
      <button class="button small" onClick={() => take(fewest)}>
        {words.value.luminaires.counts.fewest(fewest)}
      </button>
      {cheapest.count !== fewest && (
        <button class="button small" onClick={() => take(cheapest.count)}>
          {words.value.luminaires.counts.cheapest(cheapest.count, compact(cheapest.watts))}
        </button>
      )}
    </div>
  );
}

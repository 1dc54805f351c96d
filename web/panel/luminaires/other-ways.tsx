/** Ways out of what cannot be met that lie with the luminaires: another arrangement, or more of them. Each was tried. */
import { useApp } from '../../app/app.ts';
import { arrangementOf, fewestMet, rules } from '../../app/comparing.ts';
import type { Rule } from '../../document/types.ts';
import { costText } from './arrangement-choice.tsx';

const asWords: Record<Rule, string> = {
  free: 'a free layout',
  symmetric: 'a symmetric layout',
  rows: 'rows',
  field: 'a regular field',
};

/** Where it is the arrangement that stands in the way: which others would do, and what each costs. */
export function RulesFirst() {
  const { store } = useApp();
  const comparison = store.comparison.value;
  const { luminaires } = store.document.value;
  const asked = luminaires.arrangement?.rule ?? 'free';
  if (asked === 'free' || comparison?.of !== store.traced.value.intentions) return null;
  const others = rules.flatMap((rule) => {
    const outcome = comparison.rules.find((each) => each.rule === rule)?.outcome;
    return rule !== asked && outcome?.met ? [{ rule, outcome }] : [];
  });
  if (others.length === 0) return null;
  const choose = (rule: Rule) =>
    store.edit('Change the arrangement', (draft) => {
      if (rule === 'free') delete draft.luminaires.arrangement;
      else draft.luminaires.arrangement = { ...arrangementOf(rule, luminaires) };
    });
  return (
    <div class="rules-first">
      <p>
        Not as {asWords[asked]} of {luminaires.count}. All is met as:
      </p>
      <div class="row">
        {others.map(({ rule, outcome }) => (
          <button key={rule} class="button small" onClick={() => choose(rule)}>
            {asWords[rule].replace(/^a /, '')}, {costText(outcome, store.efficacy.value)}
          </button>
        ))}
      </div>
    </div>
  );
}

/** "3 more luminaires", where so many were found to do. */
export function MoreLuminaires() {
  const { store } = useApp();
  const comparison = store.comparison.value;
  const { count, most = count } = store.document.value.luminaires;
  if (comparison?.of !== store.traced.value.intentions) return null;
  const fewest = fewestMet({ counts: comparison.counts.filter((each) => each.count > most) });
  if (fewest === null) return null;
  const more = fewest - most;
  const add = () =>
    store.edit('Add luminaires', ({ luminaires }) => {
      if (luminaires.most === undefined) luminaires.count = fewest;
      else luminaires.most = fewest;
    });
  return (
    <button class="button small" onClick={add}>
      Or {more} more {more === 1 ? 'luminaire' : 'luminaires'}
    </button>
  );
}

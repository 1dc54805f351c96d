/** Ways out of what cannot be met that lie with the luminaires: another arrangement, or more of them. Each was tried. */
import { useApp } from '../../app/app.ts';
import { countFound, fewestMet, fromFound, isTrial, rules } from '../../app/comparing.ts';
import type { RuleWay } from '../../app/relief.ts';
import { shortest } from '../../language/numbers.ts';
import { costText } from './arrangement-choice.tsx';
import { words } from '../../language/language.ts';

/** Where it is the arrangement that stands in the way: which others would do, and what each costs. */
export function RulesFirst() {
  const { store, comparing } = useApp();
  const comparison = store.comparison.value;
  const { luminaires } = store.traced.value.intentions;
  const asked = luminaires.arrangement?.rule ?? 'free';
  if (asked === 'free' || comparison?.of !== store.traced.value.intentions) return null;
  const others = rules.flatMap((rule) => {
    const outcome = comparison.rules.find((each) => each.rule === rule)?.outcome;
    return rule !== asked && outcome?.met ? [{ rule, outcome }] : [];
  });
  if (others.length === 0) return null;
  return (
    <div class="rules-first">
      <p>
        {words.value.luminaires.arrangement.notAs(
          words.value.luminaires.arrangement.asked[asked],
          numbersOf(store.document.value.luminaires),
        )}
      </p>
      <div class="row">
        {others.map(({ rule, outcome }) => (
          <button key={rule} class="button small" onClick={() => void comparing.choose(rule)}>
            {words.value.luminaires.arrangement.met[rule]}, {costText(outcome, store, isTrial(rule, asked))}
          </button>
        ))}
      </div>
    </div>
  );
}

/** "15", or "15–30" where the number is a range: none of these is enough. */
export const numbersOf = ({
  count,
  most = count,
}: {
  readonly count: number;
  readonly most?: number;
}): string => (most > count ? `${count}–${most}` : `${count}`);

/** Where it is the distance or the areas in plan: what of them would do, and what that costs. */
export function EasedRules({ rules: ways }: { rules: readonly RuleWay[] }) {
  const { store } = useApp();
  const { minDistance } = store.document.value.luminaires;
  const say = words.value.luminaires.arrangement;
  const take = ({ change, layout }: RuleWay) =>
    store.edit(
      change.rule === 'apart' ? words.value.steps.distance : words.value.steps.area,
      ({ luminaires }) => {
        if (change.rule === 'apart') luminaires.minDistance = change.least;
        else delete luminaires.areas;
      },
      null,
      { by: 'search', from: layout },
    );
  return (
    <>
      {ways.map((way) => (
        <div key={way.change.rule} class="rules-first">
          <p>{way.change.rule === 'apart' ? say.notApart(shortest(minDistance)) : say.notWithin}</p>
          <div class="row">
            <button class="button small" onClick={() => take(way)}>
              {way.change.rule === 'apart' ? say.apartBy(shortest(way.change.least)) : say.anywhere},{' '}
              {costText({ met: true, layout: way.layout }, store)}
            </button>
          </div>
        </div>
      ))}
    </>
  );
}

/** "3 more luminaires", or up to so many where their number is a range, where so many were found to do. */
export function MoreLuminaires() {
  const { store } = useApp();
  const comparison = store.comparison.value;
  const { count, most = count } = store.document.value.luminaires;
  const { arrangement } = words.value.luminaires;
  if (comparison?.of !== store.traced.value.intentions) return null;
  const counts = [...comparison.counts, ...comparison.beyond].filter((each) => each.count > most);
  const fewest = fewestMet({ counts });
  if (fewest === null) return null;
  const add = () =>
    store.edit(
      words.value.steps.addLuminaires,
      ({ luminaires }) => {
        if (luminaires.most === undefined) luminaires.count = fewest;
        else luminaires.most = fewest;
      },
      null,
      fromFound(countFound(counts, fewest)),
    );
  return (
    <button class="button small" onClick={add}>
      {most > count ? arrangement.upTo(fewest) : arrangement.more(fewest - most)}
    </button>
  );
}

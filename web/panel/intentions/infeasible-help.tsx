/** When no layout meets the intentions: which bounds conflict, and round numbers that were seen to do, one click each. */
import { TriangleAlert } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import type { EasedBound, Relief, Way } from '../../app/relief.ts';
import { conflicting, easedCards, fieldText, type Conflicting } from '../../app/words/explain.ts';
import { compact, unitOfBound } from '../../app/words/format.ts';
import { EasedRules, MoreLuminaires, RulesFirst } from '../luminaires/other-ways.tsx';
import { namesText } from '../../app/words/places.ts';
import { words } from '../../language/language.ts';
import { shortest } from '../../language/numbers.ts';

/** What is reached, with as many digits as tell it from what is asked. */
function apart(reached: number, asked: number): string {
  return compact(reached) === compact(asked) ? shortest(Number(reached.toPrecision(6))) : compact(reached);
}

export function InfeasibleHelp() {
  const { store } = useApp();
  const shown = store.shown.value;
  const { state } = store.progress.value;
  if (!shown || shown.violation === 0 || state === 'improving' || state === 'idle') return null;
  const missed = shown.constraints.filter(({ met }) => !met).length;
  if (missed === 0) return null;
  const relief = store.relief.value?.of === store.traced.value.intentions ? store.relief.value : null;
  const bounds = relief
    ? conflicting(store.document.value, store.traced.value.origins, shown.constraints, relief)
    : [];
  return (
    <section class="infeasible" aria-label={words.value.intentions.infeasible.name} aria-busy={!relief}>
      <h2>
        <TriangleAlert size={15} aria-hidden />
        {titleOf(bounds.length, missed, relief)}
      </h2>
      <RulesFirst />
      {relief && <EasedRules rules={relief.rules} />}
      {relief ? <Ways relief={relief} bounds={bounds} /> : <p>{words.value.intentions.infeasible.looking}</p>}
    </section>
  );
}

function titleOf(conflict: number, missed: number, relief: Relief | null): string {
  const say = words.value.intentions.infeasible;
  if (conflict === 0) return say.missed(words.value.values.bounds(missed));
  if (conflict === 1) return say.one;
  if (relief?.isCrossed) return say.crossed;
  return relief?.isEach ? say.each(conflict) : say.together(conflict);
}

function Ways({ relief, bounds }: { relief: Relief; bounds: readonly Conflicting[] }) {
  const app = useApp();
  const { store } = app;
  const { cards } = store.document.value;
  const { origins } = store.traced.value;
  const ease = (changes: readonly EasedBound[], { layout }: Way<unknown>) =>
    store.edit(
      words.value.steps.ease,
      (draft) => void (draft.cards = structuredClone(easedCards(cards, origins, changes)) as never),
      null,
      { by: 'search', from: layout },
    );
  const { flux, together } = relief;
  return (
    <>
      <ul>
        {bounds.slice(0, 4).map((bound) => (
          <Bound key={`${bound.card.id} ${bound.field}`} {...{ bound, relief, ease }} />
        ))}
      </ul>
      <div class="row">
        {together && (
          <button class="button small" onClick={() => ease(together.change, together)}>
            {words.value.intentions.infeasible.easeAll(together.change.length)}
          </button>
        )}
        {flux && (
          <button
            class="button small"
            onClick={() =>
              store.edit(
                words.value.steps.raiseFlux,
                (draft) => void (draft.luminaires.flux = flux.change),
                null,
                {
                  by: 'search',
                  from: flux.layout,
                },
              )
            }
          >
            {words.value.intentions.infeasible.orFlux(shortest(flux.change))}
          </button>
        )}
        <MoreLuminaires />
      </div>
    </>
  );
}

interface BoundProps {
  readonly bound: Conflicting;
  readonly relief: Relief;
  readonly ease: (changes: readonly EasedBound[], way: Way<unknown>) => void;
}

function Bound({ bound, relief, ease }: BoundProps) {
  const { store } = useApp();
  const { card, field, asked, reached, met, way } = bound;
  const suffix = ` ${unitOfBound(field, store.document.value.quantity)}`.trimEnd();
  const { origins } = store.traced.value;
  const everySpot = relief.patches.find(
    ({ change }) => origins[change]?.card === card.id && origins[change]?.field === field,
  );
  const takePatches = ({ layout }: Way<number>) =>
    store.edit(
      words.value.steps.patches,
      (draft) => {
        const guarantee = draft.cards.find(({ id }) => id === card.id)?.guarantee;
        if (guarantee) guarantee.by = 'patches';
      },
      null,
      { by: 'search', from: layout },
    );
  return (
    <li>
      <span>
        <strong>{namesText(card.surfaces)}</strong>: {fieldText(card, field)} {compact(asked)}
        {suffix},{' '}
        {met
          ? words.value.intentions.infeasible.atCost
          : words.value.intentions.infeasible.best(apart(reached, asked), suffix)}
      </span>
      <span class="row">
        {way && (
          <button class="button small" onClick={() => ease([way.change], way)}>
            {way.change.bound === null
              ? words.value.intentions.infeasible.drop
              : words.value.intentions.infeasible.ask(compact(way.change.bound), suffix)}
          </button>
        )}
        {everySpot && (
          <button class="button small" onClick={() => takePatches(everySpot)}>
            {words.value.intentions.infeasible.everySpot}
          </button>
        )}
      </span>
    </li>
  );
}

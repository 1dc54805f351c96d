/** When no layout meets the intentions: which bound binds, the smallest change that was found to do, one click to apply it. */
import { TriangleAlert } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import {
  bindingBounds,
  easedCards,
  fieldText,
  fluxThatWouldDo,
  type BindingBound,
} from '../../app/words/explain.ts';
import { isRatio } from '../../document/intentions.ts';
import { compact, grouped, unitOf } from '../../app/words/format.ts';
import { MoreLuminaires, RulesFirst } from '../luminaires/other-ways.tsx';
import { namesText } from './surface-picker.tsx';

/** What is reached, with as many digits as tell it from what is asked. */
function apart(reached: number, asked: number): string {
  return compact(reached) === compact(asked) ? String(Number(reached.toPrecision(6))) : compact(reached);
}

export function InfeasibleHelp() {
  const app = useApp();
  const { store } = app;
  const shown = store.shown.value;
  const { state } = store.progress.value;
  if (!shown || shown.violation === 0 || state === 'improving' || state === 'idle') return null;
  const document = store.document.value;
  const bounds = bindingBounds(document, store.traced.value.origins, shown.constraints);
  if (bounds.length === 0) return null;
  const flux = fluxThatWouldDo(document, bounds);
  const unit = unitOf(document.quantity);

  const ease = (some: readonly BindingBound[]) => {
    const cards = easedCards(document.cards, some);
    store.edit('Ease a bound', (draft) => void (draft.cards = structuredClone(cards) as never));
  };
  const byPatches = ({ card }: BindingBound) =>
    app.changeCard(card.id, 'Guarantee by the patches', (each) =>
      each.guarantee ? { ...each, guarantee: { ...each.guarantee, by: 'patches' } } : each,
    );
  const raise = () => {
    if (flux !== null) store.edit('Raise the flux', (draft) => void (draft.luminaires.flux = flux));
  };
  return (
    <section class="infeasible" aria-label="What cannot be met">
      <h2>
        <TriangleAlert size={15} aria-hidden />
        {bounds.length === 1 ? 'One bound cannot be met' : `${bounds.length} bounds cannot be met together`}
      </h2>
      <RulesFirst />
      <ul>
        {bounds.slice(0, 4).map((bound) => {
          const suffix = isRatio(bound.field) ? '' : ` ${unit}`;
          return (
            <li key={`${bound.card.id} ${bound.field}`}>
              <span>
                <strong>{namesText(bound.card.surfaces)}</strong>: {fieldText(bound.card, bound.field)}{' '}
                {compact(bound.asked)}
                {suffix}, the best found has {apart(bound.reached, bound.asked)}
                {suffix}.
              </span>
              <span class="row">
                <button class="button small" onClick={() => ease([bound])}>
                  {bound.eased > 0 ? `Ask for ${compact(bound.eased)}${suffix}` : 'Drop it'}
                </button>
                {bound.card.guarantee?.by === 'chebyshev' && bound.field.startsWith('guarantee') && (
                  <button class="button small" onClick={() => byPatches(bound)}>
                    Every spot instead
                  </button>
                )}
              </span>
            </li>
          );
        })}
      </ul>
      <div class="row">
        {bounds.length > 1 && (
          <button class="button small" onClick={() => ease(bounds)}>
            Ease all {bounds.length}
          </button>
        )}
        {flux !== null && (
          <button class="button small" onClick={raise}>
            Or {grouped(String(flux))} lm each
          </button>
        )}
        <MoreLuminaires />
      </div>
    </section>
  );
}

/** "At least 300 lx": by Chebyshev (mu - alpha sigma) or by the true minimum; and the search for the smallest alpha. */
import { LocateFixed, Plus, X } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { compact, easedBound, niceStep, unitOf } from '../../app/words/format.ts';
import { intentionsOf, withBound, withOptional } from '../../document/intentions.ts';
import type { Card } from '../../document/types.ts';
import { AlphaPlot } from './alpha-plot.tsx';
import { useBound, type CardProps } from './card-hooks.ts';
import { CrossedNote } from './crossed-note.tsx';
import { NumberField } from '../controls/number-field.tsx';
import { NumberRow } from '../controls/number-row.tsx';
import { namesText } from '../../app/words/places.ts';
import { useReached } from './use-reached.ts';
import { words } from '../../language/language.ts';

type Guarantee = NonNullable<Card['guarantee']>;

export function CardGuarantee({ card }: CardProps) {
  const app = useApp();
  const reached = useReached(card);
  const { guarantee } = card;
  const change = (next: Guarantee | undefined) =>
    app.changeCard(card.id, words.value.steps.guarantee, (each) => withOptional(each, 'guarantee', next));
  if (!guarantee) {
    const floor = Math.max(1, Number((0.5 * (reached?.mean ?? 100)).toPrecision(1)));
    return (
      <button class="add-field" onClick={() => change({ by: 'patches', alpha: 2, min: floor })}>
        <Plus size={14} aria-hidden />
        {words.value.intentions.guarantee.add}
      </button>
    );
  }
  return (
    <fieldset class="field group">
      <legend>{words.value.intentions.guarantee.name}</legend>
      <button
        class="icon-button small corner"
        aria-label={words.value.intentions.guarantee.remove}
        onClick={() => change(undefined)}
      >
        <X size={14} aria-hidden />
      </button>
      <GuaranteeFields card={card} guarantee={guarantee} change={change} />
      <FindAlpha card={card} guarantee={guarantee} />
    </fieldset>
  );
}

interface FieldsProps extends CardProps {
  readonly guarantee: Guarantee;
  readonly change: (next: Guarantee) => void;
}

function GuaranteeFields({ card, guarantee, change }: FieldsProps) {
  const app = useApp();
  const { set, end } = useBound(card);
  const reached = useReached(card);
  const unit = unitOf(app.store.document.value.quantity);
  const step = niceStep(Math.max(1, (reached?.mean ?? 100) * 2));
  const setAlpha = (alpha: number | undefined) =>
    alpha !== undefined &&
    app.changeCard(
      card.id,
      words.value.steps.alpha,
      (each) => (each.guarantee ? { ...each, guarantee: { ...each.guarantee, alpha } } : each),
      `${card.id} alpha`,
    );
  return (
    <>
      <div class="segments wide" role="group" aria-label={words.value.intentions.guarantee.by}>
        <button
          aria-pressed={guarantee.by === 'patches'}
          title={words.value.intentions.guarantee.everySpotTip}
          onClick={() => change({ ...guarantee, by: 'patches' })}
        >
          {words.value.intentions.guarantee.everySpot}
        </button>
        <button
          aria-pressed={guarantee.by === 'chebyshev'}
          title={words.value.intentions.guarantee.chebyshevTip}
          onClick={() => change({ ...guarantee, by: 'chebyshev' })}
        >
          {words.value.intentions.guarantee.chebyshev}
        </button>
      </div>
      <div class="field-pair">
        <NumberField
          label={words.value.intentions.guarantee.min}
          value={guarantee.min}
          unit={unit}
          step={step}
          placeholder={words.value.intentions.noLeast}
          waits={(value) => value > (guarantee.max ?? Infinity)}
          onInput={(value) => set('guarantee.min', value)}
          onEnd={end}
        />
        <span aria-hidden="true">{words.value.intentions.to}</span>
        <NumberField
          label={words.value.intentions.guarantee.max}
          value={guarantee.max}
          unit={unit}
          step={step}
          placeholder={words.value.intentions.noMost}
          waits={(value) => value < (guarantee.min ?? 0)}
          onInput={(value) => set('guarantee.max', value)}
          onEnd={end}
        />
      </div>
      <CrossedNote card={card} range="guarantee" />
      {guarantee.by === 'chebyshev' && (
        <NumberRow
          name={words.value.intentions.guarantee.alpha}
          label={words.value.intentions.guarantee.alpha}
          value={Number(guarantee.alpha.toPrecision(4))}
          step={0.1}
          max={100}
          onInput={setAlpha}
          onEnd={end}
        />
      )}
    </>
  );
}

function FindAlpha({ card, guarantee }: CardProps & { guarantee: Guarantee }) {
  const app = useApp();
  const { store, solving } = app;
  const run = store.alphaRun.value;
  const isMine = run?.card === card.id;
  if (guarantee.min === undefined && guarantee.max === undefined) return null;
  // The search replaces the true least and most by Chebyshev's inequality, so those are what it is given.
  const find = () => {
    const document = store.document.peek();
    const aimed = document.cards.find(({ aim, verb, weight }) => aim && verb !== 'keep' && weight > 0);
    if (aimed) {
      const where = namesText(aimed.surfaces);
      store.say('warning', words.value.intentions.guarantee.noAims(where));
      return;
    }
    const cards = document.cards.map((each) =>
      each.id === card.id ? { ...each, guarantee: { ...guarantee, by: 'patches' as const } } : each,
    );
    solving.findAlpha(card.id, intentionsOf({ ...document, cards }).intentions);
  };
  const isRunning = isMine && run.done === null;
  const isLeast = guarantee.min !== undefined;
  const field = isLeast ? 'guarantee.min' : 'guarantee.max';
  const asked = guarantee[isLeast ? 'min' : 'max'] ?? 0;
  const bound = run?.done?.alpha === null ? run.done.feasibleBound : null;
  const isMet = bound !== null && (isLeast ? bound >= asked : bound <= asked);
  const feasible = bound === null ? null : isMet ? asked : easedBound(bound, isLeast ? 'min' : 'max') || null;
  return (
    <>
      <button class="button small" disabled={isRunning} onClick={find}>
        <LocateFixed size={14} aria-hidden />
        {isRunning ? words.value.intentions.guarantee.searching : words.value.intentions.guarantee.find}
      </button>
      {isMine && (run.steps.length > 0 || run.done) && <AlphaPlot run={run} />}
      {isMine && feasible !== null && (
        <button
          class="button small"
          onClick={() =>
            app.changeCard(card.id, words.value.steps.guarantee, (each) =>
              withBound({ ...each, guarantee: { ...guarantee, by: 'patches' } }, field, feasible),
            )
          }
        >
          {words.value.intentions.guarantee.ask(
            `${compact(feasible)} ${unitOf(store.document.value.quantity)}`,
          )}
        </button>
      )}
    </>
  );
}

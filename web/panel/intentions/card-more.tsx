/** What else may be asked of a surface: bounds of mean and spread, evenness, contrast to another surface. Shown once asked for. */
import { Plus, X } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { compact, niceStep, ratio, unitOf } from '../../app/words/format.ts';
import { withOptional } from '../../document/intentions.ts';
import type { Card } from '../../document/types.ts';
import { useBound, type CardProps } from './card-hooks.ts';
import { CardPlanes } from './card-planes.tsx';
import { CrossedNote } from './crossed-note.tsx';
import { NumberField } from '../controls/number-field.tsx';
import { NumberRow } from '../controls/number-row.tsx';
import { SurfacePicker } from './surface-picker.tsx';
import { useReached, type Reached } from './use-reached.ts';
import { words } from '../../language/language.ts';

export function CardMore({ card }: CardProps) {
  const app = useApp();
  const reached = useReached(card);
  const add = (change: Parameters<typeof app.changeCard>[2]) =>
    app.changeCard(card.id, words.value.steps.more, change);
  const other = app.store.sceneWithAreas.value?.surfaces.find(
    (surface) => !card.surfaces.includes(surface.name),
  )?.name;
  return (
    <>
      {card.spread && <SpreadFields card={card} reached={reached} />}
      {card.uniformity !== undefined && <UniformityField card={card} reached={reached} />}
      {card.contrast && <ContrastFields card={card} />}
      <CardPlanes card={card} />
      <div class="add-fields">
        {card.verb !== 'keep' && !card.mean && (
          <button
            class="add-field"
            onClick={() => add((each) => withOptional(each, 'mean', firstRange(each, reached?.mean ?? 1)))}
          >
            <Plus size={14} aria-hidden />
            {words.value.intentions.more.mean}
          </button>
        )}
        {!card.spread && (
          <button
            class="add-field"
            onClick={() => add((each) => withOptional(each, 'spread', { max: rounded(reached?.sigma ?? 1) }))}
          >
            <Plus size={14} aria-hidden />
            {words.value.intentions.more.spread}
          </button>
        )}
        {card.uniformity === undefined && (
          <button class="add-field" onClick={() => add((each) => withOptional(each, 'uniformity', 0.4))}>
            <Plus size={14} aria-hidden />
            {words.value.intentions.more.evenness}
          </button>
        )}
        {!card.contrast && other && (
          <button
            class="add-field"
            onClick={() => add((each) => withOptional(each, 'contrast', { over: [other], min: 1 }))}
          >
            <Plus size={14} aria-hidden />
            {words.value.intentions.more.contrast}
          </button>
        )}
      </div>
    </>
  );
}

const rounded = (value: number) => Number(value.toPrecision(2));

/** Where bounds of the mean begin: at what there is, from the side that the verb pushes against. */
function firstRange({ verb }: Card, mean: number): NonNullable<Card['mean']> {
  return verb === 'overshadow' ? { max: rounded(mean) } : { min: rounded(mean) };
}

type FieldsProps = CardProps & { readonly reached: Reached | null };

interface RemoveProps extends CardProps {
  readonly what: 'spread' | 'uniformity' | 'contrast';
}

function Remove({ card, what }: RemoveProps) {
  const app = useApp();
  const name = words.value.intentions.more.names[what];
  return (
    <button
      class="icon-button small corner"
      aria-label={words.value.intentions.more.remove(name)}
      onClick={() =>
        app.changeCard(card.id, words.value.steps.remove(name), (each) => withOptional(each, what, undefined))
      }
    >
      <X size={14} aria-hidden />
    </button>
  );
}

function SpreadFields({ card, reached }: FieldsProps) {
  const { store } = useApp();
  const { set, end } = useBound(card);
  const unit = unitOf(store.document.value.quantity);
  const step = niceStep(Math.max(1, (reached?.sigma ?? 50) * 3));
  return (
    <fieldset class="field group">
      <legend>
        {words.value.intentions.more.spreadOf}{' '}
        {reached && <span class="field-note">{words.value.intentions.now(compact(reached.sigma))}</span>}
      </legend>
      <Remove card={card} what="spread" />
      <div class="field-pair">
        <NumberField
          label={words.value.intentions.more.spreadMin}
          value={card.spread?.min}
          unit={unit}
          step={step}
          placeholder={words.value.intentions.noLeast}
          waits={(value) => value > (card.spread?.max ?? Infinity)}
          onInput={(value) => set('spread.min', value)}
          onEnd={end}
        />
        <span aria-hidden="true">{words.value.intentions.to}</span>
        <NumberField
          label={words.value.intentions.more.spreadMax}
          value={card.spread?.max}
          unit={unit}
          step={step}
          placeholder={words.value.intentions.noMost}
          waits={(value) => value < (card.spread?.min ?? 0)}
          onInput={(value) => set('spread.max', value)}
          onEnd={end}
        />
      </div>
      <CrossedNote card={card} range="spread" />
    </fieldset>
  );
}

function UniformityField({ card, reached }: FieldsProps) {
  const { set, end } = useBound(card);
  return (
    <fieldset class="field group">
      <legend>
        {words.value.intentions.more.evennessOf}{' '}
        {reached && (
          <span class="field-note">{words.value.intentions.now(ratio(reached.min / reached.mean))}</span>
        )}
      </legend>
      <Remove card={card} what="uniformity" />
      <NumberRow
        name={words.value.intentions.more.evennessRow}
        label={words.value.intentions.more.evennessMin}
        value={card.uniformity}
        step={0.01}
        max={1}
        onInput={(value) => set('uniformity', value)}
        onEnd={end}
      />
    </fieldset>
  );
}

function ContrastFields({ card }: CardProps) {
  const app = useApp();
  const { set, end } = useBound(card);
  const { surfaces, direct, contrast } = card;
  const here = useReached({ surfaces, direct });
  const there = useReached({ surfaces: contrast?.over ?? [], direct });
  if (!contrast) return null;
  return (
    <fieldset class="field group">
      <legend>
        {words.value.intentions.more.contrast}{' '}
        {here && there && (
          <span class="field-note">{words.value.intentions.now(ratio(here.mean / there.mean))}</span>
        )}
      </legend>
      <Remove card={card} what="contrast" />
      <SurfacePicker
        label={words.value.intentions.more.over}
        names={contrast.over}
        onChange={(over) =>
          app.changeCard(card.id, words.value.steps.contrast, (each) => ({
            ...each,
            contrast: { ...contrast, over },
          }))
        }
      />
      <NumberRow
        name={words.value.intentions.more.contrastRow}
        label={words.value.intentions.more.contrastMin}
        value={contrast.min}
        step={0.1}
        max={1e4}
        onInput={(value) => set('contrast', value)}
        onEnd={end}
      />
    </fieldset>
  );
}

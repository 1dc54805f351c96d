/** The two-handled range for the mean of a card: roughly by sliding, exactly by typing. */
import { useApp } from '../../app/app.ts';
import { compact, niceStep, unitOf } from '../../app/words/format.ts';
import { namesText } from '../../app/words/places.ts';
import { useBound, type Axis, type CardProps } from './card-hooks.ts';
import { CrossedNote } from './crossed-note.tsx';
import { NumberField } from '../controls/number-field.tsx';
import { RangeSlider } from '../controls/slider.tsx';
import { useReached } from './use-reached.ts';
import { words } from '../../language/language.ts';

export function MeanRange({ card, axis }: CardProps & { axis: Axis }) {
  const { store } = useApp();
  const { set, end } = useBound(card);
  const reached = useReached(card);
  const unit = unitOf(store.document.value.quantity);
  const { min, max } = card.mean ?? {};
  const { scale, hold, release } = axis;
  const step = niceStep(scale);
  const name = namesText(card.surfaces);
  const finish = () => {
    release();
    end();
  };
  return (
    <div class="field">
      <div class="field-head">
        <span class="field-name">{words.value.intentions.range.name}</span>
        {reached && (
          <span class="field-note">{words.value.intentions.now(`${compact(reached.mean)} ${unit}`)}</span>
        )}
      </div>
      <RangeSlider
        label={words.value.intentions.range.of(name)}
        low={min ?? 0}
        high={max ?? scale}
        {...{ scale, step, unit }}
        reached={reached?.mean}
        onInput={(which, value) => {
          hold();
          if (which === 'min') set('mean.min', value > 0 ? value : undefined);
          else set('mean.max', value < scale ? value : undefined);
        }}
        onEnd={finish}
      />
      <div class="field-pair">
        <NumberField
          label={words.value.intentions.range.min(name)}
          value={min}
          unit={unit}
          step={step}
          placeholder={words.value.intentions.noLeast}
          waits={(value) => value > (max ?? Infinity)}
          onInput={(value) => set('mean.min', value || undefined)}
          onEnd={end}
        />
        <span aria-hidden="true">{words.value.intentions.to}</span>
        <NumberField
          label={words.value.intentions.range.max(name)}
          value={max}
          unit={unit}
          step={step}
          placeholder={words.value.intentions.noMost}
          waits={(value) => value < (min ?? 0)}
          onInput={(value) => set('mean.max', value)}
          onEnd={end}
        />
      </div>
      <CrossedNote card={card} range="mean" />
    </div>
  );
}

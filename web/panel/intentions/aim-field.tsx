/**
 * The one handle of Illuminate and Overshadow: a mean to come near to. At its end nothing is aimed at: as much, or as
 * little, light as there can be.
 */
import { useApp } from '../../app/app.ts';
import { compact, niceStep, unitOf } from '../../app/words/format.ts';
import { NumberField } from '../controls/number-field.tsx';
import { Slider } from '../controls/slider.tsx';
import { withOptional } from '../../document/intentions.ts';
import { useScale, type CardProps } from './card-hooks.ts';
import { useReached } from './use-reached.ts';

export function AimField({ card }: CardProps) {
  const app = useApp();
  const reached = useReached(card.surfaces);
  const unit = unitOf(app.store.document.value.quantity);
  const { scale, hold, release } = useScale(Math.max(1, (reached?.mean ?? 0) * 1.5, (card.aim ?? 0) * 1.2));
  const step = niceStep(scale);
  const isMost = card.verb === 'illuminate';
  const atEnd = isMost ? 'as much as possible' : 'as little as possible';
  const name = card.surfaces[0] ?? '';
  const set = (value: number | undefined) =>
    app.changeCard(
      card.id,
      `Aim at a mean of ${name}`,
      (each) => withOptional(each, 'aim', value || undefined),
      `${card.id} aim`,
    );
  const end = () => {
    release();
    app.store.endGesture();
  };
  return (
    <div class="field">
      <div class="field-head">
        <span class="field-name">About</span>
        {reached && (
          <span class="field-note">
            now {compact(reached.mean)} {unit}
          </span>
        )}
      </div>
      <div class="field-pair">
        <Slider
          label={`${name}: about`}
          value={card.aim ?? (isMost ? scale : 0)}
          min={0}
          max={scale}
          step={step}
          text={card.aim === undefined ? atEnd : `${compact(card.aim)} ${unit}`}
          onInput={(value) => {
            hold();
            set(value > 0 && value < scale ? value : undefined);
          }}
          onEnd={end}
        />
        <NumberField
          label={`${name}: aim at a mean of`}
          value={card.aim}
          unit={unit}
          step={step}
          placeholder={isMost ? 'most' : 'least'}
          onInput={set}
          onEnd={end}
        />
      </div>
    </div>
  );
}

/**
 * The one handle of a card: about which mean. Where nothing is aimed at, Illuminate asks for as much light as there can be,
 * Overshadow for as little, and the others take the mean as it comes.
 */
import { useApp } from '../../app/app.ts';
import { compact, niceStep, unitOf } from '../../app/words/format.ts';
import { namesText } from '../../app/words/places.ts';
import { NumberField } from '../controls/number-field.tsx';
import { Slider } from '../controls/slider.tsx';
import { missesAim, pullsBack, wayToAim, type AimWay } from '../../document/aim.ts';
import { boundedBy, withOptional } from '../../document/intentions.ts';
import type { Constraint, Verb } from '../../document/types.ts';
import type { Axis, CardProps } from './card-hooks.ts';
import { useReached } from './use-reached.ts';
import { isBest } from '../../app/words/proved.ts';
import { HangFreely } from './hang-freely.tsx';
import { words } from '../../language/language.ts';
import { shortest } from '../../language/numbers.ts';

const withoutAim: Record<Exclude<Verb, 'keep'>, 'most' | 'least' | 'any'> = {
  illuminate: 'most',
  overshadow: 'least',
  homogenize: 'any',
  vary: 'any',
};

export function AimField({ card, axis }: CardProps & { axis: Axis }) {
  const app = useApp();
  const reached = useReached(card);
  const unit = unitOf(app.store.document.value.quantity);
  const { scale, hold, release } = axis;
  const step = niceStep(scale);
  const none = withoutAim[card.verb === 'keep' ? 'homogenize' : card.verb];
  const name = namesText(card.surfaces);
  const set = (value: number | undefined) =>
    app.changeCard(
      card.id,
      words.value.steps.aim(name),
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
        <span class="field-name">{words.value.intentions.aim.name}</span>
        {reached && (
          <span class="field-note">{words.value.intentions.now(`${compact(reached.mean)} ${unit}`)}</span>
        )}
        <NumberField
          label={words.value.intentions.aim.fieldOf(name)}
          value={card.aim}
          unit={unit}
          step={step}
          placeholder={words.value.intentions.aim.blank[none]}
          onInput={set}
          onEnd={end}
        />
      </div>
      <Slider
        label={words.value.intentions.aim.sliderOf(name)}
        value={card.aim ?? (card.verb === 'illuminate' ? scale : 0)}
        min={0}
        max={scale}
        step={step}
        text={card.aim === undefined ? words.value.intentions.aim[none] : `${compact(card.aim)} ${unit}`}
        onInput={(value) => {
          hold();
          set(value > 0 && value < scale ? value : undefined);
        }}
        onEnd={end}
      />
      <Beyond card={card} />
    </div>
  );
}

/**
 * Where the slider asks for more or less than these luminaires give: one click that brings it within reach, unless that
 * would break a bound, or break it further; then that no layout comes nearer.
 */
function Beyond({ card }: CardProps) {
  const { store } = useApp();
  const reached = useReached(card);
  const isSettled = store.progress.value.state === 'settled';
  if (!isSettled || !reached || !missesAim(reached.mean, card.aim)) return null;
  const way = wayToAim(store.document.value.luminaires, reached.mean, card.aim);
  const results = store.shown.value?.constraints ?? [];
  const share = card.aim / reached.mean;
  const isAgainst = (bound: Constraint, i: number) => pullsBack(bound, results[i]?.value ?? NaN, share);
  const isHeld = boundedBy(store.traced.value.intentions).some(isAgainst);
  if (way && !isHeld) return <WayTo way={way} />;
  return results.every((result) => result.met) ? <NoneNearer /> : null;
}

function WayTo({ way }: { way: AimWay }) {
  const { store } = useApp();
  const { aim } = words.value.intentions;
  const { steps } = words.value;
  const isDimmed = 'dimming' in way;
  const go = () =>
    store.edit(
      isDimmed ? steps.dimming : steps.raiseFlux,
      (draft) => void Object.assign(draft.luminaires, structuredClone(way)),
    );
  return (
    <div class="row aim-beyond">
      <span class="field-note">{isDimmed ? aim.tooMuch : aim.tooLittle}</span>
      <button class="button small" onClick={go}>
        {isDimmed ? aim.dim : aim.fluxEach(shortest(way.flux))}
      </button>
    </div>
  );
}

function NoneNearer() {
  const { store } = useApp();
  const { aim } = words.value.intentions;
  const bound = store.bound.value;
  const isProved = bound !== null && isBest(bound.gap);
  return (
    <div class="row aim-beyond">
      <span class="field-note">{isProved ? aim.noneNearer : aim.noneFoundNearer}</span>
      <HangFreely />
    </div>
  );
}

/** What may be used to light the room: how many luminaires, how strong, where not; and the list of them, for the keyboard. */
import { useApp } from '../../app/app.ts';
import { takeNumber } from '../../app/comparing.ts';
import { isOfSquares } from '../../document/intentions.ts';
import type { Luminaires } from '../../document/types.ts';
import { AreaList } from './area-list.tsx';
import { ArrangementChoice } from './arrangement-choice.tsx';
import { CountStrip } from './count-strip.tsx';
import { LuminaireList, SelectSeveral } from './luminaire-list.tsx';
import { MaintenanceFields } from './maintenance-fields.tsx';
import { TypeList } from './type-list.tsx';
import { NumberField } from '../controls/number-field.tsx';
import { NumberRow } from '../controls/number-row.tsx';
import { Slider } from '../controls/slider.tsx';
import { Check } from '../controls/check.tsx';
import { words } from '../../language/language.ts';
import { shortest } from '../../language/numbers.ts';

export function LuminairesTab() {
  const { store } = useApp();
  const { luminaires } = store.document.value;
  return (
    <>
      <TypeList />
      <ArrangementChoice />
      <CountAndFlux />
      <Dimming luminaires={luminaires} />
      <Distance luminaires={luminaires} />
      <Followers luminaires={luminaires} />
      <Places luminaires={luminaires} />
      <AreaList />
      <MaintenanceFields />
      <SelectSeveral />
      <LuminaireList />
    </>
  );
}

/** Edits of the rules; a whole drag is one step. */
function useRules() {
  const { store } = useApp();
  return {
    set: (label: string, change: Partial<Luminaires>, gesture = label) =>
      store.edit(label, (draft) => void Object.assign(draft.luminaires, change), gesture),
    end: () => store.endGesture(),
  };
}

interface RowProps {
  readonly label: string;
  readonly value: number;
  readonly range: readonly [number, number];
  readonly step: number;
  readonly unit?: string;
  readonly whole?: boolean;
  readonly most?: number;
  readonly whyLeast?: string;
  readonly onInput: (value: number) => void;
  readonly onEnd: () => void;
}

/** Roughly by sliding, exactly by typing. */
function SliderRow({ label, value, range, step, unit, whole, most, whyLeast, onInput, onEnd }: RowProps) {
  const take = (next: number) => onInput(whole ? Math.round(next) : Number(next.toPrecision(8)));
  return (
    <div class="field">
      <div class="field-head">
        <span class="field-name">{label}</span>
        <NumberField
          label={label}
          value={value}
          {...(unit && { unit })}
          {...(whole && { whole })}
          step={step}
          min={range[0]}
          max={most ?? range[1]}
          {...(whyLeast && { whyLeast })}
          onInput={(next) => next !== undefined && take(next)}
          onEnd={onEnd}
        />
      </div>
      <Slider
        label={label}
        value={value}
        min={range[0]}
        max={Math.max(range[1], value)}
        step={whole ? 10 * step : step}
        text={unit ? `${shortest(value)} ${unit}` : shortest(value)}
        onInput={take}
        onEnd={onEnd}
      />
    </div>
  );
}

function CountAndFlux() {
  const { store } = useApp();
  const { set, end } = useRules();
  const { luminaires } = store.document.value;
  const { count, most: atMost, flux, pinned } = luminaires;
  const pushed = (next: number) => (atMost !== undefined && atMost < next ? { most: next } : {});
  const isOfTypes = store.scene.value?.hasOperator && !isOfSquares(luminaires);
  const places = (store.scene.value?.sites.size.length ?? 1) - store.barred.value.length;
  const most = Math.max(1, Math.min(200, places));
  return (
    <>
      <SliderRow
        label={words.value.luminaires.count}
        value={count}
        range={[Math.max(1, pinned.length), Math.min(most, Math.max(32, count))]}
        most={most}
        step={1}
        whole
        {...(pinned.length > 1 && { whyLeast: words.value.luminaires.noFewer(pinned.length) })}
        onInput={(next) => set(words.value.steps.count, { count: next, ...pushed(next) })}
        onEnd={end}
      />
      <MostLuminaires places={places} />
      {!isOfTypes && (
        <SliderRow
          label={words.value.luminaires.flux}
          value={flux}
          range={[100, Math.max(10_000, flux)]}
          most={1e6}
          step={100}
          unit="lm"
          onInput={(next) => set(words.value.steps.flux, { flux: Math.round(next) })}
          onEnd={end}
        />
      )}
      <CountStrip />
    </>
  );
}

/** The number may be left to the search, up to a limit. */
function MostLuminaires({ places }: { places: number }) {
  const { store } = useApp();
  const { set, end } = useRules();
  const { count, most } = store.document.value.luminaires;
  const limit = Math.max(1, Math.min(200, places));
  const toggle = (on: boolean) =>
    store.edit(words.value.steps.vary, ({ luminaires }) => {
      if (on) luminaires.most = Math.min(limit, 2 * count);
      else takeNumber(luminaires, store.shown.value?.layout.sites.length);
    });
  return (
    <div class="setting-row">
      <Check label={words.value.luminaires.orMore} checked={most !== undefined} set={toggle} />
      {most !== undefined && (
        <NumberField
          label={words.value.luminaires.most}
          value={most}
          whole
          step={1}
          min={count}
          max={limit}
          onInput={(next) => next !== undefined && set(words.value.steps.most, { most: Math.round(next) })}
          onEnd={end}
        />
      )}
    </div>
  );
}

function Dimming({ luminaires }: { luminaires: Luminaires }) {
  const { store } = useApp();
  const { set, end } = useRules();
  const [low, high] = luminaires.dimming;
  const isOn = low < high;
  const dimming = store.shown.value?.layout.dimming ?? 1;
  return (
    <div class="field">
      <Check
        label={words.value.luminaires.dimming}
        checked={isOn}
        set={(on) => set(words.value.luminaires.dimming, { dimming: on ? [0.1, 1] : [1, 1] }, '')}
      />
      {isOn && (
        <NumberRow
          name={
            <>
              {words.value.luminaires.dimmedFrom}{' '}
              <output class="field-note">
                {words.value.intentions.now(`${Math.round(dimming * 100)} %`)}
              </output>
            </>
          }
          label={words.value.luminaires.dimmedLeast}
          unit="%"
          value={Math.round(low * 100)}
          step={1}
          max={99}
          onInput={(value) => set(words.value.steps.dimming, { dimming: [value / 100, high] })}
          onEnd={end}
        />
      )}
    </div>
  );
}

function Distance({ luminaires }: { luminaires: Luminaires }) {
  const { set, end } = useRules();
  return (
    <NumberRow
      name={words.value.luminaires.apart}
      label={words.value.luminaires.apart}
      unit="m"
      value={luminaires.minDistance}
      step={0.1}
      max={1000}
      onInput={(minDistance) => set(words.value.steps.distance, { minDistance })}
      onEnd={end}
    />
  );
}

/** Who makes up for a luminaire that is moved by hand; ties move as one anyway. */
function Followers({ luminaires }: { luminaires: Luminaires }) {
  const { store } = useApp();
  if ((luminaires.arrangement?.rule ?? 'free') !== 'free') return null;
  return (
    <Check
      label={words.value.luminaires.neighbours}
      checked={store.followers.value === 'neighbours'}
      set={(on) => (store.followers.value = on ? 'neighbours' : 'all')}
    />
  );
}

function Places({ luminaires }: { luminaires: Luminaires }) {
  const { hand } = useApp();
  const { pinned, excluded } = luminaires;
  if (pinned.length === 0 && excluded.length === 0) return null;
  return (
    <div class="row">
      {pinned.length > 0 && (
        <button class="button small" onClick={() => hand.unpinAll()}>
          {words.value.luminaires.unpin(pinned.length)}
        </button>
      )}
      {excluded.length > 0 && (
        <button class="button small" onClick={() => hand.includeAll()}>
          {words.value.luminaires.allow(excluded.length)}
        </button>
      )}
    </div>
  );
}

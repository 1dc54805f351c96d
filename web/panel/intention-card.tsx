/** A card: surface, verb, what is asked and what it reaches. The opened card carries all its controls and the histogram. */
import { ChevronRight, CircleCheck, CircleX, X } from 'lucide-preact';
import { useRef } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import { compact, niceCeiling, niceStep, ratio, unitOf } from '../app/format.ts';
import { leavesOf } from '../app/statistics.ts';
import { keepRange, withOptional, withPushedBound, type BoundField } from '../document/intentions.ts';
import type { Card, Verb } from '../document/types.ts';
import { CardGuarantee } from './card-guarantee.tsx';
import { CardMore } from './card-more.tsx';
import { Histogram } from './histogram.tsx';
import { NumberField } from './number-field.tsx';
import { RangeSlider } from './slider.tsx';
import { namesText, SurfacePicker } from './surface-picker.tsx';
import { useReached } from './use-reached.ts';
import { verbs } from './verbs.ts';

export interface CardProps {
  readonly card: Card;
}

/** Sets a bound of a card; all changes until the gesture ends are one step. */
export function useBound(card: Card) {
  const app = useApp();
  return {
    set: (field: BoundField, value: number | undefined) =>
      app.changeCard(
        card.id,
        `Change a bound of ${card.surfaces[0]}`,
        (each) => withPushedBound(each, field, value),
        `${card.id} ${field}`,
      ),
    end: () => app.store.endGesture(),
  };
}

export function IntentionCard({ card }: CardProps) {
  const app = useApp();
  const { store } = app;
  const isOpen = store.card.value === card.id;
  const status = useStatus(card);
  const reached = useReached(card.surfaces);
  const unit = unitOf(store.document.value.quantity);
  const toggle = () => {
    store.card.value = isOpen ? null : card.id;
    const leaf = leavesOf(card.surfaces, store.scene.value?.surfaces ?? [])[0];
    if (!isOpen && leaf !== undefined && !card.surfaces.includes('all')) store.surface.value = leaf;
  };
  return (
    <article class={isOpen ? 'card open' : 'card'}>
      <header>
        <button class="card-title" aria-expanded={isOpen} onClick={toggle}>
          <ChevronRight size={15} aria-hidden class="twist" />
          <span class="card-verb">{verbs.find(({ verb }) => verb === card.verb)?.title}</span>
          <span class="card-surface">{namesText(card.surfaces)}</span>
        </button>
        {reached && (
          <span class="card-reached">
            {compact(reached.mean)} {unit}
          </span>
        )}
        <Met status={status} />
        <button
          class="icon-button small"
          aria-label={`Remove: ${card.verb} ${card.surfaces[0]}`}
          onClick={() => app.removeCard(card.id)}
        >
          <X size={14} aria-hidden />
        </button>
      </header>
      {isOpen && <CardBody card={card} />}
    </article>
  );
}

type Status = 'met' | 'unmet' | 'none';

function useStatus(card: Card): Status {
  const { store } = useApp();
  const results = store.shown.value?.constraints;
  const mine = store.traced.value.origins.flatMap((origin, i) =>
    origin.card === card.id ? [results?.[i]] : [],
  );
  if (mine.length === 0 || mine.includes(undefined)) return 'none';
  return mine.every((result) => result?.met) ? 'met' : 'unmet';
}

function Met({ status }: { status: Status }) {
  if (status === 'none') return null;
  return (
    <span
      class={`met ${status}`}
      role="img"
      aria-label={status === 'met' ? 'met' : 'not met'}
      title={status === 'met' ? 'Met' : 'Not met'}
    >
      {status === 'met' ? <CircleCheck size={15} aria-hidden /> : <CircleX size={15} aria-hidden />}
    </span>
  );
}

function CardBody({ card }: CardProps) {
  const app = useApp();
  const { store } = app;
  const reached = useReached(card.surfaces);
  const setVerb = (verb: Verb) =>
    app.changeCard(card.id, `Change to ${verb}`, (each) =>
      verb === 'keep' && reached
        ? withOptional({ ...each, verb }, 'mean', keepRange(reached.mean))
        : { ...each, verb },
    );
  return (
    <div class="card-body">
      <div class="verbs" role="group" aria-label="What the light should do">
        {verbs.map(({ verb, title, icon: Icon, hint }) => (
          <button key={verb} aria-pressed={card.verb === verb} title={hint} onClick={() => setVerb(verb)}>
            <Icon size={16} aria-hidden />
            <span>{title}</span>
          </button>
        ))}
      </div>
      <SurfacePicker
        label="Surfaces"
        names={card.surfaces}
        onChange={(surfaces) =>
          app.changeCard(card.id, 'Change the surfaces', (each) => ({ ...each, surfaces }))
        }
      />
      <MeanRange card={card} />
      <Histogram card={card} />
      <CardGuarantee card={card} />
      <CardMore card={card} />
      {reached && (
        <dl class="readings">
          <Reading name="σ" value={compact(reached.sigma)} />
          <Reading name="min" value={compact(reached.min)} />
          <Reading name="max" value={compact(reached.max)} />
          <Reading name="U" sub="o" value={ratio(reached.min / reached.mean)} />
          <Reading name="U" sub="d" value={ratio(reached.min / reached.max)} />
        </dl>
      )}
      {store.document.value.cards.length > 1 && card.verb !== 'keep' && <Weight card={card} />}
    </div>
  );
}

function Reading({ name, sub, value }: { name: string; sub?: string; value: string }) {
  return (
    <div>
      <dt>
        {name}
        {sub && <sub>{sub}</sub>}
      </dt>
      <dd>{value}</dd>
    </div>
  );
}

/** A scale that does not move under the hand: it follows the numbers only while nobody drags. */
export function useScale(needed: number): { scale: number; hold: () => void; release: () => void } {
  const held = useRef<number | null>(null);
  const last = useRef(0);
  const fits = last.current >= needed && last.current <= needed * 3;
  if (!fits && held.current === null) last.current = niceCeiling(needed);
  return {
    scale: held.current ?? last.current,
    hold: () => (held.current ??= last.current),
    release: () => (held.current = null),
  };
}

function MeanRange({ card }: CardProps) {
  const { store } = useApp();
  const { set, end } = useBound(card);
  const reached = useReached(card.surfaces);
  const unit = unitOf(store.document.value.quantity);
  const { min, max } = card.mean ?? {};
  const { scale, hold, release } = useScale(
    Math.max(1, (reached?.mean ?? 0) * 1.8, (min ?? 0) * 1.4, (max ?? 0) * 1.25),
  );
  const step = niceStep(scale);
  const name = card.surfaces[0] ?? '';
  const finish = () => {
    release();
    end();
  };
  return (
    <div class="field">
      <div class="field-head">
        <span class="field-name">Mean</span>
        {reached && (
          <span class="field-note">
            now {compact(reached.mean)} {unit}
          </span>
        )}
      </div>
      <RangeSlider
        label={`${name}: mean`}
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
          label={`${name}: mean at least`}
          value={min}
          unit={unit}
          step={step}
          placeholder="no least"
          waits={(value) => value > (max ?? Infinity)}
          onInput={(value) => set('mean.min', value || undefined)}
          onEnd={end}
        />
        <span aria-hidden="true">to</span>
        <NumberField
          label={`${name}: mean at most`}
          value={max}
          unit={unit}
          step={step}
          placeholder="no most"
          waits={(value) => value < (min ?? 0)}
          onInput={(value) => set('mean.max', value)}
          onEnd={end}
        />
      </div>
    </div>
  );
}

function Weight({ card }: CardProps) {
  const app = useApp();
  return (
    <div class="setting-row">
      <span>Weight of this goal</span>
      <NumberField
        label="Weight of this goal"
        value={card.weight}
        step={0.1}
        max={1000}
        onInput={(weight) =>
          weight !== undefined &&
          app.changeCard(card.id, 'Change a weight', (each) => ({ ...each, weight }), `${card.id} weight`)
        }
        onEnd={() => app.store.endGesture()}
      />
    </div>
  );
}

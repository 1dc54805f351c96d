/** A card: surface, verb, what is asked and what it reaches. The opened card carries all its controls and the histogram. */
import { ChevronRight, CircleCheck, CircleX, X } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { compact, ratio, unitOf } from '../../app/words/format.ts';
import { marginText } from '../../app/words/layout-check.ts';
import { leavesOf } from '../../document/surface-names.ts';
import { keepRange, withOptional } from '../../document/intentions.ts';
import type { Card, Verb } from '../../document/types.ts';
import { AimField } from './aim-field.tsx';
import { CardGuarantee } from './card-guarantee.tsx';
import type { CardProps } from './card-hooks.ts';
import { CardMore } from './card-more.tsx';
import { Histogram } from './histogram.tsx';
import { NumberField } from '../controls/number-field.tsx';
import { MeanRange } from './mean-range.tsx';
import { namesText, SurfacePicker } from './surface-picker.tsx';
import { useReached } from './use-reached.ts';
import { verbs } from './verbs.ts';

export function IntentionCard({ card }: CardProps) {
  const app = useApp();
  const { store } = app;
  const isOpen = store.card.value === card.id;
  const status = useStatus(card);
  const reached = useReached(card.surfaces);
  const unit = unitOf(store.document.value.quantity);
  const toggle = () => {
    store.card.value = isOpen ? null : card.id;
    const leaves = leavesOf(card.surfaces, store.scene.value?.surfaces ?? []);
    if (isOpen || leaves[0] === undefined || card.surfaces.includes('all')) return;
    store.surface.value = leaves[0];
    app.viewer.reveal(leaves);
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

interface Status {
  readonly met: boolean;
  readonly margin: number; // the least of the card's bounds, relative
}

function useStatus(card: Card): Status | null {
  const { store } = useApp();
  const results = store.shown.value?.constraints;
  const mine = store.traced.value.origins.flatMap((origin, i) =>
    origin.card === card.id ? [results?.[i] ?? null] : [],
  );
  const known = mine.filter((result) => result !== null);
  if (known.length === 0 || known.length < mine.length) return null;
  return {
    met: known.every((result) => result.met),
    margin: Math.min(...known.map((result) => result.margin)),
  };
}

function Met({ status }: { status: Status | null }) {
  if (!status) return null;
  return (
    <span
      class={`met ${status.met ? 'met' : 'unmet'}`}
      role="img"
      aria-label={status.met ? 'met' : 'not met'}
      title={`${status.met ? 'Met' : 'Not met'}: ${marginText(status.margin)}`}
    >
      {status.met ? <CircleCheck size={15} aria-hidden /> : <CircleX size={15} aria-hidden />}
    </span>
  );
}

/** Verbs that ask for a mean: one handle says how much, and bounds come only where they are asked for. */
const isAimed = ({ verb }: Card): boolean => verb === 'illuminate' || verb === 'overshadow';

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
      {isAimed(card) && <AimField card={card} />}
      {(!isAimed(card) || card.mean) && <MeanRange card={card} />}
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

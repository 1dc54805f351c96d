/** A card: surface, verb, what is asked and what it reaches. The opened card carries all its controls and the histogram. */
import { ChevronRight, X } from 'lucide-preact';
import { useEffect, useRef } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { withSurfaces } from '../../app/state/grid-light.ts';
import { mostShown } from '../../app/state/statistics.ts';
import { compact, ratio, unitOf } from '../../app/words/format.ts';
import { marginText } from '../../app/words/layout-check.ts';
import { isFarFrom, missesAim } from '../../document/aim.ts';
import { leafBehind } from '../../document/task-areas.ts';
import { leavesOf } from '../../document/surface-names.ts';
import { isUpper, keepRange, withOptional } from '../../document/intentions.ts';
import type { Card, SurfaceNames, Verb } from '../../document/types.ts';
import { AimField } from './aim-field.tsx';
import { CardGuarantee } from './card-guarantee.tsx';
import { usePaperWords, useScale, type CardProps } from './card-hooks.ts';
import { CardMore } from './card-more.tsx';
import { Histogram } from './histogram.tsx';
import { Check } from '../controls/check.tsx';
import { MetMark } from '../controls/met-mark.tsx';
import { More } from '../controls/more.tsx';
import { NumberRow } from '../controls/number-row.tsx';
import { MeanRange } from './mean-range.tsx';
import { namesText } from '../../app/words/places.ts';
import { SurfacePicker } from './surface-picker.tsx';
import { useReached, useSample, type Reached } from './use-reached.ts';
import { verbs } from './verbs.ts';
import { words } from '../../language/language.ts';
import { shortest } from '../../language/numbers.ts';

export function IntentionCard({ card }: CardProps) {
  const app = useApp();
  const { store } = app;
  const isOpen = store.card.value === card.id;
  const status = useStatus(card);
  const reached = useReached(card);
  const unit = unitOf(store.document.value.quantity);
  const toggle = () => {
    store.card.value = isOpen ? null : card.id;
    const scene = store.sceneWithAreas.peek();
    const leaves = leavesOf(card.surfaces, scene?.surfaces ?? []);
    if (isOpen || leaves[0] === undefined || card.surfaces.includes('all')) return;
    store.surface.value = leaves[0];
    if (scene) app.viewer.reveal(leaves.map((leaf) => leafBehind(scene, leaf)));
  };
  // A card above that closes with this opening would draw its title out of sight.
  const head = useRef<HTMLElement>(null);
  useEffect(() => {
    if (isOpen) head.current?.scrollIntoView({ block: 'nearest' });
  }, [isOpen]);
  return (
    <article class={isOpen ? 'card open' : 'card'}>
      <header ref={head}>
        <button class="card-title" aria-expanded={isOpen} onClick={toggle}>
          <ChevronRight size={15} aria-hidden class="twist" />
          <span class="card-verb">{words.value.intentions.verbs[card.verb].title}</span>
          <span class="card-surface">{namesText(card.surfaces)}</span>
        </button>
        {reached && <span class="card-reached">{reachedText(reached.mean, card.aim, unit)}</span>}
        {!(status?.met && reached && isFarFrom(reached.mean, card.aim)) && <Met status={status} />}
        <button
          class="icon-button small"
          aria-label={words.value.intentions.card.remove(
            words.value.intentions.verbs[card.verb].title.toLowerCase(),
            namesText(card.surfaces),
          )}
          onClick={() => app.removeCard(card.id)}
        >
          <X size={14} aria-hidden />
        </button>
      </header>
      {isOpen && <CardBody card={card} />}
    </article>
  );
}

/** The mean, "268 of 400 lx" where it is not quite what is aimed at. */
export function reachedText(mean: number, aim: number | undefined, unit: string): string {
  const missed = missesAim(mean, aim) ? words.value.intentions.card.ofAim(compact(aim)) : '';
  return `${compact(mean)}${missed} ${unit}`;
}

interface Status {
  readonly met: boolean;
  readonly text: string; // how far within its bound the tightest one is, or beyond
}

function useStatus(card: Card): Status | null {
  const { store } = useApp();
  const results = store.shown.value?.constraints;
  const mine = store.traced.value.origins.flatMap(({ card: id, field }, i) =>
    id === card.id ? [{ field, result: results?.[i] }] : [],
  );
  const known = mine.flatMap(({ field, result }) => (result ? [{ field, ...result }] : []));
  const [tightest] = [...known].sort((a, b) => a.margin - b.margin);
  if (!tightest || known.length < mine.length) return null;
  const met = known.every((result) => result.met);
  const text = marginText(tightest.margin, { isMost: isUpper(tightest.field), isMet: met });
  return { met, text };
}

function Met({ status }: { status: Status | null }) {
  if (!status) return null;
  const { met, unmet, exactly, status: told } = words.value.intentions.card;
  const isExact = status.met && status.text === words.value.values.exactly;
  const title = isExact ? exactly : told(status.met ? met : unmet, status.text);
  return <MetMark met={status.met} title={title} />;
}

/** What every card shows at once; all else that it may hold is behind "more". */
const atOnce = new Set<string>(['id', 'surfaces', 'verb', 'weight', 'aim', 'onGrid']);

/** Whether a card asks for something that is behind "more". */
const asksMore = (card: Card): boolean =>
  Object.keys(card).some((key) => !atOnce.has(key) && !(key === 'mean' && card.verb === 'keep'));

/** One scale for the slider and the histogram of a card: what is asked and the light, but not its few brightest spots. */
function useAxis({ aim, mean, guarantee, surfaces, direct }: Card, reached: Reached | null) {
  const sample = useSample(surfaces, direct);
  const most = sample ? mostShown(sample) : 0;
  // A bound far beyond the light stands at the edge, so that the light keeps its shape.
  const near = (bound: number | undefined) => (bound !== undefined && bound <= 6 * most ? bound : 0);
  const bounds = [aim, mean?.min, mean?.max, guarantee?.min, guarantee?.max].map(near);
  return useScale(Math.max(1e-3, most, 1.5 * (reached?.mean ?? 0), 1.2 * Math.max(...bounds)));
}

function CardBody({ card }: CardProps) {
  const app = useApp();
  const { store } = app;
  const reached = useReached(card);
  const axis = useAxis(card, reached);
  const inPaperWords = usePaperWords();
  const setVerb = (verb: Verb) =>
    app.changeCard(
      card.id,
      words.value.steps.verb(words.value.intentions.verbs[verb].title.toLowerCase()),
      (each) =>
        verb === 'keep' && reached
          ? withOptional({ ...each, verb }, 'mean', keepRange(reached.mean))
          : { ...each, verb },
    );
  const isKeep = card.verb === 'keep';
  return (
    <div class="card-body">
      <div class="verbs" role="group" aria-label={words.value.intentions.card.verbs}>
        {verbs.map(({ verb, icon: Icon }) => (
          <button
            key={verb}
            aria-pressed={card.verb === verb}
            title={words.value.intentions.verbs[verb].hint}
            onClick={() => setVerb(verb)}
          >
            <Icon size={16} aria-hidden />
            <span>{words.value.intentions.verbs[verb].title}</span>
          </button>
        ))}
      </div>
      <SurfacePicker
        label={words.value.intentions.card.surfaces}
        names={card.surfaces}
        onChange={(surfaces) =>
          app.changeCard(card.id, words.value.steps.surfaces, (each) =>
            withSurfaces(each, surfaces, store.sceneWithAreas.value?.surfaces ?? [], store.shown.value),
          )
        }
      />
      {isKeep ? <MeanRange {...{ card, axis }} /> : <AimField {...{ card, axis }} />}
      <Histogram {...{ card, axis }} />
      {reached && <Readings of={firstReadings} reached={reached} />}
      {reached && card.onGrid && <GridNote names={card.surfaces} />}
      <More isUsed={inPaperWords || asksMore(card)}>
        {!isKeep && card.mean && <MeanRange {...{ card, axis }} />}
        <CardGuarantee card={card} />
        <CardMore card={card} />
        <DirectOnly card={card} />
        {reached && <Readings of={moreReadings} reached={reached} />}
        {store.document.value.cards.length > 1 && !isKeep && <Weight card={card} />}
      </More>
    </div>
  );
}

/** Emergency lighting counts direct light alone. */
function DirectOnly({ card }: CardProps) {
  const app = useApp();
  const { store } = app;
  const canTell = store.scene.value?.hasOperator && store.document.value.quantity === 'illuminance';
  if (!canTell && !card.direct) return null;
  return (
    <Check
      label={words.value.intentions.card.direct}
      checked={card.direct === true}
      set={(on) =>
        app.changeCard(card.id, words.value.intentions.card.direct, (each) =>
          withOptional(each, 'direct', on || undefined),
        )
      }
    />
  );
}

type CardWords = (typeof words.value)['intentions']['card'];
type ReadingOf = (reached: Reached, text: CardWords) => readonly [name: string, value: string, tip?: string];

/** What a designer reads first. */
const firstReadings: readonly ReadingOf[] = [
  ({ mean }, text) => [text.mean, compact(mean)],
  ({ min, mean }, text) => [text.evenness, ratio(min / mean), text.evennessTip],
  ({ min }, text) => [text.darkest, compact(min), text.darkestTip],
  ({ max }, text) => [text.brightest, compact(max), text.brightestTip],
];

const moreReadings: readonly ReadingOf[] = [
  ({ sigma }, text) => [text.spread, compact(sigma)],
  ({ min, max }, text) => [text.ratio, ratio(min / max), text.ratioTip],
];

/**
 * What the figures of a card are of that asks at the points of the EN grid, which keep away from the edges of what is
 * measured: within the surface, or because it does so itself.
 */
function GridNote({ names }: { names: SurfaceNames }) {
  const { store } = useApp();
  const least = (values: readonly number[]) => (values.length > 0 ? Math.min(...values) : 0);
  const isOf = ({ name }: { name: string }) => names.includes(name);
  const rim = least((store.shown.value?.grids ?? []).filter(isOf).map((grid) => grid.rim));
  const border = least((store.scene.value?.surfaces ?? []).filter(isOf).map((each) => each.border ?? 0));
  const metres = (value: number) => (value > 0 ? shortest(Math.round(100 * value) / 100) : null);
  return <p class="field-note">{words.value.intentions.card.atGrid(metres(rim), metres(border))}</p>;
}

function Readings({ of, reached }: { of: readonly ReadingOf[]; reached: Reached }) {
  return (
    <dl class="readings">
      {of.map((reading) => {
        const [name, value, tip] = reading(reached, words.value.intentions.card);
        return (
          <div key={name} title={tip}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        );
      })}
    </dl>
  );
}

function Weight({ card }: CardProps) {
  const app = useApp();
  return (
    <NumberRow
      name={words.value.intentions.card.weight}
      label={words.value.intentions.card.weight}
      value={card.weight}
      step={0.1}
      max={1000}
      onInput={(weight) =>
        app.changeCard(
          card.id,
          words.value.steps.weight,
          (each) => ({ ...each, weight }),
          `${card.id} weight`,
        )
      }
      onEnd={() => app.store.endGesture()}
    />
  );
}

/** What can be done with what is selected: a verb for a surface, pin or move for a luminaire. */
import {
  ArrowDown,
  ArrowLeft,
  ArrowRight,
  ArrowUp,
  Ban,
  PaintRoller,
  Pin,
  PinOff,
  Trash2,
  X,
} from 'lucide-preact';
import { useApp } from '../app/app.ts';
import { compact, unitOf } from '../app/words/format.ts';
import { isPaintable } from '../document/paint.ts';
import { inPlan, inRoom } from '../document/plan-frame.ts';
import { positionOf } from '../document/sites.ts';
import type { SceneInfo } from '../document/types.ts';
import { NumberField } from './controls/number-field.tsx';
import { verbs } from './intentions/verbs.ts';
import { words } from '../language/language.ts';
import { surfaceText } from '../language/surface-names.ts';

export function SelectionBar() {
  const { store } = useApp();
  if (!store.scene.value || store.preview.value !== null) return null;
  const { length = 0 } = store.shown.value?.layout.sites ?? [];
  const selected = store.luminaires.value.filter((luminaire) => luminaire < length);
  if (selected.length > 0) return <LuminaireBar {...{ selected }} />;
  if (store.surface.value !== null) return <SurfaceBar surface={store.surface.value} />;
  return null;
}

function SurfaceBar({ surface }: { surface: number }) {
  const app = useApp();
  const { store } = app;
  const row = store.shown.value?.surfaces[surface];
  const leaf = store.sceneWithAreas.value?.surfaces[surface];
  if (!leaf) return null;
  const { name } = leaf;
  return (
    <div
      class="selection-bar of-surface"
      role="toolbar"
      aria-label={words.value.bars.selection.intentionsFor(surfaceText(name))}
    >
      <span class="selection-name">
        <strong>{surfaceText(name)}</strong>
        {row && (
          <span>
            {compact(row.mean)} {unitOf(store.document.value.quantity)}
          </span>
        )}
      </span>
      {verbs.map(({ verb, icon: Icon }) => (
        <button
          key={verb}
          class="chip"
          title={words.value.intentions.verbs[verb].hint}
          onClick={() => app.addCard(verb, [name])}
        >
          <Icon size={15} aria-hidden />
          <span>{words.value.intentions.verbs[verb].title}</span>
        </button>
      ))}
      {app.painting.canPaint.value && isPaintable(leaf) && (
        <button class="chip" title={words.value.paint.tip} onClick={() => app.paint(surface)}>
          <PaintRoller size={15} aria-hidden />
          <span>{words.value.paint.title}</span>
        </button>
      )}
      <button
        class="icon-button small"
        aria-label={words.value.bars.selection.clear}
        onClick={() => app.selectSurface(null)}
      >
        <X size={15} aria-hidden />
      </button>
    </div>
  );
}

/** Steps along the room's axes as seen in plan: x to the right, z down. */
export const steps = [
  { key: 'ArrowLeft', title: () => words.value.bars.selection.left, icon: ArrowLeft, direction: [-1, 0, 0] },
  { key: 'ArrowUp', title: () => words.value.bars.selection.up, icon: ArrowUp, direction: [0, 0, -1] },
  { key: 'ArrowDown', title: () => words.value.bars.selection.down, icon: ArrowDown, direction: [0, 0, 1] },
  {
    key: 'ArrowRight',
    title: () => words.value.bars.selection.right,
    icon: ArrowRight,
    direction: [1, 0, 0],
  },
] as const;

const tagsOf = (luminaires: readonly number[]) =>
  [...luminaires]
    .sort((a, b) => a - b)
    .map((luminaire) => `L${luminaire + 1}`)
    .join(', ');

/** Of one luminaire, or of several that are selected together. */
function LuminaireBar({ selected }: { selected: readonly number[] }) {
  const { store, hand } = useApp();
  const layout = store.shown.value?.layout;
  const luminaire = selected.at(-1)!;
  const site = layout?.sites[luminaire];
  if (!layout || site === undefined) return null;
  const { pinned } = store.document.value.luminaires;
  const isPinned = selected.every((each) => pinned.includes(layout.sites[each] ?? -1));
  const isOne = selected.length === 1;
  const { luminaire: one, luminaires: several } = words.value.bars.selection;
  const name = isOne ? one(luminaire + 1) : several(tagsOf(selected));
  return (
    <div class="selection-bar" role="toolbar" aria-label={name}>
      <span class="selection-name">
        <strong>{isOne ? `L${luminaire + 1}` : words.value.values.luminaires(selected.length)}</strong>
        {!isOne && selected.length <= 4 && <span>{tagsOf(selected)}</span>}
      </span>
      <button class="chip" aria-pressed={isPinned} onClick={() => hand.togglePin(selected)}>
        {isPinned ? <PinOff size={15} aria-hidden /> : <Pin size={15} aria-hidden />}
        <span>{isPinned ? words.value.bars.selection.unpin : words.value.bars.selection.pin}</span>
      </button>
      {isOne && <TypedPlace luminaire={luminaire} site={site} />}
      {steps.map(({ key, title, icon: Icon, direction }) => (
        <button
          key={key}
          class="icon-button"
          aria-label={title()}
          title={title()}
          onClick={() => hand.step(luminaire, direction)}
        >
          <Icon size={15} aria-hidden />
        </button>
      ))}
      {isOne && (
        <button class="chip" title={words.value.bars.selection.excludeTip} onClick={() => hand.exclude(site)}>
          <Ban size={15} aria-hidden />
          <span>{words.value.bars.selection.exclude}</span>
        </button>
      )}
      <button class="chip" title={words.value.bars.selection.removeTip} onClick={() => hand.remove(selected)}>
        <Trash2 size={15} aria-hidden />
        <span>{words.value.bars.selection.remove}</span>
      </button>
      <button
        class="icon-button small"
        aria-label={words.value.bars.selection.clear}
        onClick={() => hand.pick(null, 'alone')}
      >
        <X size={15} aria-hidden />
      </button>
    </div>
  );
}

/** Do the places of a room hang at one height? */
function isLevel({ position }: SceneInfo['sites']): boolean {
  const first = position[1] ?? 0;
  return position.every((value, i) => i % 3 !== 1 || Math.abs(value - first) < 0.01);
}

/** Where it hangs, east and north of the corner, and above the floor where that differs: taken to the nearest free place. */
function TypedPlace({ luminaire, site }: { luminaire: number; site: number }) {
  const { store, hand, viewer } = useApp();
  const scene = store.scene.value;
  const frame = viewer.frame();
  if (!scene || !frame) return null;
  const place = inPlan(frame, positionOf(scene.sites, site));
  return (
    <span class="typed-place" title={words.value.bars.selection.from(words.value.values.corner)}>
      {(isLevel(scene.sites) ? (['x', 'y'] as const) : (['x', 'y', 'z'] as const)).map((name, axis) => (
        <span key={`${name} ${luminaire}`}>
          <small aria-hidden="true">{name}</small>
          <NumberField
            label={words.value.bars.selection.placeOf(name, luminaire + 1)}
            unit="m"
            value={Math.round(place[axis]! * 1000) / 1000}
            step={0.5}
            max={frame.size[axis]!}
            waits={() => true}
            onInput={(value) => {
              if (value === undefined || value === Math.round(place[axis]! * 1000) / 1000) return;
              const next = place.map((own, i) => (i === axis ? value : own)) as [number, number, number];
              hand.moveNear(luminaire, inRoom(frame, next));
            }}
          />
        </span>
      ))}
    </span>
  );
}

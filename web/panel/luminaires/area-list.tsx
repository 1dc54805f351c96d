/** Where in plan luminaires may hang: areas kept free, areas that they keep to, and how far they stay from walls. */
import { SquareDashed, Trash2 } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { asRectangle, cornersOf, noAreas } from '../../document/areas.ts';
import { inPlan, inRoom, type PlanFrame } from '../../document/plan-frame.ts';
import { mostAreas } from '../../document/schema.ts';
import type { Areas, PlanArea, PlanOutline } from '../../document/types.ts';
import { NumberField } from '../controls/number-field.tsx';
import { words } from '../../language/language.ts';

type AreaKind = 'keepOut' | 'keepIn';

const kinds: readonly AreaKind[] = ['keepOut', 'keepIn'];

/** Edits of the areas; without any of them the document says nothing. */
function useAreas() {
  const { store } = useApp();
  const areas = store.document.value.luminaires.areas ?? noAreas;
  const set = (label: string, change: Partial<Areas>, gesture: string | null = null) =>
    store.edit(
      label,
      ({ luminaires }) => {
        const next = { ...areas, ...change };
        const isEmpty = next.keepOut.length + next.keepIn.length === 0 && next.fromWalls === 0;
        if (isEmpty) delete luminaires.areas;
        else luminaires.areas = structuredClone(next) as never;
      },
      gesture,
    );
  return { areas, set };
}

export function AreaList() {
  const { store, viewer } = useApp();
  const { areas, set } = useAreas();
  const frame = viewer.frame();
  if (!store.scene.value || !frame) return null;
  const draw = (kind: AreaKind) => {
    const isOn = store.drawing.value !== kind;
    store.drawing.value = isOn ? kind : null;
    if (isOn && !viewer.camera().plan) viewer.view('plan');
  };
  return (
    <section class="field area-list" aria-label={words.value.luminaires.areas.name}>
      <span class="field-name">{words.value.luminaires.areas.title}</span>
      <div class="row">
        {kinds.map((kind) => (
          <button
            key={kind}
            class="button small"
            aria-pressed={store.drawing.value === kind}
            disabled={areas[kind].length >= mostAreas}
            title={words.value.luminaires.areas.drag}
            onClick={() => draw(kind)}
          >
            <SquareDashed size={14} aria-hidden />
            {words.value.luminaires.areas.kinds[kind]} …
          </button>
        ))}
      </div>
      {kinds.map((kind) =>
        areas[kind].map((area, i) => (
          <AreaRow
            key={`${kind} ${i}`}
            name={`${words.value.luminaires.areas.kinds[kind]} ${i + 1}`}
            {...{ area, frame }}
            change={(next) =>
              set(
                words.value.steps.area,
                { [kind]: areas[kind].flatMap((each, k) => (k === i ? (next ?? []) : [each])) },
                next ? `${kind} ${i}` : null,
              )
            }
          />
        )),
      )}
      <div class="setting-row">
        <span>{words.value.luminaires.areas.fromWalls}</span>
        <NumberField
          label={words.value.luminaires.areas.fromWalls}
          unit="m"
          value={areas.fromWalls}
          step={0.1}
          max={100}
          onInput={(fromWalls) =>
            fromWalls !== undefined && set(words.value.steps.fromWalls, { fromWalls }, 'walls')
          }
          onEnd={() => store.endGesture()}
        />
      </div>
    </section>
  );
}

interface AreaProps {
  readonly name: string;
  readonly area: PlanArea | PlanOutline;
  readonly frame: PlanFrame;
  readonly change: (area: readonly [PlanArea] | null) => void; // null: it goes
}

const hundredths = (value: number) => Math.round(100 * value) / 100;

/** One area: a rectangle by its numbers, another one as it was drawn. */
function AreaRow({ name, area, frame, change }: AreaProps) {
  const rectangle = asRectangle(area);
  return (
    <div
      class="area-row"
      role="group"
      aria-label={name}
      title={words.value.luminaires.areas.from(words.value.values.corner)}
    >
      <div class="setting-row">
        <span>{name}</span>
        {!rectangle && <small>{words.value.areas.cornersOf(cornersOf(area).length)}</small>}
        <button
          class="icon-button small"
          aria-label={words.value.luminaires.areas.remove(name)}
          onClick={() => change(null)}
        >
          <Trash2 size={14} aria-hidden />
        </button>
      </div>
      {rectangle && <Numbers {...{ name, frame, change }} area={rectangle} />}
    </div>
  );
}

/** A rectangle by its south-west corner and its extent. */
function Numbers({ name, area, frame, change }: AreaProps & { readonly area: PlanArea }) {
  const { store } = useApp();
  const [x, z, farX, farZ] = area;
  const [west, south] = inPlan(frame, [x, frame.floor, farZ]);
  const now = [west, south, farX - x, farZ - z].map(hundredths) as [number, number, number, number];
  const set = (index: number, value: number | undefined) => {
    if (value === undefined || value === now[index]) return;
    const [left, bottom, width, depth] = now.map((each, i) => (i === index ? value : each)) as typeof now;
    if (!(width > 0 && depth > 0)) return;
    const [nextX, , nextZ] = inRoom(frame, [left, bottom, 0]);
    change([[nextX, nextZ - depth, nextX + width, nextZ]]);
  };
  return (
    <>
      {(['x', 'y', 'wide', 'deep'] as const).map((label, index) => (
        <span key={label}>
          <small aria-hidden="true">{words.value.luminaires.areas.sides[label]}</small>
          <NumberField
            label={`${name}: ${words.value.luminaires.areas.sides[label]}`}
            unit="m"
            value={now[index]!}
            step={0.1}
            min={index < 2 ? -1000 : 0.01}
            max={1000}
            onInput={(value) => set(index, value)}
            onEnd={() => store.endGesture()}
          />
        </span>
      ))}
    </>
  );
}

/** Task areas: drawn in the plan or taken from furniture, moved by their numbers, asked for light. */
import { Pencil, SquareDashed, Trash2, Waypoints } from 'lucide-preact';
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { gridLightOf, type GridLight } from '../../app/state/grid-light.ts';
import { compact, ratio } from '../../app/words/format.ts';
import { inPlan, inRoom, type PlanFrame } from '../../document/plan-frame.ts';
import { mostAreas } from '../../document/schema.ts';
import { rectangleOf, worktopsOf } from '../../document/task-areas.ts';
import type { PlanArea, TaskArea } from '../../document/types.ts';
import { words } from '../../language/language.ts';
import { surfaceText } from '../../language/surface-names.ts';
import type { Shown } from '../../solver/protocol.ts';
import { NumberField } from '../controls/number-field.tsx';

export function TaskAreaList() {
  const { store, viewer, tasks } = useApp();
  const frame = viewer.frame();
  if (!store.scene.value || !frame || store.document.value.quantity === 'exitance') return null;
  const { areas: say } = words.value;
  const { list } = tasks;
  const draw = (kind: 'task' | 'corners') => {
    const isOn = store.drawing.value !== kind;
    store.drawing.value = isOn ? kind : null;
    if (isOn && !viewer.camera().plan) viewer.view('plan');
  };
  return (
    <section class="field area-list" aria-label={say.name}>
      <span class="field-name">{say.name}</span>
      <div class="row">
        <button
          class="button small"
          aria-pressed={store.drawing.value === 'task'}
          disabled={list.length >= mostAreas}
          title={say.drawTip}
          onClick={() => draw('task')}
        >
          <SquareDashed size={14} aria-hidden />
          {say.draw}
        </button>
        <button
          class="button small"
          aria-pressed={store.drawing.value === 'corners'}
          disabled={list.length >= mostAreas}
          title={say.cornersTip}
          onClick={() => draw('corners')}
        >
          <Waypoints size={14} aria-hidden />
          {say.corners}
        </button>
        <AddAt />
        <DrawPlane />
      </div>
      {list.map((area, index) => (
        <AreaRow key={area.name} {...{ area, index, frame }} />
      ))}
    </section>
  );
}

/** A new measuring plane: in the plan of a room that is made, or as one more node of its model. */
function DrawPlane() {
  const { store, viewer, opening } = useApp();
  const { areas: say } = words.value;
  const draw = async () => {
    if (store.plan.peek()) return opening.make(store.plan.peek());
    if (store.drawing.peek() === 'plane') return void (store.drawing.value = null);
    if (!(await opening.lighting.hasModel())) return void store.say('info', say.planeNoModel);
    store.drawing.value = 'plane';
    if (!viewer.camera().plan) viewer.view('plan');
  };
  return (
    <button
      class="button small"
      aria-pressed={store.drawing.value === 'plane'}
      title={say.planeTip}
      onClick={() => void draw()}
    >
      <SquareDashed size={14} aria-hidden />
      {say.plane}
    </button>
  );
}

/** From a piece of furniture, or anywhere: without a pointer. */
function AddAt() {
  const { store, tasks } = useApp();
  const { areas: say } = words.value;
  const scene = store.scene.value;
  if (!scene) return null;
  return (
    <select
      class="button small"
      aria-label={say.at}
      value=""
      disabled={tasks.list.length >= mostAreas}
      onChange={(event) => {
        const { value } = event.currentTarget;
        event.currentTarget.value = '';
        if (value === middle) tasks.addInMiddle();
        else if (value) tasks.addFrom(value);
      }}
    >
      <option value="">{say.at}</option>
      <option value={middle}>{say.middle}</option>
      {worktopsOf(scene).map(({ name }) => (
        <option key={name} value={name}>
          {surfaceText(name)}
        </option>
      ))}
    </select>
  );
}

const middle = '\u0000'; // no surface has that name

function AreaRow({ area, index, frame }: { area: TaskArea; index: number; frame: PlanFrame }) {
  const app = useApp();
  const { store, tasks } = app;
  const { areas: say } = words.value;
  const { name, surface, outline } = area;
  const leaf = store.sceneWithAreas.value?.surfaces.findIndex((each) => each.name === name) ?? -1;
  const light = readingOf(store.shown.value, name);
  const rectangle = rectangleOf(outline);
  const isChosen = leaf >= 0 && store.surface.value === leaf;
  const [isNaming, setNaming] = useState(false);
  return (
    <div class="area-row" role="group" aria-label={surfaceText(name)}>
      <div class="setting-row">
        {isNaming ? (
          <NameField
            name={surfaceText(name)}
            take={(next) => {
              setNaming(false);
              if (next !== null) tasks.rename(index, next);
            }}
          />
        ) : (
          <button
            class="link-button"
            aria-pressed={isChosen}
            onClick={() => app.selectSurface(isChosen ? null : leaf)}
          >
            {surfaceText(name)}
          </button>
        )}
        <small>
          {light && leaf >= 0
            ? say.reached(compact(light.mean), ratio(light.uniformity))
            : say.on(surfaceText(surface))}
        </small>
        {!isNaming && (
          <button
            class="icon-button small"
            aria-label={say.rename(surfaceText(name))}
            onClick={() => setNaming(true)}
          >
            <Pencil size={14} aria-hidden />
          </button>
        )}
        <button
          class="icon-button small"
          aria-label={say.remove(surfaceText(name))}
          onClick={() => tasks.remove(index)}
        >
          <Trash2 size={14} aria-hidden />
        </button>
      </div>
      {leaf < 0 && <p class="field-note warn">{say.empty}</p>}
      {rectangle ? (
        <Numbers {...{ name, frame }} area={rectangle} set={(next) => tasks.reshape(index, next)} />
      ) : (
        <small>{say.cornersOf(outline.length)}</small>
      )}
      {leaf >= 0 && <AskForLight {...{ name, index }} />}
    </div>
  );
}

/** As cards ask for it: at the points of the grid where there are any. */
function readingOf(shown: Shown | null, name: string): Pick<GridLight, 'mean' | 'uniformity'> | null {
  const onGrid = shown && gridLightOf(shown, name);
  const row = shown?.surfaces.find((each) => each.name === name);
  return onGrid ?? (row ? { mean: row.mean, uniformity: row.min / row.mean } : null);
}

/** A new name: Enter or leaving the field takes it, Escape does not (null). */
function NameField({ name, take }: { name: string; take: (next: string | null) => void }) {
  const isOver = useRef(false); // taken or left: a field that goes is left once more
  const field = useRef<HTMLInputElement>(null);
  useLayoutEffect(() => field.current?.select(), []); // before the next key
  const end = (next: string | null) => {
    if (!isOver.current) take(next);
    isOver.current = true;
  };
  return (
    <input
      ref={field}
      class="area-name"
      type="text"
      maxLength={60}
      aria-label={words.value.areas.nameOf(name)}
      defaultValue={name}
      onKeyDown={(event) => {
        if (event.key === 'Enter') end(event.currentTarget.value);
        if (event.key !== 'Escape') return;
        event.stopPropagation();
        end(null);
      }}
      onBlur={(event) => end(event.currentTarget.value)}
    />
  );
}

/** Cards for the task and what is around it, from one number. */
function AskForLight({ name, index }: { name: string; index: number }) {
  const { tasks } = useApp();
  const { areas: say } = words.value;
  const [lux, setLux] = useState(500);
  return (
    <div class="setting-row">
      <NumberField
        label={say.lightOf(name)}
        unit="lx"
        value={lux}
        step={50}
        min={5}
        max={10_000}
        onInput={(value) => value !== undefined && setLux(value)}
      />
      <button class="button small" title={say.lightTip} onClick={() => tasks.ask(index, lux)}>
        {say.light}
      </button>
    </div>
  );
}

const hundredths = (value: number) => Math.round(100 * value) / 100;

interface NumbersProps {
  readonly name: string;
  readonly area: PlanArea;
  readonly frame: PlanFrame;
  readonly set: (area: PlanArea) => void;
}

/** A rectangle by its south-west corner and its extent. */
function Numbers({ name, area: [x, z, farX, farZ], frame, set }: NumbersProps) {
  const { store } = useApp();
  const { areas: say } = words.value;
  const [west, south] = inPlan(frame, [x, frame.floor, farZ]);
  const now = [west, south, farX - x, farZ - z].map(hundredths) as [number, number, number, number];
  const change = (index: number, value: number | undefined) => {
    if (value === undefined || value === now[index]) return;
    const [left, bottom, wide, deep] = now.map((each, i) => (i === index ? value : each)) as typeof now;
    if (!(wide > 0 && deep > 0)) return;
    const [nextX, , nextZ] = inRoom(frame, [left, bottom, 0]);
    set([nextX, nextZ - deep, nextX + wide, nextZ]);
  };
  return (
    <>
      {['x', 'y', say.wide, say.deep].map((label, index) => (
        <span key={label}>
          <small aria-hidden="true">{label}</small>
          <NumberField
            label={`${name}: ${label}`}
            unit="m"
            value={now[index]!}
            step={0.1}
            min={index < 2 ? -1000 : 0.01}
            max={1000}
            onInput={(value) => change(index, value)}
            onEnd={() => store.endGesture()}
          />
        </span>
      ))}
    </>
  );
}

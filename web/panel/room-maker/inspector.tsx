/** The numbers of what is selected in the plan, and what can be done with it. */
import { Copy, DoorOpen, Grid2x2, PanelTop, RotateCw, SquareSplitHorizontal, Trash2 } from 'lucide-preact';
import { useState } from 'preact/hooks';
import type { Selected } from '../../app/making.ts';
import {
  freePlace,
  toMillimetres,
  wallLength,
  withCorner,
  withItem,
  withOpening,
  withRows,
  withWallLength,
  withWallSplit,
} from '../../room-maker/plan-edits.ts';
import {
  sizesOf,
  usualOpening,
  type Item,
  type OpeningKind,
  type Task,
} from '../../room-maker/room-plan.mjs';
import { Field } from './field.tsx';
import { useMaking } from './making-context.ts';
import { words } from '../../language/language.ts';
import { kindTitle, wallTitle, wallWords } from './names.ts';

export function Inspector() {
  const making = useMaking();
  const selected = making.selected.value;
  if (!selected) return null;
  return (
    <section class="maker-inspector" aria-label={words.value.maker.selected.name}>
      <Selection selected={selected} />
    </section>
  );
}

function Selection({ selected: { what, index } }: { selected: Selected }) {
  switch (what) {
    case 'corner':
      return <CornerFields corner={index} />;
    case 'wall':
      return <WallFields wall={index} />;
    case 'opening':
      return <OpeningFields index={index} />;
    case 'item':
      return <ItemFields index={index} />;
    case 'task':
      return <TaskFields index={index} />;
  }
}

function Title({ text, canDelete = true }: { text: string; canDelete?: boolean }) {
  const making = useMaking();
  return (
    <header>
      <h3>{text}</h3>
      {canDelete && (
        <button
          class="icon-button small"
          aria-label={words.value.maker.selected.delete(text)}
          onClick={() => making.remove()}
        >
          <Trash2 size={15} aria-hidden />
        </button>
      )}
    </header>
  );
}

function CornerFields({ corner }: { corner: number }) {
  const making = useMaking();
  const { outline } = making.plan.value;
  const at = outline[corner];
  if (!at) return null;
  const [x, z] = at;
  const move = (to: readonly [number, number], gesture: string) =>
    making.edit((plan) => withCorner(plan, corner, to), gesture);
  return (
    <>
      <Title text={words.value.maker.selected.corner(corner + 1)} canDelete={outline.length > 3} />
      <div class="maker-grid">
        <Field label="x" value={x} min={-1000} max={1000} onInput={(value, g) => move([value, z], g)} />
        <Field label="y" value={z} min={-1000} max={1000} onInput={(value, g) => move([x, value], g)} />
      </div>
    </>
  );
}

function WallFields({ wall }: { wall: number }) {
  const making = useMaking();
  const plan = making.plan.value;
  const [isFull, setFull] = useState(false);
  if (!plan.outline[wall]) return null;
  const add = (kind: OpeningKind) => {
    const usual = usualOpening(kind, wall, 0);
    const height = Math.min(usual.height, plan.height - usual.sill - 0.15);
    const width = Math.min(usual.width, wallLength(plan, wall) - 0.4);
    const at = width > 0.1 && height > 0.1 ? freePlace(plan, wall, width) : null;
    setFull(at === null);
    if (at === null) return;
    making.edit((before) => ({ ...before, openings: [...before.openings, { ...usual, at, width, height }] }));
    making.selected.value = { what: 'opening', index: making.plan.peek().openings.length - 1 };
  };
  return (
    <>
      <Title text={wallTitle(plan, wall)} canDelete={false} />
      <div class="maker-grid">
        <Field
          label={words.value.maker.selected.length}
          value={toMillimetres(wallLength(plan, wall))}
          min={0.05}
          max={1000}
          onInput={(length, gesture) =>
            making.edit((before) => withWallLength(before, wall, length), gesture)
          }
        />
      </div>
      <div class="row">
        <button class="button small" onClick={() => add('door')}>
          <DoorOpen size={14} aria-hidden />
          <span>{words.value.maker.selected.door}</span>
        </button>
        <button class="button small" onClick={() => add('window')}>
          <PanelTop size={14} aria-hidden />
          <span>{words.value.maker.selected.window}</span>
        </button>
        <button class="button small" onClick={() => making.edit((before) => withWallSplit(before, wall))}>
          <SquareSplitHorizontal size={14} aria-hidden />
          <span>{words.value.maker.selected.addCorner}</span>
        </button>
      </div>
      {isFull && (
        <p class="fault" role="status">
          {words.value.maker.selected.noStretch}
        </p>
      )}
    </>
  );
}

function OpeningFields({ index }: { index: number }) {
  const making = useMaking();
  const plan = making.plan.value;
  const opening = plan.openings[index];
  if (!opening) return null;
  const number = plan.openings.slice(0, index + 1).filter(({ kind }) => kind === opening.kind).length;
  const field = (label: string, key: 'at' | 'width' | 'sill' | 'height', min: number, max: number) => (
    <Field
      label={label}
      value={opening[key]}
      min={min}
      max={max}
      onInput={(value, gesture) => making.edit((before) => withOpening(before, index, { [key]: value }), gesture)}
    />
  ); // prettier-ignore
  return (
    <>
      <Title
        text={words.value.maker.selected.opening(
          kindTitle(opening.kind),
          number,
          wallWords(plan, opening.wall),
        )}
      />
      <div class="maker-grid four">
        {field(words.value.maker.selected.fromCorner, 'at', 0, 1000)}
        {field(words.value.maker.selected.width, 'width', 0.1, 100)}
        {opening.kind === 'window' && field(words.value.maker.selected.sill, 'sill', 0, 50)}
        {field(words.value.maker.selected.height, 'height', 0.1, 50)}
      </div>
    </>
  );
}

function ItemFields({ index }: { index: number }) {
  const making = useMaking();
  const plan = making.plan.value;
  const item = plan.items[index];
  if (!item) return null;
  const number = plan.items.slice(0, index + 1).filter(({ kind }) => kind === item.kind).length;
  const change = (part: Partial<Item>, gesture: string | null = null) =>
    making.edit((before) => withItem(before, index, part), gesture);
  const size = (letter: string, which: 0 | 1 | 2, label: string) =>
    sizesOf[item.kind].includes(letter) && (
      <Field
        label={label}
        value={item.size[which]}
        min={0.05}
        max={50}
        onInput={(value, gesture) => change({ size: resized(item.size, which, value) }, gesture)}
      />
    ); // prettier-ignore
  return (
    <>
      <Title text={`${kindTitle(item.kind)} ${number}`} />
      <div class="maker-grid four">
        <Field label="x" value={item.x} min={-1000} max={1000} onInput={(x, g) => change({ x }, g)} />
        <Field label="y" value={item.z} min={-1000} max={1000} onInput={(z, g) => change({ z }, g)} />
        <Field
          label={words.value.maker.selected.turn}
          unit="°"
          step={15}
          min={-360}
          max={360}
          value={item.turn}
          onInput={(turn, g) => change({ turn }, g)}
        />
        {size(
          'w',
          0,
          item.kind.startsWith('round')
            ? words.value.maker.selected.diameter
            : words.value.maker.selected.width,
        )}
        {size('d', 1, words.value.maker.selected.depth)}
        {size('h', 2, words.value.maker.selected.height)}
      </div>
      <div class="row">
        <button class="button small" onClick={() => change({ turn: (item.turn + 90) % 360 })}>
          <RotateCw size={14} aria-hidden />
          <span>{words.value.maker.selected.turnBy90}</span>
        </button>
        <button class="button small" onClick={() => making.edit((before) => copied(before, index))}>
          <Copy size={14} aria-hidden />
          <span>{words.value.maker.selected.copy}</span>
        </button>
      </div>
      <RowFields index={index} item={item} key={`${item.kind} ${index}`} />
    </>
  );
}

const resized = ([width, depth, height]: Item['size'], which: 0 | 1 | 2, value: number): Item['size'] => [
  which === 0 ? value : width,
  which === 1 ? value : depth,
  which === 2 ? value : height,
];

/** A copy beside the original, which stays selected. */
function copied(plan: Parameters<typeof withRows>[0], index: number) {
  const pitch = (plan.items[index]?.size[0] ?? 1) + 0.4;
  return withRows(plan, index, { across: 2, down: 1, acrossPitch: pitch, downPitch: 1 });
}

function RowFields({ index, item }: { index: number; item: Item }) {
  const making = useMaking();
  const [rows, setRows] = useState({
    across: 3,
    down: 2,
    acrossPitch: toMillimetres(item.size[0] + 0.4),
    downPitch: toMillimetres(item.size[1] + 1.2),
  });
  const field = (label: string, key: keyof typeof rows, isCount: boolean) => (
    <Field
      label={label}
      value={rows[key]}
      unit={isCount ? '' : 'm'}
      step={isCount ? 1 : 0.1}
      min={isCount ? 1 : 0.05}
      max={isCount ? 50 : 100}
      whole={isCount}
      onInput={(value) => setRows({ ...rows, [key]: value })}
    />
  );
  return (
    <details class="maker-rows">
      <summary>{words.value.maker.selected.repeat}</summary>
      <div class="maker-grid four">
        {field(words.value.maker.selected.across, 'across', true)}
        {field(words.value.maker.selected.every, 'acrossPitch', false)}
        {field(words.value.maker.selected.rows, 'down', true)}
        {field(words.value.maker.selected.rowEvery, 'downPitch', false)}
      </div>
      <button class="button small" onClick={() => making.edit((before) => withRows(before, index, rows))}>
        <Grid2x2 size={14} aria-hidden />
        <span>{words.value.maker.selected.place(rows.across * rows.down)}</span>
      </button>
    </details>
  );
}

function TaskFields({ index }: { index: number }) {
  const making = useMaking();
  const task = making.plan.value.tasks[index];
  if (!task) return null;
  const field = (label: string, key: keyof Task, min: number, max: number, unit = 'm', step = 0.1) => (
    <Field
      label={label}
      unit={unit}
      step={step}
      min={min}
      max={max}
      value={task[key]}
      onInput={(value, gesture) =>
        making.edit(
          (plan) => ({ ...plan, tasks: plan.tasks.map((each, i) => (i === index ? { ...each, [key]: value } : each)) }),
          gesture,
        )
      }
    />
  ); // prettier-ignore
  return (
    <>
      <Title text={words.value.maker.taskArea(index + 1)} />
      <div class="maker-grid four">
        {field('x', 'x', -1000, 1000)}
        {field('y', 'z', -1000, 1000)}
        {field(words.value.maker.selected.turn, 'turn', -360, 360, '°', 15)}
        {field(words.value.maker.selected.width, 'width', 0.05, 100)}
        {field(words.value.maker.selected.depth, 'depth', 0.05, 100)}
        {field(words.value.maker.selected.height, 'height', 0, 50, 'm', 0.05)}
      </div>
    </>
  );
}

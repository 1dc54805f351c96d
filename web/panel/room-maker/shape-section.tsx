/** Where a room begins: its size as one types it, the shape of its plan, its height and its name. */
import { PencilRuler } from 'lucide-preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { extentOf, resized, withNewOutline } from '../../room-maker/plan-edits.ts';
import { outlines, readSize, type ShapeName, type SizeFault } from '../../room-maker/plan-shapes.mjs';
import { signedArea } from '../../room-maker/polygon.mjs';
import type { RoomPlan } from '../../room-maker/room-plan.mjs';
import { Choice, Field, Section } from './field.tsx';
import { useMaking } from './making-context.ts';
import { words } from '../../language/language.ts';
import { fixed, shortest } from '../../language/numbers.ts';
import { sizeFaultText } from './names.ts';

const shapes: readonly (readonly [ShapeName, () => string])[] = [
  ['rectangle', () => words.value.maker.shape.rectangle],
  ['L', () => 'L'],
  ['U', () => 'U'],
  ['T', () => 'T'],
];

/** The letter by the number of right angles; null for any other outline. */
function shapeOf({ outline }: RoomPlan): ShapeName | null {
  const isAlongAxes = outline.every(([x, z], i) => {
    const [nx, nz] = outline[(i + 1) % outline.length]!;
    return x === nx || z === nz;
  });
  if (!isAlongAxes) return null;
  if (outline.length === 4) return 'rectangle';
  if (outline.length === 6) return 'L';
  // note: a U has its two inner corners side by side, a T has two outer ones between them
  if (outline.length !== 8) return null;
  const inner = outline.map((corner, i) => {
    const [before, next] = [outline[(i + 7) % 8]!, outline[(i + 1) % 8]!];
    return (corner[0] - before[0]) * (next[1] - corner[1]) - (corner[1] - before[1]) * (next[0] - corner[0]) < 0; // prettier-ignore
  });
  return inner.some((each, i) => each && inner[(i + 1) % 8]) ? 'U' : 'T';
}

export function ShapeSection({ draw }: { draw: () => void }) {
  const making = useMaking();
  const plan = making.plan.value;
  const choose = (shape: ShapeName) => {
    const [width, depth] = extentOf(plan.outline);
    making.edit((before) => withNewOutline(before, outlines[shape](width, depth)));
    making.selected.value = null;
  };
  return (
    <Section title={words.value.maker.shape.room}>
      <SizeField />
      <div class="maker-line">
        <Choice label={words.value.maker.shape.name} choices={shapes} value={shapeOf(plan)} choose={choose} />
        <button class="button small" onClick={draw}>
          <PencilRuler size={14} aria-hidden />
          <span>{words.value.maker.shape.draw}</span>
        </button>
      </div>
      <div class="maker-grid">
        <Field
          label={words.value.maker.shape.height}
          value={plan.height}
          min={0.5}
          max={50}
          onInput={(height, gesture) => making.edit((before) => ({ ...before, height }), gesture)}
        />
        <label class="maker-field">
          <span>{words.value.maker.shape.nameOf}</span>
          <input
            type="text"
            class="maker-text"
            maxLength={60}
            placeholder={making.title.value}
            value={plan.name}
            onInput={(event) => {
              const name = event.currentTarget.value;
              making.edit((before) => ({ ...before, name }), 'name');
            }}
            onBlur={() => making.endGesture()}
          />
        </label>
      </div>
      <p class="fine-print">
        {words.value.maker.shape.about(plan.outline.length, fixed(signedArea(plan.outline), 1))}
      </p>
    </Section>
  );
}

/** What is wrong with what stands in the field for the size is told when the typing has ended, or the room is asked for. */
function useSizeFault() {
  const making = useMaking();
  const field = useRef<HTMLInputElement>(null);
  const [isTold, setTold] = useState(false);
  const fault = making.sizeFault.value;
  const refusals = making.refusals.value;
  useEffect(() => {
    if (making.sizeFault.peek() === null) return;
    setTold(true);
    field.current?.scrollIntoView({ block: 'center' });
    field.current?.focus({ preventScroll: true });
  }, [refusals]);
  useEffect(() => () => void (making.sizeFault.value = null), [making]);
  const setFault = (next: SizeFault | null) => {
    making.sizeFault.value = next;
    if (next === null) setTold(false);
  };
  return { field, fault, told: isTold ? fault : null, setFault, tell: () => setTold(fault !== null) };
}

/** "6 x 4 x 2.8" */
function SizeField() {
  const making = useMaking();
  const [text, setText] = useState('');
  const [shape, setShape] = useState<RoomPlan['outline'] | null>(null); // as it was before anything was typed
  const typed = useRef<RoomPlan | null>(null); // the plan as it was typed
  const { field, fault, told, setFault, tell } = useSizeFault();
  const plan = making.plan.value;
  useEffect(() => {
    if (typed.current === null || typed.current === plan) return;
    typed.current = null; // taken back, or changed in another way
    setText('');
    setShape(null);
    setFault(null);
  }, [plan]);
  const example = `6 x 4 x ${shortest(2.8)}`;
  const take = (next: string) => {
    setText(next);
    if (next.trim() === '') return setFault(null);
    const read = readSize(next);
    if (!read.size) return setFault(read.fault);
    const { width, depth, height } = read.size;
    const before = shape ?? making.plan.peek().outline;
    setShape(before);
    const isTaken = making.edit(
      (plan) => ({ ...plan, outline: resized(before, [width, depth]), height }),
      'size',
    );
    typed.current = making.plan.peek();
    setFault(isTaken ? null : 'outside');
  };
  const end = () => {
    tell();
    setShape(null);
    making.endGesture();
  };
  return (
    <div>
      <label class="maker-field wide">
        <span>{words.value.maker.shape.size}</span>
        <input
          ref={field}
          type="text"
          class="maker-text"
          autoFocus
          maxLength={60}
          spellcheck={false}
          autoComplete="off"
          placeholder={example}
          aria-invalid={fault !== null}
          aria-describedby={told ? 'maker-size-fault' : undefined}
          value={text}
          onInput={(event) => take(event.currentTarget.value)}
          onBlur={end}
          onKeyDown={(event) => event.key === 'Enter' && tell()}
        />
      </label>
      {told && (
        <p class="fault" id="maker-size-fault" role="alert">
          {sizeFaultText(told, text.trim(), example)}
        </p>
      )}
    </div>
  );
}

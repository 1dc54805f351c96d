/** The working plane with its rim, and task areas within the room. */
import { Plus, SquareDashed } from 'lucide-preact';
import type { RoomPlan } from '../../room-maker/room-plan.mjs';
import { toMillimetres, withTask } from '../../room-maker/plan-edits.ts';
import { Check } from '../controls/check.tsx';
import { Field, Section } from './field.tsx';
import { useMaking } from './making-context.ts';
import { words } from '../../language/language.ts';

const usualPlane = { height: 0.75, rim: 0.5 };

function middleOf({ outline }: RoomPlan): [number, number] {
  const mean = (axis: 0 | 1) => outline.reduce((sum, corner) => sum + corner[axis], 0) / outline.length;
  return [toMillimetres(mean(0)), toMillimetres(mean(1))];
}

export function PlaneSection() {
  const making = useMaking();
  const { plane } = making.plan.value;
  const change = (part: Partial<typeof usualPlane>, gesture: string) =>
    making.edit((plan) => ({ ...plan, plane: { ...(plan.plane ?? usualPlane), ...part } }), gesture);
  const addTask = () => {
    making.edit((plan) => withTask(plan, middleOf(plan), [1.6, 0.8]));
    making.selected.value = { what: 'task', index: making.plan.peek().tasks.length - 1 };
  };
  return (
    <Section title={words.value.maker.plane.title}>
      <Check
        label={words.value.maker.plane.working}
        checked={plane !== null}
        set={(on) => making.edit((plan) => ({ ...plan, plane: on ? usualPlane : null }))}
      />
      {plane && (
        <div class="maker-grid">
          <Field
            label={words.value.maker.plane.height}
            spoken={words.value.maker.plane.heightOf}
            value={plane.height}
            max={50}
            step={0.05}
            onInput={(height, gesture) => change({ height }, gesture)}
          />
          <Field
            label={words.value.maker.plane.rim}
            spoken={words.value.maker.plane.rimOf}
            value={plane.rim}
            max={50}
            onInput={(rim, gesture) => change({ rim }, gesture)}
          />
        </div>
      )}
      <div class="row">
        <button class="button small" onClick={addTask}>
          <Plus size={14} aria-hidden />
          <span>{words.value.maker.plane.task}</span>
        </button>
        <button
          class="button small"
          aria-pressed={making.isPlaneDrawn.value}
          onClick={() => (making.isPlaneDrawn.value = !making.isPlaneDrawn.peek())}
        >
          <SquareDashed size={14} aria-hidden />
          <span>{words.value.maker.plane.draw}</span>
        </button>
      </div>
      {making.isPlaneDrawn.value && (
        <p class="fine-print" role="status">
          {words.value.maker.plane.drag}
        </p>
      )}
    </Section>
  );
}

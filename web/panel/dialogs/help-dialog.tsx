/** Keys, made from the registry of actions, and what the pointer does in the view. */
import { actions, type Action } from '../../app/actions.ts';
import { keyText } from '../../app/keyboard.ts';
import { Dialog } from './dialog.tsx';

const pointer: readonly [string, string][] = [
  ['Drag', 'orbit (one finger)'],
  ['Right or Shift drag', 'pan (two fingers)'],
  ['Wheel', 'zoom to the pointer'],
  ['Click', 'select a surface or a luminaire'],
  ['Double click', 'stand there, on the floor; else turn around that point'],
  ['Drag a luminaire', 'pin it elsewhere; the others compensate'],
  ['Luminaires, Keep out or Keep in', 'drag a rectangle in the plan where none, or all, may hang'],
  ['Arrows on a slider', 'one step; Shift × 10, Alt × 0.1'],
];

export function HelpDialog({ close }: { close: () => void }) {
  const groups = new Map<Action['group'], Action[]>();
  for (const action of actions)
    if (action.keys) groups.set(action.group, [...(groups.get(action.group) ?? []), action]);
  return (
    <Dialog title="Keys and help" class="wide" close={close}>
      <p>
        Pick a surface, choose a verb, drag its range: a search places the luminaires anew and the bounced
        light follows while you drag. Drag a luminaire by hand and it stays; the others make up for it.
      </p>
      <p class="fine-print">
        Computed: illuminance and exitance of matt surfaces under these luminaires, with all bounces, as means
        over patches. Not computed: shine, daylight and the time of day.
      </p>
      <div class="help-columns">
        <section>
          <h3>Pointer</h3>
          <dl class="keys">
            {pointer.map(([what, does]) => (
              <div key={what}>
                <dt>{what}</dt>
                <dd>{does}</dd>
              </div>
            ))}
          </dl>
        </section>
        {[...groups].map(([group, list]) => (
          <section key={group}>
            <h3>{group}</h3>
            <dl class="keys">
              {list.map((action) => (
                <div key={action.id}>
                  <dt>
                    <kbd>{keyText(action.keys?.[0] ?? '')}</kbd>
                  </dt>
                  <dd>{action.title}</dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
      </div>
    </Dialog>
  );
}

/** Keys, made from the registry of actions, and what the pointer does in the view. */
import { actions, type Action } from '../../app/actions.ts';
import { keyText } from '../../app/keyboard.ts';
import { Dialog } from './dialog.tsx';
import { words } from '../../language/language.ts';

const pointer: readonly [() => string, () => string][] = [
  [() => words.value.dialogs.help.drag.what, () => words.value.dialogs.help.drag.does],
  [() => words.value.dialogs.help.pan.what, () => words.value.dialogs.help.pan.does],
  [() => words.value.dialogs.help.wheel.what, () => words.value.dialogs.help.wheel.does],
  [() => words.value.dialogs.help.click.what, () => words.value.dialogs.help.click.does],
  [() => words.value.dialogs.help.doubleClick.what, () => words.value.dialogs.help.doubleClick.does],
  [() => words.value.dialogs.help.paint.what, () => words.value.dialogs.help.paint.does],
  [() => words.value.dialogs.help.luminaire.what, () => words.value.dialogs.help.luminaire.does],
  [() => words.value.dialogs.help.area.what, () => words.value.dialogs.help.area.does],
  [() => words.value.dialogs.help.arrangement.what, () => words.value.dialogs.help.arrangement.does],
  [() => words.value.dialogs.help.verdict.what, () => words.value.dialogs.help.verdict.does],
  [() => words.value.dialogs.help.report.what, () => words.value.dialogs.help.report.does],
  [() => words.value.dialogs.help.arrows.what, () => words.value.dialogs.help.arrows.does],
];

export function HelpDialog({ close }: { close: () => void }) {
  const groups = new Map<Action['group'], Action[]>();
  for (const action of actions)
    if (action.keys) groups.set(action.group, [...(groups.get(action.group) ?? []), action]);
  return (
    <Dialog title={words.value.actions.help} class="wide" close={close}>
      <p>{words.value.dialogs.help.how}</p>
      <p class="fine-print">{words.value.dialogs.help.scope}</p>
      <div class="help-columns">
        <section>
          <h3>{words.value.dialogs.help.pointer}</h3>
          <dl class="keys">
            {pointer.map(([what, does]) => (
              <div key={what()}>
                <dt>{what()}</dt>
                <dd>{does()}</dd>
              </div>
            ))}
          </dl>
        </section>
        {[...groups].map(([group, list]) => (
          <section key={group}>
            <h3>{words.value.actions.groups[group]}</h3>
            <dl class="keys">
              {list.map((action) => (
                <div key={action.id}>
                  <dt>
                    <kbd>{keyText(action.keys?.[0] ?? '')}</kbd>
                  </dt>
                  <dd>{action.title()}</dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
      </div>
    </Dialog>
  );
}

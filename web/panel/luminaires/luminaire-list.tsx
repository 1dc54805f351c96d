/** The luminaires of the picture as a list: select, pin, and move with the arrow keys; the keyboard's twin of the view. */
import { Pin, SquareDashedMousePointer } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { compact } from '../../app/words/format.ts';
import { inPlan, placeText } from '../../document/plan-frame.ts';
import { isInOrder, readingOrder } from '../../document/reading-order.ts';
import { positionOf } from '../../document/sites.ts';
import type { LuminaireType } from '../../document/types.ts';
import { steps } from '../selection-bar.tsx';
import { typeText } from '../../language/type-names.ts';
import { words } from '../../language/language.ts';

export function LuminaireList() {
  const { store, hand, viewer } = useApp();
  const frame = viewer.frame();
  const scene = store.scene.value;
  const layout = store.shown.value?.layout;
  if (!scene || !layout || !frame) return null;
  const { pinned, types = [], ofType = [] } = store.document.value.luminaires;
  const allowed = scene.hasOperator ? types.filter(({ isAllowed }) => isAllowed) : [];
  const selected = store.luminaires.value;
  const move = (luminaire: number) => (event: KeyboardEvent) => {
    if (event.shiftKey && (event.key === ' ' || event.key === 'Enter')) {
      event.preventDefault();
      return hand.pick(luminaire, 'also');
    }
    const step = steps.find(({ key }) => key === event.key);
    if (!step) return;
    event.preventDefault();
    hand.step(luminaire, step.direction);
  };
  return (
    <table class="list">
      <caption>
        {words.value.luminaires.list.name} <small class="keys-only">{words.value.luminaires.list.keys}</small>
      </caption>
      <Head hasTypes={allowed.length > 1} />
      <tbody>
        {layout.sites.map((site, index) => {
          const isPinned = pinned.includes(site);
          const isSelected = selected.includes(index);
          return (
            <tr key={index} class={isSelected ? 'selected' : ''}>
              <th scope="row">
                <button
                  class="tag"
                  aria-pressed={isSelected}
                  onClick={({ shiftKey, ctrlKey, metaKey }) => {
                    if (shiftKey || ctrlKey || metaKey) hand.pick(index, 'also');
                    else hand.pick(isSelected && selected.length === 1 ? null : index, 'alone');
                  }}
                  onKeyDown={move(index)}
                >
                  L{index + 1}
                </button>
              </th>
              <td>{placeText(inPlan(frame, positionOf(scene.sites, site)))}</td>
              <td class="number">{compact((layout.flux[index] ?? 0) * layout.dimming)}</td>
              {allowed.length > 1 && (
                <td>
                  <TypeChoice
                    luminaire={index}
                    allowed={allowed}
                    now={types.find(({ id }) => id === layout.mountings?.[index]?.type)}
                    asked={ofType[index] ?? null}
                  />
                </td>
              )}
              <td>
                <button
                  class="icon-button small"
                  aria-pressed={isPinned}
                  aria-label={
                    isPinned
                      ? words.value.luminaires.list.unpinOf(index + 1)
                      : words.value.luminaires.list.pinOf(index + 1)
                  }
                  onClick={() => hand.togglePin([index])}
                >
                  <Pin size={14} aria-hidden />
                </button>
              </td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}

function Head({ hasTypes }: { hasTypes: boolean }) {
  return (
    <thead>
      <tr>
        <th scope="col">{words.value.luminaires.list.tag}</th>
        <th scope="col" title={words.value.luminaires.list.placeTip(words.value.values.corner)}>
          {words.value.luminaires.list.place}
        </th>
        <th scope="col" class="number">
          lm
        </th>
        {hasTypes && <th scope="col">{words.value.luminaires.list.type}</th>}
        <th scope="col">{words.value.luminaires.list.pin}</th>
      </tr>
    </thead>
  );
}

/** Several luminaires are moved, pinned and removed as one. */
export function SelectSeveral() {
  const { store, hand, viewer } = useApp();
  const [scene, layout, frame] = [store.scene.value, store.shown.value?.layout, viewer.frame()];
  const order = scene && layout && frame && readingOrder(layout, scene.sites, frame);
  const { several, inPlan: ask, inPlanTip, all } = words.value.bars.selection;
  const isOn = store.drawing.value === 'select';
  const draw = () => {
    store.drawing.value = isOn ? null : 'select';
    if (!isOn && !viewer.camera().plan) viewer.view('plan');
  };
  return (
    <div class="row select-several" role="group" aria-label={several}>
      <button class="button small" aria-pressed={isOn} title={inPlanTip} onClick={draw}>
        <SquareDashedMousePointer size={14} aria-hidden />
        {ask}
      </button>
      <button class="button small" onClick={() => hand.pickIn(null)}>
        {all}
      </button>
      {order && !isInOrder(order) && (
        <button
          class="button small"
          title={words.value.luminaires.list.inOrderTip}
          onClick={() => hand.renumber(order)}
        >
          {words.value.luminaires.list.inOrder}
        </button>
      )}
    </div>
  );
}

interface TypeChoiceProps {
  readonly luminaire: number;
  readonly allowed: readonly LuminaireType[];
  readonly now: LuminaireType | undefined; // of the luminaire as it hangs
  readonly asked: string | null; // id of the type that it must be of
}

/** Of which type a luminaire is: as the search finds best, or of one. */
function TypeChoice({ luminaire, allowed, now, asked }: TypeChoiceProps) {
  const { hand } = useApp();
  return (
    <select
      class="type-choice"
      aria-label={words.value.luminaires.list.typeOf(luminaire + 1)}
      value={allowed.some(({ id }) => id === asked) ? (asked ?? '') : ''}
      onChange={(event) => hand.setType(luminaire, event.currentTarget.value || null)}
    >
      <option value="">
        {now ? words.value.luminaires.list.anyNow(typeText(now)) : words.value.luminaires.list.any}
      </option>
      {allowed.map((type) => (
        <option key={type.id} value={type.id}>
          {typeText(type)}
        </option>
      ))}
    </select>
  );
}

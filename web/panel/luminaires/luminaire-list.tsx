/** The luminaires of the picture as a list: select, pin, and move with the arrow keys; the keyboard's twin of the view. */
import { Pin } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { compact } from '../../app/words/format.ts';
import { inPlan, placeText } from '../../document/plan-frame.ts';
import { positionOf } from '../../document/sites.ts';
import type { LuminaireType } from '../../document/types.ts';
import { steps } from '../selection-bar.tsx';
import { words } from '../../language/language.ts';

export function LuminaireList() {
  const { store, hand, viewer } = useApp();
  const frame = viewer.frame();
  const scene = store.scene.value;
  const layout = store.shown.value?.layout;
  if (!scene || !layout || !frame) return null;
  const { pinned, types = [], ofType = [] } = store.document.value.luminaires;
  const allowed = scene.hasOperator ? types.filter(({ isAllowed }) => isAllowed) : [];
  const move = (luminaire: number) => (event: KeyboardEvent) => {
    const step = steps.find(({ key }) => key === event.key);
    if (!step) return;
    event.preventDefault();
    hand.step(luminaire, step.direction);
  };
  return (
    <table class="list">
      <caption>
        Luminaires in place <small class="keys-only">(arrow keys on a tag move it in plan)</small>
      </caption>
      <thead>
        <tr>
          <th scope="col">Tag</th>
          <th scope="col" title={`East, north and up from the ${words.value.values.corner}`}>
            Place: x, y, z (m)
          </th>
          <th scope="col" class="number">
            lm
          </th>
          {allowed.length > 1 && <th scope="col">Type</th>}
          <th scope="col">Pin</th>
        </tr>
      </thead>
      <tbody>
        {layout.sites.map((site, index) => {
          const isPinned = pinned.includes(site);
          const isSelected = store.luminaire.value === index;
          return (
            <tr key={index} class={isSelected ? 'selected' : ''}>
              <th scope="row">
                <button
                  class="tag"
                  aria-pressed={isSelected}
                  onClick={() => (store.luminaire.value = isSelected ? null : index)}
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
                  aria-label={`${isPinned ? 'Unpin' : 'Pin'} L${index + 1}`}
                  onClick={() => hand.togglePin(index)}
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
      aria-label={`Type of L${luminaire + 1}`}
      value={allowed.some(({ id }) => id === asked) ? (asked ?? '') : ''}
      onChange={(event) => hand.setType(luminaire, event.currentTarget.value || null)}
    >
      <option value="">{now ? `any: ${now.name}` : 'any'}</option>
      {allowed.map(({ id, name }) => (
        <option key={id} value={id}>
          {name}
        </option>
      ))}
    </select>
  );
}

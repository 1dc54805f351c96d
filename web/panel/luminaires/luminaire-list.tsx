/** The luminaires of the picture as a list: select, pin, and move with the arrow keys; the keyboard's twin of the view. */
import { Pin } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { compact } from '../../app/words/format.ts';
import { cornerName, inPlan, placeText } from '../../document/plan-frame.ts';
import { positionOf } from '../../document/sites.ts';
import { steps } from '../selection-bar.tsx';

export function LuminaireList() {
  const { store, hand, viewer } = useApp();
  const frame = viewer.frame();
  const scene = store.scene.value;
  const layout = store.shown.value?.layout;
  if (!scene || !layout || !frame) return null;
  const { pinned } = store.document.value.luminaires;
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
          <th scope="col" title={`East, north and up from the ${cornerName}`}>
            Place: x, y, z (m)
          </th>
          <th scope="col" class="number">
            lm
          </th>
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

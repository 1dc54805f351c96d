/** Which place of a building is to be lit: the whole of it, a storey, a space. */
import type { PlaceQuestion } from '../../app/state/store.ts';
import { words } from '../../language/language.ts';
import { fixed } from '../../language/numbers.ts';
import { Dialog } from './dialog.tsx';

export function PlaceDialog({
  question: { building, places, answer },
}: {
  readonly question: PlaceQuestion;
}) {
  const text = words.value.dialogs.place;
  return (
    <Dialog title={text.name(building)} close={() => answer(null)}>
      <p>{text.about}</p>
      <ul class="preset-list place-list">
        {places.map(({ kind, name, size }, index) => (
          <li key={index} class={kind}>
            <button onClick={() => answer(index)}>
              <strong>{name || text[kind]}</strong>
              <span>{size ? text.size(fixed(size[0], 1), fixed(size[1], 1)) : name && text[kind]}</span>
            </button>
          </li>
        ))}
      </ul>
    </Dialog>
  );
}

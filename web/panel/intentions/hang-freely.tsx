/** The way out of an arrangement that leaves few layouts, or only one. */
import { useApp } from '../../app/app.ts';
import { words } from '../../language/language.ts';

export function HangFreely() {
  const { store, comparing } = useApp();
  if ((store.document.value.luminaires.arrangement?.rule ?? 'free') === 'free') return null;
  return (
    <button class="button small" onClick={() => void comparing.choose('free')}>
      {words.value.intentions.hangFreely}
    </button>
  );
}

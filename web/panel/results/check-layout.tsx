/** The button that recomputes every surface of the layout shown from its patches, and what that has found. */
import { ScanSearch } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { checkText } from '../../app/words/layout-check.ts';
import { words } from '../../language/language.ts';

export function CheckLayout() {
  const { store, solving } = useApp();
  const check = store.check.value;
  const isCurrent = check !== null && check.layout === store.shown.value?.layout;
  return (
    <div class="check-layout">
      <button
        class="button small"
        disabled={store.progress.value.state === 'improving'}
        title={words.value.results.check.tip}
        onClick={() => solving.check()}
      >
        <ScanSearch size={14} aria-hidden />
        {words.value.results.check.button}
      </button>
      <p class="fine-print" aria-live="polite">
        {isCurrent && checkText(check, store.document.value, store.traced.value.origins)}
      </p>
    </div>
  );
}

/** What the solver does, in one quiet line. */
import { RefreshCw } from 'lucide-preact';
import { useApp } from '../app/app.ts';
import { count, duration } from '../app/words/format.ts';
import { provedOf } from '../app/words/proved.ts';
import { words } from '../language/language.ts';

// A proved bound further away than this says nothing that helps.
const loosest = 0.5;

export function StatusLine() {
  const { store, solving } = useApp();
  const { state, evaluations, milliseconds } = store.progress.value;
  const shown = store.shown.value;
  const bound = store.bound.value;
  const unmet = shown?.constraints.filter((result) => !result.met).length ?? 0;
  const isMet = shown !== null && unmet === 0;
  const isMissing = state === 'settled' && unmet > 0;
  const isTelling = state === 'settled' && isMet && bound !== null && bound.gap <= loosest;
  const proved = isTelling ? provedOf(bound.gap) : null;
  const took = duration(milliseconds);
  return (
    <footer class="status-line">
      <span class={`lamp ${isMissing ? 'unmet' : state}`} aria-hidden="true" />
      <span class="status-state">{words.value.panel.status[state]}</span>
      {evaluations > 0 && (
        <span class="status-figures" title={words.value.panel.status.took(took)}>
          <span>
            {words.value.panel.status.layouts(evaluations, count(evaluations))}
            {!proved && !isMissing && ` · ${took}`}
          </span>
        </span>
      )}
      {shown !== null && shown === store.exact.value?.shown && (
        <span
          class="status-exact"
          title={words.value.panel.status.exactBy(count(Math.round(store.exact.value.bytes / 1e6)))}
        >
          {words.value.panel.status.exact}
        </span>
      )}
      {isMissing && <span class="status-unmet">{words.value.panel.status.unmet(unmet)}</span>}
      {proved && (
        <span class={`status-bound ${proved.isNear ? 'near' : ''}`} title={words.value.panel.status.proved}>
          {proved.text}
        </span>
      )}
      <span class="spacer" />
      {(state === 'shown' || state === 'idle') && shown && (
        <button class="button small" onClick={() => solving.solve()}>
          <RefreshCw size={13} aria-hidden />
          {words.value.panel.status.resolve}
        </button>
      )}
    </footer>
  );
}

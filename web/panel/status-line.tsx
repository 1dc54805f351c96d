/** What the solver does, in one quiet line. */
import { RefreshCw } from 'lucide-preact';
import { useApp } from '../app/app.ts';
import { count, duration, percentAtMost } from '../app/words/format.ts';

const words = {
  idle: 'Not solved',
  improving: 'Improving',
  settled: 'Settled',
  shown: 'As given',
} as const;

// A proved bound further away than this says nothing that helps.
const loosest = 0.5;

export function StatusLine() {
  const { store, solving } = useApp();
  const { state, evaluations, milliseconds } = store.progress.value;
  const shown = store.shown.value;
  const bound = store.bound.value;
  const isMet = shown !== null && shown.violation === 0;
  const isTelling = state === 'settled' && isMet && bound !== null && bound.gap <= loosest;
  const took = duration(milliseconds);
  return (
    <footer class="status-line">
      <span class={`lamp ${state}`} aria-hidden="true" />
      <span class="status-state">{words[state]}</span>
      {evaluations > 0 && (
        <span class="status-figures" title={`in ${took}`}>
          {count(evaluations)} layouts
          {!isTelling && ` · ${took}`}
        </span>
      )}
      {isTelling && (
        <span class="status-bound" title="A proved bound: no layout can be better by more than this">
          within {percentAtMost(bound.gap)} of the best
        </span>
      )}
      <span class="spacer" />
      {(state === 'shown' || state === 'idle') && shown && (
        <button class="button small" onClick={() => solving.solve()}>
          <RefreshCw size={13} aria-hidden />
          Re-solve
        </button>
      )}
    </footer>
  );
}

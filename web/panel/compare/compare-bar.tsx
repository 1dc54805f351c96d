/** What is compared, how bright, and how to end it: over the picture while two lights are in it. */
import { ArrowLeftRight, Table2, X } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import type { Against } from '../../app/variants.ts';
import { words } from '../../language/language.ts';

const choices: readonly [Against, () => string][] = [
  ['kept', () => words.value.comparing.bar.kept],
  ['opened', () => words.value.comparing.bar.opened],
  ['scattered', () => words.value.comparing.bar.scattered],
  ['best', () => words.value.comparing.bar.best],
];

/** A bracket as photographers take it: darker, as it is, brighter; EV. */
const bracket = [-1, 0, 1];

export function CompareBar() {
  const app = useApp();
  const { store, variants } = app;
  const against = variants.against.value;
  if (!against || !store.other.value) return null;
  const { mode, exposure } = store.display.value;
  return (
    <div class="compare-bar" role="toolbar" aria-label={words.value.comparing.bar.name}>
      <select
        aria-label={words.value.comparing.bar.with}
        value={against}
        onChange={(event) => variants.compare(event.currentTarget.value as Against)}
      >
        {choices.map(([id, title]) => (
          <option key={id} value={id} disabled={!variants.isThere(id)}>
            {title()}
          </option>
        ))}
      </select>
      {mode === 'realistic' && (
        <div class="segments" role="group" aria-label={words.value.comparing.bar.exposure}>
          {bracket.map((ev) => (
            <button key={ev} aria-pressed={exposure === ev} onClick={() => app.setDisplay({ exposure: ev })}>
              {ev === 0 ? '0' : `${ev > 0 ? '+' : '−'}${Math.abs(ev)}`}
              {ev !== 0 && <span class="wide-only"> EV</span>}
            </button>
          ))}
        </div>
      )}
      {against === 'kept' && (
        <button
          class="icon-button"
          aria-label={words.value.comparing.bar.switch}
          title={words.value.actions.comparing.switch}
          onClick={() => variants.switch()}
        >
          <ArrowLeftRight size={16} aria-hidden />
        </button>
      )}
      <button
        class="icon-button"
        aria-label={words.value.comparing.bar.table}
        title={words.value.comparing.bar.table}
        onClick={() => (store.tab.value = 'results')}
      >
        <Table2 size={16} aria-hidden />
      </button>
      <button
        class="icon-button"
        aria-label={words.value.comparing.bar.end}
        title={words.value.comparing.bar.end}
        onClick={() => variants.close()}
      >
        <X size={16} aria-hidden />
      </button>
    </div>
  );
}

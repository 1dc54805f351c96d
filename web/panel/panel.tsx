/** The panel: what is asked, what it is asked of, what comes of it; at phone width a sheet that rises from below. */
import { ChevronDown, ChevronUp } from 'lucide-preact';
import { useRef } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import type { Tab } from '../app/state/store.ts';
import { IntentionsTab } from './intentions/intentions-tab.tsx';
import { LuminairesTab } from './luminaires/luminaires-tab.tsx';
import { ResultsTab } from './results/results-tab.tsx';
import { StatusLine } from './status-line.tsx';
import { useSheet } from './use-sheet.ts';

const tabs: readonly [Tab, string][] = [
  ['intentions', 'Intentions'],
  ['luminaires', 'Luminaires'],
  ['results', 'Results'],
];

export function Panel() {
  const { store } = useApp();
  const root = useRef<HTMLElement>(null);
  const { sheet, raise, open, bar } = useSheet(root);
  const active = store.tab.value;
  const select = (tab: Tab) => {
    store.tab.value = tab;
    open();
  };
  const move = (event: KeyboardEvent) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const at = tabs.findIndex(([tab]) => tab === active);
    const next = tabs[(at + step + tabs.length) % tabs.length]?.[0] ?? active;
    select(next);
    document.getElementById(`tab-${next}`)?.focus();
  };
  return (
    <aside ref={root} class={`panel sheet-${sheet}`} aria-label="Intentions and results">
      <div class="tab-bar" {...bar}>
        <div class="tabs" role="tablist" aria-label="Panel" onKeyDown={move}>
          {tabs.map(([tab, title]) => (
            <button
              key={tab}
              id={`tab-${tab}`}
              role="tab"
              aria-selected={tab === active}
              aria-controls="tab-panel"
              tabIndex={tab === active ? 0 : -1}
              onClick={() => select(tab)}
            >
              {title}
              {tab === 'intentions' && <Unmet />}
            </button>
          ))}
        </div>
        <button
          class="icon-button small sheet-handle"
          aria-label={sheet === 'full' ? 'Lower the panel' : 'Raise the panel'}
          onClick={raise}
        >
          {sheet === 'full' ? <ChevronDown size={18} aria-hidden /> : <ChevronUp size={18} aria-hidden />}
        </button>
      </div>
      {/* Each tab begins at its top. */}
      <div
        key={active}
        class="tab-panel"
        id="tab-panel"
        role="tabpanel"
        aria-labelledby={`tab-${active}`}
        tabIndex={-1}
      >
        {active === 'intentions' && <IntentionsTab />}
        {active === 'luminaires' && <LuminairesTab />}
        {active === 'results' && <ResultsTab />}
      </div>
      <StatusLine />
    </aside>
  );
}

function Unmet() {
  const { store } = useApp();
  const count = store.shown.value?.constraints.filter((result) => !result.met).length ?? 0;
  if (count === 0 || store.progress.value.state === 'improving') return null;
  return (
    <span class="badge" aria-label={`${count} not met`}>
      {count}
    </span>
  );
}

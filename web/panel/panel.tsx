/** The panel: what is asked, what it is asked of, what comes of it; at phone width a sheet that rises from below. */
import { ChevronDown, ChevronUp } from 'lucide-preact';
import { useRef } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import type { Tab } from '../app/state/store.ts';
import { IntentionsTab } from './intentions/intentions-tab.tsx';
import { LuminairesTab } from './luminaires/luminaires-tab.tsx';
import { ResultsTab } from './results/results-tab.tsx';
import { useLater } from './controls/use-later.ts';
import { StatusLine } from './status-line.tsx';
import { useSheet } from './use-sheet.ts';
import { words } from '../language/language.ts';

const tabs: readonly Tab[] = ['intentions', 'luminaires', 'results'];

export function Panel() {
  const { store } = useApp();
  const root = useRef<HTMLElement>(null);
  const { sheet, raise, open, bar } = useSheet(root);
  const active = store.tab.value;
  const isPreview = store.preview.value !== null;
  const isUnlit = useLater(isPreview) || isPreview; // all of a tab is much to draw: the picture goes before
  const select = (tab: Tab) => {
    store.tab.value = tab;
    open();
  };
  const move = (event: KeyboardEvent) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const at = tabs.indexOf(active);
    const next = tabs[(at + step + tabs.length) % tabs.length] ?? active;
    select(next);
    document.getElementById(`tab-${next}`)?.focus();
  };
  return (
    <aside ref={root} class={`panel sheet-${sheet}`} aria-label={words.value.panel.name}>
      <div class="tab-bar" {...bar}>
        <div class="tabs" role="tablist" aria-label={words.value.panel.tabList} onKeyDown={move}>
          {tabs.map((tab) => (
            <button
              key={tab}
              id={`tab-${tab}`}
              role="tab"
              aria-selected={tab === active}
              aria-controls="tab-panel"
              tabIndex={tab === active ? 0 : -1}
              onClick={() => select(tab)}
            >
              {words.value.panel.tabs[tab]}
              {tab === 'intentions' && <Unmet />}
            </button>
          ))}
        </div>
        <button
          class="icon-button small sheet-handle"
          aria-label={sheet === 'full' ? words.value.panel.lower : words.value.panel.raise}
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
        {isUnlit ? <NoLight /> : <TabContent active={active} />}
      </div>
      {!isUnlit && <StatusLine />}
    </aside>
  );
}

function TabContent({ active }: { active: Tab }) {
  if (active === 'intentions') return <IntentionsTab />;
  return active === 'luminaires' ? <LuminairesTab /> : <ResultsTab />;
}

/** What the panel knew is of the room before, which is not on the screen. */
function NoLight() {
  return <p class="empty">{words.value.panel.noLight}</p>;
}

function Unmet() {
  const { store } = useApp();
  if (store.preview.value !== null) return null;
  const count = store.shown.value?.constraints.filter((result) => !result.met).length ?? 0;
  if (count === 0 || store.isOfBefore.value || store.progress.value.state === 'improving') return null;
  return (
    <span class="badge" aria-label={words.value.panel.unmet(count)}>
      {count}
    </span>
  );
}

/** Where the room is looked at from: the views that every room has, and those that a person keeps under a name. */
import { Trash2 } from 'lucide-preact';
import { useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import { mostViews } from '../document/schema.ts';
import type { ViewName } from '../viewer/types.ts';
import { Storeys } from './storeys.tsx';
import { words } from '../language/language.ts';

const views: readonly [ViewName, () => string][] = [
  ['plan', () => words.value.bars.views.plan],
  ['corner', () => words.value.bars.views.corner],
  ['north', () => words.value.bars.views.north],
  ['east', () => words.value.bars.views.east],
  ['south', () => words.value.bars.views.south],
  ['west', () => words.value.bars.views.west],
];

/** `chosen`: the room is looked at from elsewhere. */
export function Views({ chosen }: { readonly chosen: () => void }) {
  const app = useApp();
  return (
    <>
      <div class="view-grid of-views">
        {views.map(([name, title]) => (
          <button
            key={name}
            class="button small"
            onClick={() => {
              app.viewer.view(name);
              chosen();
            }}
          >
            {title()}
          </button>
        ))}
      </div>
      <p class="fine-print">{words.value.bars.views.hint}</p>
      <Storeys stood={chosen} />
      {app.store.scene.value && !app.store.preview.value && <KeptViews chosen={chosen} />}
    </>
  );
}

function KeptViews({ chosen }: { readonly chosen: () => void }) {
  const app = useApp();
  const [name, setName] = useState('');
  const kept = app.store.document.value.views ?? [];
  const keep = (event: Event) => {
    event.preventDefault();
    app.keepView(name.trim() || words.value.bars.views.usual(kept.length + 1));
    setName('');
  };
  return (
    <>
      {kept.length > 0 && (
        <ul class="kept-views" aria-label={words.value.bars.views.kept}>
          {kept.map((view) => (
            <li key={view.name} class="row">
              <button
                class="button small grow"
                onClick={() => {
                  app.viewer.flyTo(view.camera);
                  chosen();
                }}
              >
                {view.name}
              </button>
              <button
                class="icon-button small"
                aria-label={words.value.bars.views.forget(view.name)}
                onClick={() => app.forgetView(view.name)}
              >
                <Trash2 size={14} aria-hidden />
              </button>
            </li>
          ))}
        </ul>
      )}
      {kept.length < mostViews && (
        <form class="row keep-view" onSubmit={keep}>
          <input
            type="text"
            maxLength={40}
            placeholder={words.value.bars.views.usual(kept.length + 1)}
            aria-label={words.value.bars.views.nameOf}
            value={name}
            onInput={(event) => setName(event.currentTarget.value)}
          />
          <button class="button small" type="submit">
            {words.value.bars.views.keep}
          </button>
        </form>
      )}
    </>
  );
}

/** Every action by name (ARIA combobox with a list): type, arrows, Enter. */
import { useEffect, useRef, useState } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { actions, isEnabled, placesOf, type Action } from '../../app/actions.ts';
import { keyText } from '../../app/keyboard.ts';
import { Dialog } from './dialog.tsx';
import { words } from '../../language/language.ts';

/** Actions whose title holds every word that is typed, in the registry's order; those that begin so come first. */
export function matching(all: readonly Action[], query: string): Action[] {
  const wanted = query.trim().toLowerCase();
  const typed = wanted.split(/\s+/);
  const found = all.filter((action) => {
    const text = `${action.title()} ${words.value.actions.groups[action.group]}`.toLowerCase();
    return action.id !== 'palette' && typed.every((word) => text.includes(word));
  });
  const beginsSo = (action: Action) => action.title().toLowerCase().startsWith(wanted);
  return [...found.filter(beginsSo), ...found.filter((action) => !beginsSo(action))];
}

export function Palette({ close }: { close: () => void }) {
  const app = useApp();
  const [query, setQuery] = useState('');
  const [at, setAt] = useState(0);
  const list = useRef<HTMLUListElement>(null);
  const found = matching([...actions, ...placesOf(app)], query).filter((action) => isEnabled(action, app));
  const active = found[Math.min(at, found.length - 1)];
  useEffect(() => {
    list.current?.querySelector('[aria-selected="true"]')?.scrollIntoView({ block: 'nearest' });
  }, [active]);
  const run = (action: Action | undefined) => {
    close();
    action?.run(app);
  };
  const move = (event: KeyboardEvent) => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === 'Enter') run(active);
    else if (step) setAt((Math.min(at, found.length - 1) + step + found.length) % (found.length || 1));
    else return;
    event.preventDefault();
  };
  return (
    <Dialog title={words.value.actions.palette} class="palette" close={close}>
      <input
        type="text"
        role="combobox"
        aria-expanded="true"
        aria-controls="palette-list"
        aria-activedescendant={active && `palette-${active.id}`}
        aria-label={words.value.dialogs.palette.find}
        placeholder={words.value.dialogs.palette.prompt}
        autoFocus
        value={query}
        onInput={(event) => {
          setQuery(event.currentTarget.value);
          setAt(0);
        }}
        onKeyDown={move}
      />
      <ul id="palette-list" role="listbox" aria-label={words.value.dialogs.palette.list} ref={list}>
        {found.map((action) => (
          <li
            key={action.id}
            id={`palette-${action.id}`}
            role="option"
            aria-selected={action === active}
            onClick={() => run(action)}
          >
            <span>{action.title()}</span>
            <small>{words.value.actions.groups[action.group]}</small>
            {action.keys?.[0] && <kbd>{keyText(action.keys[0])}</kbd>}
          </li>
        ))}
      </ul>
      {found.length === 0 && <p class="empty">{words.value.dialogs.palette.none}</p>}
    </Dialog>
  );
}

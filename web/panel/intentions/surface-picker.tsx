/** Which surfaces a card is about: one, several, a family ("desk 1" to "desk 12"), or the whole room. */
import { ChevronDown, ChevronRight } from 'lucide-preact';
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { folded } from '../../app/rooms/families.ts';
import { eachText, namesText } from '../../app/words/places.ts';
import type { SurfaceNames } from '../../document/types.ts';
import { useDismiss } from '../controls/menu.tsx';
import { words } from '../../language/language.ts';
import { isFoundBy, surfaceText } from '../../language/surface-names.ts';

/** Inner nodes of the tree ("room" of "room/floor") that hold more than one surface. */
export function innerNodes(names: readonly string[]): string[] {
  const nodes = names
    .filter((name) => name.includes('/'))
    .map((name) => name.slice(0, name.lastIndexOf('/')));
  return [...new Set(nodes.filter((node, index) => nodes.indexOf(node) !== index))];
}

interface Props {
  readonly label: string;
  readonly names: SurfaceNames;
  readonly onChange: (names: SurfaceNames) => void;
}

/** "Surfaces: 12 × desk: desk 1, desk 2 ...": a name holds what is seen, so that it can be spoken to. */
function heard(label: string, names: SurfaceNames): string {
  const [seen, each] = [namesText(names), eachText(names)];
  return seen === each ? `${label}: ${seen}` : `${label}: ${seen}: ${each}`;
}

export function SurfacePicker({ label, names, onChange }: Props) {
  const { store } = useApp();
  const [open, setOpen] = useState(false);
  const [filter, setFilter] = useState('');
  const root = useRef<HTMLDivElement>(null);
  useDismiss(root, open, () => setOpen(false));
  // What is typed next is the name of a surface, and no key of the page: at once, not after the next picture is drawn.
  useLayoutEffect(() => {
    if (open) root.current?.querySelector<HTMLElement>('input')?.focus();
  }, [open]);
  const leaves = store.sceneWithAreas.value?.surfaces.map((surface) => surface.name) ?? [];
  const wanted = (name: string) => isFoundBy(filter, name);
  const found = leaves.filter(wanted);
  const nodes = innerNodes(leaves).filter(wanted);
  const isNoneFound = found.length + nodes.length === 0 && !wanted('all');
  const only = (next: SurfaceNames) => {
    onChange(next);
    setOpen(false);
    root.current?.querySelector<HTMLElement>('.picker-button')?.focus();
  };
  // Enter takes the first that is found.
  const firstFound = (): SurfaceNames => {
    const name = filter === '' ? undefined : found[0];
    return name === undefined ? names : [name];
  };
  const set = (some: readonly string[], on: boolean) => {
    const rest = names.filter((each) => !some.includes(each) && each !== 'all');
    const next = on ? [...rest, ...some] : rest;
    if (next.length > 0) onChange(next);
  };
  return (
    <div class="picker" ref={root}>
      <button
        class="picker-button"
        aria-expanded={open}
        aria-label={heard(label, names)}
        onClick={() => setOpen(!open)}
      >
        <span>{namesText(names)}</span>
        <ChevronDown size={14} aria-hidden />
      </button>
      {open && (
        <div class="picker-list" role="group" aria-label={label}>
          <input
            type="search"
            placeholder={words.value.intentions.picker.find}
            aria-label={words.value.intentions.picker.find}
            value={filter}
            onInput={(event) => setFilter(event.currentTarget.value)}
            onKeyDown={(event) => {
              if (event.key !== 'Enter') return;
              event.preventDefault(); // or the button that gets the focus is pressed by the same key, and opens again
              only(firstFound());
            }}
          />
          <div class="picker-scroll" tabIndex={-1}>
            {wanted('all') && (
              <button class="picker-group" onClick={() => only(['all'])}>
                {words.value.values.wholeRoom}
              </button>
            )}
            {nodes.map((node) => (
              <button key={node} class="picker-group" onClick={() => only([node])}>
                {surfaceText(node)}
              </button>
            ))}
            {folded(found, (name) => name).map(({ title, items }) =>
              items.length === 1 ? (
                <Choice key={title} title={title} of={items} {...{ names, set }} />
              ) : (
                <Family key={title} title={title} of={items} isFound={filter !== ''} {...{ names, set }} />
              ),
            )}
            {isNoneFound && <p class="fine-print">{words.value.intentions.picker.none}</p>}
          </div>
        </div>
      )}
    </div>
  );
}

interface ChoiceProps {
  readonly title: string;
  readonly of: readonly string[]; // one surface, or a whole family
  readonly names: SurfaceNames;
  readonly set: (some: readonly string[], on: boolean) => void;
}

function Choice({ title, of, names, set }: ChoiceProps) {
  const chosen = of.filter((name) => names.includes(name)).length;
  return (
    <label class="check">
      <input
        type="checkbox"
        checked={chosen === of.length}
        indeterminate={chosen > 0 && chosen < of.length}
        onChange={() => set(of, chosen < of.length)}
      />
      <span>{title}</span>
    </label>
  );
}

/** Every member at once, or one by one when it is opened. */
function Family({ isFound, ...choice }: ChoiceProps & { isFound: boolean }) {
  const [isOpened, setOpened] = useState(false);
  const isOpen = isOpened || isFound;
  const { title, of, names, set } = choice;
  return (
    <div class="picker-family">
      <div class="row">
        <Choice {...choice} />
        <button
          class="icon-button small"
          aria-expanded={isOpen}
          aria-label={words.value.intentions.picker.each(title)}
          onClick={() => setOpened(!isOpen)}
        >
          <ChevronRight size={14} aria-hidden class="twist" />
        </button>
      </div>
      {isOpen &&
        of.map((name) => <Choice key={name} title={surfaceText(name)} of={[name]} {...{ names, set }} />)}
    </div>
  );
}

/** Which surfaces a card is about: one, several, a family ("desk 1" to "desk 12"), or the whole room. */
import { ChevronDown } from 'lucide-preact';
import { useRef, useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import type { SurfaceNames } from '../document/types.ts';
import { useDismiss } from './menu.tsx';

/** "desk 1, desk 2, ..." in few words. */
export function namesText(names: SurfaceNames): string {
  if (names.length === 1) return names[0] === 'all' ? 'the whole room' : (names[0] ?? '');
  const families = new Set(names.map((name) => /^(.*\D)\s\d+$/.exec(name)?.[1]));
  const [family] = families;
  return families.size === 1 && family ? `${names.length} × ${family}` : names.join(', ');
}

/** Inner nodes of the tree ("room" of "room/floor") and families of numbered names, with what they stand for. */
export function groupsOf(names: readonly string[]): { title: string; names: readonly string[] }[] {
  const groups = new Map<string, string[]>();
  const families = new Map<string, string[]>();
  for (const name of names) {
    const slash = name.lastIndexOf('/');
    if (slash > 0) groups.set(name.slice(0, slash), [...(groups.get(name.slice(0, slash)) ?? []), name]);
    const family = /^(.*\D)\s\d+$/.exec(name)?.[1];
    if (family) families.set(family, [...(families.get(family) ?? []), name]);
  }
  return [
    ...[...groups].filter(([, list]) => list.length > 1).map(([title]) => ({ title, names: [title] })),
    ...[...families]
      .filter(([, list]) => list.length > 1)
      .map(([title, list]) => ({ title: `every ${title} (${list.length})`, names: list })),
  ];
}

interface Props {
  readonly label: string;
  readonly names: SurfaceNames;
  readonly onChange: (names: SurfaceNames) => void;
}

export function SurfacePicker({ label, names, onChange }: Props) {
  const { store } = useApp();
  const [open, setOpen] = useState(false);
  const [filter, setFilter] = useState('');
  const root = useRef<HTMLDivElement>(null);
  useDismiss(root, open, () => setOpen(false));
  const leaves = store.scene.value?.surfaces.map((surface) => surface.name) ?? [];
  const groups = groupsOf(leaves);
  const wanted = (name: string) => name.toLowerCase().includes(filter.toLowerCase());
  const only = (next: SurfaceNames) => {
    onChange(next);
    setOpen(false);
  };
  const toggle = (name: string) => {
    const rest = names.filter((each) => each !== name && each !== 'all');
    const next = names.includes(name) ? rest : [...rest, name];
    if (next.length > 0) onChange(next);
  };
  return (
    <div class="picker" ref={root}>
      <button
        class="picker-button"
        aria-expanded={open}
        aria-label={`${label}: ${names.join(', ')}`}
        onClick={() => setOpen(!open)}
      >
        <span>{namesText(names)}</span>
        <ChevronDown size={14} aria-hidden />
      </button>
      {open && (
        <div class="picker-list" role="group" aria-label={label}>
          <input
            type="search"
            placeholder="Find a surface"
            aria-label="Find a surface"
            value={filter}
            onInput={(event) => setFilter(event.currentTarget.value)}
          />
          <div class="picker-scroll" tabIndex={-1}>
            {wanted('all') && (
              <button class="picker-group" onClick={() => only(['all'])}>
                the whole room
              </button>
            )}
            {groups
              .filter(({ title }) => wanted(title))
              .map((group) => (
                <button key={group.title} class="picker-group" onClick={() => only(group.names)}>
                  {group.title}
                </button>
              ))}
            {leaves.filter(wanted).map((name) => (
              <label key={name} class="check">
                <input type="checkbox" checked={names.includes(name)} onChange={() => toggle(name)} />
                <span>{name}</span>
              </label>
            ))}
          </div>
        </div>
      )}
    </div>
  );
}

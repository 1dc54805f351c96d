/** A button with a menu of actions (ARIA menu button pattern: arrows move, Escape closes). */
import type { LucideIcon } from 'lucide-preact';
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { isEnabled, type Action } from '../../app/actions.ts';
import { useApp } from '../../app/app.ts';
import { keyText } from '../../app/keyboard.ts';

export function Menu({
  label,
  icon: Icon,
  items,
}: {
  label: string;
  icon: LucideIcon;
  items: readonly Action[];
}) {
  const app = useApp();
  const [open, setOpen] = useState(false);
  const root = useRef<HTMLDivElement>(null);
  useDismiss(root, open, () => setOpen(false));
  // At once, not after the next picture is drawn: an arrow key may already be on its way.
  useLayoutEffect(() => {
    if (open) root.current?.querySelector<HTMLElement>('[role="menuitem"]:not(:disabled)')?.focus();
  }, [open]);

  const move = (event: KeyboardEvent) => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const entries = [
      ...(root.current?.querySelectorAll<HTMLElement>('[role="menuitem"]:not(:disabled)') ?? []),
    ];
    const at = entries.indexOf(document.activeElement as HTMLElement);
    entries[(at + step + entries.length) % entries.length]?.focus();
  };

  return (
    <div class="menu-root" ref={root}>
      <button
        class="icon-button"
        aria-label={label}
        title={label}
        aria-haspopup="menu"
        aria-expanded={open}
        onClick={() => setOpen(!open)}
      >
        <Icon size={17} aria-hidden />
      </button>
      {open && (
        <div class="menu" role="menu" aria-label={label} onKeyDown={move}>
          {items.map((action) => (
            <button
              key={action.id}
              role="menuitem"
              disabled={!isEnabled(action, app)}
              onClick={() => {
                setOpen(false);
                action.run(app);
              }}
            >
              <span>{action.title()}</span>
              {action.keys?.[0] && <kbd>{keyText(action.keys[0])}</kbd>}
            </button>
          ))}
        </div>
      )}
    </div>
  );
}

/** Closes something that floats when the pointer or the focus goes elsewhere, or on Escape (focus returns to its button). */
export function useDismiss(
  root: { readonly current: HTMLElement | null },
  open: boolean,
  close: () => void,
): void {
  useEffect(() => {
    if (!open) return;
    const leave = (event: Event) => {
      if (!root.current?.contains(event.target as Node)) close();
    };
    const escape = (event: KeyboardEvent) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      event.stopPropagation();
      close();
      root.current?.querySelector<HTMLElement>('[aria-haspopup], [aria-expanded]')?.focus();
    };
    document.addEventListener('pointerdown', leave);
    document.addEventListener('focusin', leave);
    document.addEventListener('keydown', escape, true);
    return () => {
      document.removeEventListener('pointerdown', leave);
      document.removeEventListener('focusin', leave);
      document.removeEventListener('keydown', escape, true);
    };
  }, [open]);
}

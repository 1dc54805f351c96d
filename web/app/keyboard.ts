/** Keys of the registry, wherever the focus is, except where a person is typing. */
import { isEnabled, type Action } from './actions.ts';
import type { App } from './app.ts';
import { words } from '../language/language.ts';

/** "Mod+Shift+Z" of an event; letters by what is on the key, so that other keyboard layouts work. */
export function keyOf(
  event: Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'shiftKey' | 'altKey'>,
): string {
  const isLetter = /^[a-z]$/i.test(event.key);
  const parts = [
    ...(event.ctrlKey || event.metaKey ? ['Mod'] : []),
    ...(event.altKey ? ['Alt'] : []),
    ...(event.shiftKey && (isLetter || event.key.length > 1) ? ['Shift'] : []),
    isLetter ? event.key.toUpperCase() : event.key,
  ];
  return parts.join('+');
}

const isTyping = (target: EventTarget | null) =>
  target instanceof HTMLElement &&
  (target.isContentEditable ||
    target instanceof HTMLTextAreaElement ||
    target instanceof HTMLSelectElement ||
    (target instanceof HTMLInputElement && !['checkbox', 'radio', 'range', 'button'].includes(target.type)));

/** Plain keys must not fire what the focused control means by them. */
const isControl = (target: EventTarget | null, key: string) =>
  target instanceof Element &&
  ((['Enter', ' '].includes(key) &&
    target.closest('button, a, summary, [role="option"], [role="tab"], input') !== null) ||
    (/^[0-9]$/.test(key) && target instanceof HTMLInputElement));

export function listenToKeys(app: App, actions: readonly Action[], isBlocked: () => boolean): () => void {
  const byKey = new Map(
    actions.flatMap((action) => (action.keys ?? []).map((key) => [key, action] as const)),
  );
  const listen = (event: KeyboardEvent) => {
    const key = keyOf(event);
    const action = byKey.get(key);
    if (!action || event.defaultPrevented || event.isComposing || isBlocked()) return;
    const isPlain = !key.startsWith('Mod+');
    if (isPlain && (isTyping(event.target) || isControl(event.target, key))) return;
    // note: while typing, Ctrl+Z undoes the typing.
    if (isTyping(event.target) && /^Mod\+(Shift\+)?[ZY]$/.test(key)) return;
    event.preventDefault();
    if (isEnabled(action, app)) action.run(app);
  };
  window.addEventListener('keydown', listen);
  return () => window.removeEventListener('keydown', listen);
}

const isMac = typeof navigator !== 'undefined' && /mac|iphone|ipad/i.test(navigator.platform);

/** "Mod+Shift+Z" as a person reads it. */
export function keyText(key: string): string {
  if (isMac) return key.replace('Mod', '⌘').replace('Shift', '⇧').replace('Alt', '⌥').replace(/\+/g, '');
  const { ctrl, shift, enter, delete: remove } = words.value.values.keys;
  const named: Readonly<Record<string, string>> = { Mod: ctrl, Shift: shift, Enter: enter, Delete: remove };
  return key
    .split('+')
    .map((part) => named[part] ?? part)
    .join('+');
}

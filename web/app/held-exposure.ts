/**
 * The exposure stays during a gesture, so that more light looks brighter; afterwards it adapts, visibly. A hand ends its
 * gesture when it lets go; keys do not say when they are done, so that theirs ends a while after the last of them.
 */
import { effect, signal } from '@preact/signals';
import type { Viewer } from '../viewer/types.ts';
import type { Store } from './state/store.ts';

const longest = 3000; // ms after the last key

export function holdDuringGestures({ history }: Store, viewer: Viewer): void {
  const isPressed = signal(false);
  const pressed = (is: boolean) => () => void (isPressed.value = is);
  // note: captured, for a press on a luminaire goes no further
  globalThis.addEventListener?.('pointerdown', pressed(true), true);
  for (const end of ['pointerup', 'pointercancel']) globalThis.addEventListener?.(end, pressed(false), true);
  // Not captured: a slider that is pressed takes the focus from another control, whose blur ends nothing.
  globalThis.addEventListener?.('blur', pressed(false));
  let timer: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    const isGesture = (history.value.past.at(-1)?.gesture ?? null) !== null;
    clearTimeout(timer);
    viewer.holdExposure(isGesture);
    if (isGesture && !isPressed.value) timer = setTimeout(() => viewer.holdExposure(false), longest);
  });
}

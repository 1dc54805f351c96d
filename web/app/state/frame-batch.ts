/** The latest of many changes, made once a frame and in one batch. */
import { batch } from '@preact/signals';

const perFrame = (action: () => void): void => {
  // A page in the background gets no frames; a timer takes over there.
  let done = false;
  const once = () => {
    if (!done) action();
    done = true;
  };
  requestAnimationFrame(once);
  setTimeout(once, 120);
};

/** Of all actions given until the next frame only the last is run. */
export function createFrameBatch(): (action: () => void) => void {
  let pending: (() => void) | null = null;
  return (action) => {
    const isFirst = pending === null;
    pending = action;
    if (!isFirst) return;
    perFrame(() => {
      const latest = pending;
      pending = null;
      batch(() => latest?.());
    });
  };
}

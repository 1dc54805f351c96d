/**
 * The page's address and its history. A link stays in the address as long as it tells what is on the screen; a change of
 * rooms is a step of the browser's history, so that Back returns to the room before.
 */

export function hasLink(): boolean {
  return (globalThis.location?.hash ?? '').length > 1;
}

const plain = (): string => location.pathname + location.search;

export function forgetLink(): void {
  if (hasLink()) history.replaceState(history.state, '', plain());
}

/** The room that a step of the browser's history shows; null where it is not one of ours. */
export function roomOfState(state: unknown): string | null {
  const { fiatlux } = (state ?? {}) as { fiatlux?: unknown };
  return typeof fiatlux === 'string' ? fiatlux : null;
}

/** The room that is on the screen now: a new step where it is another one than before. */
export function tellRoom(room: string): void {
  if (!globalThis.history) return;
  const present = roomOfState(history.state);
  if (present === room) return;
  const step = { fiatlux: room };
  if (present === null) history.replaceState(step, '', location.href);
  else history.pushState(step, '', plain());
}

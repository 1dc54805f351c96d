/**
 * The page's address and its history. A link stays in the address as long as it tells what is on the screen; a change of
 * rooms is a step of the browser's history, so that Back returns to the room before. What stands before the hash says
 * whether the page is only looked at (?embed), and which room it begins with (?room=, or the room's own page).
 */

export function hasLink(): boolean {
  return (globalThis.location?.hash ?? '').length > 1;
}

const query = (): URLSearchParams => new URLSearchParams(globalThis.location?.search ?? '');

/** What a page of scripts/room-pages.mjs is told about itself. */
const told = (name: string): string | null =>
  globalThis.document?.querySelector?.<HTMLMetaElement>(`meta[name="fiatlux:${name}"]`)?.content ?? null;

/** Shown inside another page: only looked at. Nothing is kept, and nothing comes from what this browser has kept. */
export function isEmbedded(): boolean {
  return query().has('embed');
}

/** The room that the address asks for, as documents call it; null where it leaves that open. */
export function wishedRoom(): string | null {
  return query().get('room') ?? told('room');
}

/** The address under which a room is shared: its own page, where the site has one. */
export function pageOf(room: string): string {
  const pages = told('pages')?.split(' ');
  const page = new URL(pages ? (pages.includes(room) ? `./${room}.html` : './') : '', location.href);
  page.search = page.hash = '';
  return page.href;
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

/** Whether the work on a room that this tab was left with is shown again: not where it went on to the page of another. */
export function isShownAgain(room: string, wished: string | null, state: unknown): boolean {
  return wished === null || room === wished || roomOfState(state) !== null; // a reload keeps its step of the history
}

/** The room that is on the screen now: a new step where it is another one than before. */
export function tellRoom(room: string): void {
  // An embedded page leaves the steps of the history to the page around it.
  if (!globalThis.history || isEmbedded()) return;
  const present = roomOfState(history.state);
  if (present === room) return;
  const step = { fiatlux: room };
  if (present === null) history.replaceState(step, '', location.href);
  else history.pushState(step, '', plain());
}

/** The link in the page's address: it stays there as long as it tells what is on the screen. */

export function hasLink(): boolean {
  return (globalThis.location?.hash ?? '').length > 1;
}

export function forgetLink(): void {
  if (hasLink()) history.replaceState(null, '', location.pathname + location.search);
}

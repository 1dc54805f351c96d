/**
 * What a reload needs and the browser's database cannot take in time: the work as it was when the page was left. It
 * belongs to one tab, so that several tabs do not get each other's work.
 */
import { readWork, writeWork, type Work } from './work.ts';

const key = 'fiatlux.reload';

/** Written at once, before the page is gone. */
export function keepForReload(work: Work): void {
  try {
    sessionStorage.setItem(key, writeWork(work));
  } catch {
    // No storage: what the database keeps is all there is.
  }
}

/** The work that this tab was left with, once; null where there is none. */
export function takeFromReload(): Work | null {
  try {
    const text = sessionStorage.getItem(key);
    sessionStorage.removeItem(key);
    return text === null ? null : readWork(text);
  } catch {
    return null;
  }
}

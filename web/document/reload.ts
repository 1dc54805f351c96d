/**
 * What a reload needs and the browser's database cannot take in time: the work as it was when the page was left. It
 * belongs to one tab, so that several tabs do not get each other's work.
 */
import { readProject, writeProject, type Project } from './project-file.ts';

const key = 'fiatlux.reload';

/** Written at once, before the page is gone. */
export function keepForReload(project: Project): void {
  try {
    sessionStorage.setItem(key, writeProject(project));
  } catch {
    // No storage: what the database keeps is all there is.
  }
}

/** The work that this tab was left with, once; null where there is none. */
export function takeFromReload(): Project | null {
  try {
    const text = sessionStorage.getItem(key);
    sessionStorage.removeItem(key);
    const project = text === null ? null : readProject(text);
    return typeof project === 'string' ? null : project;
  } catch {
    return null;
  }
}

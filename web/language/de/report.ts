/** The report that is printed. */
import type { Words } from '../en.ts';

export const report: Words['report'] = {
  notFetched: 'Der Bericht konnte nicht geladen werden. Besteht eine Verbindung?',
};

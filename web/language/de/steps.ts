/** What undo and redo call the steps of the work, and what is told about them. */
import type { Words } from '../en.ts';

export const steps: Words['steps'] = {
  keepOut: 'Fläche sperren',
  keepIn: 'Fläche zulassen',
  every: 'alle Vorgaben erfüllt',
  missed: (bounds) => `${bounds} nicht erfüllbar`,
  settledWith: (count, outcome) => `Fertig: ${count}${outcome}.`,
  newLight: (verdict) => `${verdict} (In Lux der Neuanlage.)`,
  resume: 'Fortsetzen',
  undo: 'Rückgängig',
};

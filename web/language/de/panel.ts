/** The frame of the panel: its tabs and the line of the solver. */
import { counted } from '../numbers.ts';
import type { Words } from '../en.ts';

export const panel: Words['panel'] = {
  status: {
    idle: 'Nicht gelöst',
    improving: 'Wird besser',
    settled: 'Fertig',
    shown: 'Wie vorgegeben',
    took: (time) => `in ${time}`,
    proved: 'Bewiesene Schranke: Keine Anordnung ist um mehr als dies besser',
    resolve: 'Neu lösen',
    layouts: (n, text) => `${text} ${n === 1 ? 'Anordnung' : 'Anordnungen'}`,
    unmet: (n) => `${counted(n, 'Vorgabe', 'Vorgaben')} nicht erfüllt`,
    within: (gap) => `bis auf ${gap} optimal`,
    best: 'bestmöglich, bewiesen',
    exact: 'exakt',
    exactBy: (megabytes) =>
      `Von dieser Anordnung wurde jede Reflexion berechnet, wie fiatlux light es tut; dafür hält die Seite ${megabytes} MB, bis sie geschlossen wird`,
  },
  tabs: { intentions: 'Ziele', luminaires: 'Leuchten', results: 'Ergebnisse' },
  name: 'Ziele und Ergebnisse',
  tabList: 'Bedienfeld',
  lower: 'Bedienfeld senken',
  raise: 'Bedienfeld heben',
  noLight:
    'Dieser Raum hat noch kein Licht. Ist es berechnet, steht hier, was verlangt wird; der vorige Raum bleibt erhalten und kehrt zurück, wenn die Vorschau geschlossen wird.',
  unmet: (count) => `${count} nicht erfüllt`,
};

/** Bereiche der Sehaufgabe im Grundriss. */
import type { Words } from '../en.ts';

export const areas: Words['areas'] = {
  name: 'Bereiche der Sehaufgabe',
  draw: 'Aufziehen …',
  drawTip: 'Ein Rechteck im Grundriss aufziehen',
  corners: 'Ecken …',
  cornersTip: 'Die Ecken im Grundriss anklicken',
  at: 'Einfügen …',
  middle: 'in der Raummitte',
  plane: 'Messebene …',
  planeTip: 'Eine Messebene im Grundriss zeichnen; danach wird der Raum mit ihr neu beleuchtet',
  planeNoModel: 'Das Modell dieses Raums liegt nicht vor: seine Datei noch einmal öffnen, dann zeichnen.',
  on: (surface) => `auf ${surface}`,
  empty: 'Der Bereich enthält keinen Punkt seiner Ebene: größer machen.',
  cornersOf: (count) => `${count} Ecken`,
  remove: (name) => `${name} entfernen`,
  rename: (name) => `${name} umbenennen`,
  nameOf: (name) => `Neuer Name von ${name}`,
  taken: (name) => `${name} gibt es schon.`,
  light: 'Licht fordern',
  lightTip:
    'Karten für die Sehaufgabe, das Band von 0,5 m darum und den Hintergrund, abgestuft wie in EN 12464-1',
  lightOf: (name) => `Mittelwert von ${name}`,
  wide: 'breit',
  deep: 'tief',
  reached: (mean, evenness) => `${mean} lx, Uₒ ${evenness}`,
  nothing: 'Unter dieser Fläche liegt weder eine Messebene noch der Boden.',
  enough: 'Mehr Bereiche kann ein Raum nicht haben.',
  added: (name, surface) => `${name} ist jetzt ein Teil von ${surface}.`,
  steps: {
    add: (name) => `${name} einfügen`,
    change: (name) => `${name} ändern`,
    remove: (name) => `${name} entfernen`,
    rename: (name) => `${name} umbenennen`,
    ask: (name) => `Licht auf ${name} fordern`,
  },
};

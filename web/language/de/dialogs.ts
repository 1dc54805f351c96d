/** The dialogues: rooms, share, help, palette, presets. */
import type { Words } from '../en.ts';

export const dialogs: Words['dialogs'] = {
  palette: {
    find: 'Aktion suchen',
    prompt: 'Was soll geschehen?',
    list: 'Aktionen',
    none: 'Keine Aktion heißt so.',
  },
  help: {
    how: 'Eine Fläche wählen, ein Verb wählen, den Regler ziehen: Eine Suche platziert die Leuchten neu, und das reflektierte Licht folgt beim Ziehen. Eine von Hand gezogene Leuchte bleibt, wo sie ist; die anderen gleichen aus.',
    scope:
      'Berechnet werden Beleuchtungsstärke und spezifische Lichtausstrahlung matter Flächen unter diesen Leuchten, mit allen Reflexionen, als Mittelwerte über kleine Teilflächen. Nicht berechnet werden Glanz, Tageslicht und Tageszeit.',
    pointer: 'Zeiger',
    drag: { what: 'Ziehen', does: 'drehen (ein Finger)' },
    pan: { what: 'Rechts oder Umschalt + Ziehen', does: 'verschieben (zwei Finger)' },
    wheel: { what: 'Rad', does: 'zum Zeiger hin zoomen' },
    click: { what: 'Klick', does: 'Fläche oder Leuchte wählen' },
    doubleClick: { what: 'Doppelklick', does: 'auf dem Boden: dort stehen; sonst: um diesen Punkt drehen' },
    luminaire: { what: 'Leuchte ziehen', does: 'anderswo fixieren; die anderen gleichen aus' },
    area: {
      what: 'Leuchten: Sperren oder Zulassen',
      does: 'im Grundriss ein Rechteck ziehen, in dem keine oder alle hängen dürfen',
    },
    arrows: { what: 'Pfeile am Regler', does: 'ein Schritt; Umschalt × 10, Alt × 0,1' },
  },
  language: 'Sprache',
};

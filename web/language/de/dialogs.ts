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
    paint: {
      what: 'Fläche anklicken, dann Farbe',
      does: 'anderer Reflexionsgrad; dort steht auch, welche Farbe am meisten hilft',
    },
    luminaire: { what: 'Leuchte ziehen', does: 'anderswo fixieren; die anderen gleichen aus' },
    area: {
      what: 'Leuchten: Sperren oder Zulassen',
      does: 'im Grundriss ein Rechteck ziehen oder Ecken anklicken: dort dürfen keine oder alle hängen',
    },
    arrangement: {
      what: 'Leuchten, Anordnung',
      does: 'frei, symmetrisch, in Reihen oder als ein Raster in der Mitte; darunter, wie viel Watt jede Anzahl braucht und ob sie genügt',
    },
    verdict: {
      what: 'Fertige Ziele',
      does: 'eine Raumart nach EN 12464-1 oder EN 1838 schreibt alle ihre Ziele; die Bewertung steht in den Ergebnissen oben',
    },
    report: {
      what: 'Datei und Export, Bericht',
      does: 'Bewertung, Plan und Leuchtenliste zum Drucken und Unterschreiben; DXF, STF und CSV für andere Programme',
    },
    arrows: { what: 'Pfeile am Regler', does: 'ein Schritt; Umschalt × 10, Alt × 0,1' },
  },
  copy: 'Kopieren',
  noCopy: 'Der Browser lässt die Seite nicht kopieren. Die Zeile ist markiert: Strg+C drücken.',
  close: 'Schließen',
  gallery: {
    newHint: 'Aus Maßen oder Grundriss: Wände, Fenster, Möbel, Plätze für Leuchten.',
    ownFile: 'Eine eigene Datei',
    ownFileHint:
      'Ein Modell (glTF, OBJ, FBX, DAE, 3DS, STL), ein Gebäude (IFC), ein Raum aus DIALux oder Relux (STF), eine ZIP davon, eine Szene (.flux) oder ein Projekt. Es bleibt auf diesem Rechner.',
    experiments: 'Experimente des Artikels, im E-Flur',
  },
  luminaires: {
    in: (name) => `Leuchten in ${name}`,
    find: 'Leuchte suchen',
    prompt: 'Suchen: Panel, Strahler, 24 Grad, Pendel …',
    open: 'Datei öffnen',
    none: 'Keine Leuchte heißt so.',
    beam: (degrees) => `Halbwertswinkel ${degrees}°`,
  },
  own: {
    name: 'Eigene Räume',
    where: 'Sie bleiben nur in diesem Browser.',
    taken: (where, taken, granted) => `${where} ${taken} von ${granted} sind belegt.`,
    mayGo: 'Ist der Datenträger voll, kann der Browser sie löschen: als .flux sichern, was bleiben soll.',
    deleted: (title) => `„${title}“ ist gelöscht.`,
    bringBack: 'Zurückholen',
    rename: (title) => `${title} umbenennen`,
    save: (title) => `${title} als .flux sichern`,
    delete: (title) => `${title} löschen`,
    nameOf: 'Name des Raums',
    doRename: 'Umbenennen',
  },
  place: {
    name: (building) => `Welcher Ort in „${building}“?`,
    about: 'Was dort liegt, wird für sich beleuchtet; der Rest des Gebäudes bleibt weg.',
    building: 'Das ganze Gebäude',
    storey: 'Geschoss',
    space: 'Raum',
    size: (width, depth) => `${width} × ${depth} m`,
  },
  presets: {
    noRoute: 'Zuerst den Rettungsweg als Sehaufgabenbereich zeichnen; beurteilt wird längs seiner Mitte.',
    noSurface: (title) => `Dieser Raum hat keine Fläche, von der „${title}“ verlangt werden könnte.`,
    name: 'Fertige Ziele',
    for: 'Für',
    check: '. Diese Zahlen sind ein Anfang; am eigenen Exemplar der Norm prüfen.',
    wholeRoom: 'Der ganze Raum: alle Ziele auf einmal',
    maintained: '; Wartungswerte',
  },
  share: {
    name: 'Diese Anordnung teilen',
    how: 'Wer den Link öffnet, sieht genau diese Anordnung, ihre Ziele und diese Ansicht. Nichts wird hochgeladen: Alles steht im Link.',
    link: 'Link',
    copied: 'Der Link ist in der Zwischenablage.',
    score: (points) => `Das Ergebnis geht mit: ${points} Punkte, der Solver hat 100.`,
    dare: (points) => `Mein Ergebnis: ${points} Punkte, der Solver hat 100. Geht es besser?`,
    holdsKept: 'A geht mit, zum Vergleichen. ',
    holdsRoom: 'Auch der Raum steht darin: Wer den Link öffnet, lässt ihn dort erstellen und berechnen.',
    namesRoom: (room) => `Er nennt den Raum „${room}“, enthält ihn aber nicht: die .flux-Datei mitsenden.`,
    send: 'Senden',
    characters: (count) => `${count} Zeichen.`,
    left: {
      one: (names) =>
        `Eine photometrische Datei ist zu lang für einen Link und darin nur genannt: ${names} mitsenden oder eine Projektdatei, die alles enthält.`,
      many: (names) =>
        `Photometrische Dateien sind zu lang für einen Link und darin nur genannt: ${names} mitsenden oder eine Projektdatei, die alles enthält.`,
    },
  },
  embed: {
    name: 'Einbetten',
    how: 'In einer eigenen Seite: der Raum zum Umsehen, ohne Bedienfeld.',
    label: 'HTML zum Einbetten',
    copy: 'HTML kopieren',
    copied: 'Das HTML ist in der Zwischenablage: in eine Seite einfügen.',
  },
};

/** Das Blatt, auf dem zu sehen und zu ändern ist, wie ein Modell verstanden wurde. */
import type { Words } from '../en.ts';

export const sheet: Words['sheet'] = {
  open: 'Wie es verstanden wurde',
  name: 'Wie das Modell verstanden wurde',
  title: (model) => `Wie „${model}“ verstanden wird`,
  close: 'Ohne Änderung schließen',
  light: 'So beleuchten',
  looking: 'Das Modell wird angesehen',
  size: {
    title: 'Größe',
    is: (width, depth, height) => `${width} × ${depth} m, ${height} m hoch`,
    unit: 'Einheit der Datei',
    guess: 'Raten',
    guessed: (unit) => `Geraten: ${unit}.`,
    other: (metres) => `${metres} m je Einheit`,
    metres: 'Meter',
    up: 'Welche Achse nach oben zeigt',
    upY: 'Y nach oben',
    upZ: 'Z nach oben',
  },
  place: {
    title: 'Teil des Gebäudes',
    whole: 'Alles wird beleuchtet.',
    pick: 'Einen Raum wählen',
    picking: 'Im Bild in einen Raum klicken.',
    stop: 'Jetzt nicht',
    only: 'Nur der angeklickte Raum wird beleuchtet.',
    doors: 'Räume hinter offenen Türen',
    doorsUnit: (count) => (count === 1 ? 'Tür' : 'Türen'),
    lid: 'Türen und Fenster verschließen',
    lids: { none: 'Nein', dark: 'Dunkel', white: 'Weiß' },
    again: 'Ein anderer Raum',
    all: 'Das ganze Gebäude',
  },
  mounts: {
    title: 'Leuchten hängen an',
    none: 'Nichts hier ist eine Decke: sie hängen in einer Ebene über dem größten Boden.',
    pick: 'Ein Klick auf eine Fläche im Bild nimmt sie dazu oder wieder weg.',
    surfaceOver: (area, height) => `${area} m², ${height} m über dem Boden`,
    plane: 'Stattdessen Ebene über dem Boden',
    planeHeight: 'Höhe der Ebene über dem Boden',
    proposed: 'Wie vorgeschlagen',
    noCeiling: 'Irgendwo müssen Leuchten hängen: statt der Ebene eine Fläche wählen.',
    last: (surface: string) =>
      `Irgendwo müssen Leuchten hängen: erst eine andere Fläche dazunehmen, dann ${surface} weg.`,
    storeys: 'Nur in einem Geschoss',
    storey: (number: number) => `Geschoss ${number}`,
    floorAt: (height: string) => `Decken über dem Boden auf ${height} m`,
  },
  luminaires: {
    title: 'Plätze der Leuchten',
    spacing: 'Von einer zur nächsten',
    size: 'Größe einer Leuchte',
    drop: 'Unter ihrem Träger',
    proposed: 'Vorschlag',
    asSpacing: 'gleich',
    asDrawn: 'wie gezeichnet',
    places: (count) =>
      count === 0
        ? 'Keine passt: kleinere Leuchten oder ein engeres Raster.'
        : count === 1
          ? '1 Platz für eine Leuchte'
          : `${count} Plätze für Leuchten`,
  },
  plane: {
    title: 'Nutzebene',
    wanted: 'Auf einer Ebene über dem Boden messen',
    height: 'Höhe über dem Boden',
    rim: 'Randzone, die wegbleibt',
    drawn: (name) => `Gezeichnet: ${name}`,
    border: 'Randzone, die wegbleibt',
    tooNarrow: 'Die Randzone lässt nichts von ihr übrig.',
    remove: (name) => `${name} entfernen`,
  },
  foreseen: (patches, size, time) =>
    `Etwa ${patches} Teilflächen von ${size} m: ungefähr ${time} auf diesem Rechner, ein erstes Bild früher.`,
  lost: {
    much: (percent) =>
      `Etwa ${percent} % des Lichts gingen verloren: es verlässt das Modell oder trifft Rückseiten.`,
    doubleSided: 'Flächen haben zwei Seiten',
  },
  materials: {
    title: 'Reflexionsgrade',
    reflectance: (material) => `Reflexionsgrad von ${material}`,
    byRole: 'je Fläche',
    byRoleTip: 'Noch ohne Farbe: Decken 70 %, Wände 50 %, Böden 20 %, anderes 40 %',
    byPicture: 'Bild',
    none: 'Keine Materialien: Decken reflektieren 70 %, Wände 50 %, Böden 20 %, anderes 40 %.',
    nameless: (index) => `Material Nr. ${index}`,
    more: (count) => `und ${count} weitere`,
  },
  remarks: 'Bemerkungen',
};

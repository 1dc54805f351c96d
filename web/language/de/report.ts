/** The report that is printed. */
import type { Words } from '../en.ts';

export const report: Words['report'] = {
  notFetched: 'Der Bericht konnte nicht geladen werden. Besteht eine Verbindung?',
  name: 'Bericht',
  print: 'Drucken oder als PDF sichern',
  close: 'Bericht schließen',
  picture: 'Der beleuchtete Raum aus der jetzigen Ansicht',
  head: {
    room: 'Raum',
    flux: 'Lichtstrom',
    power: 'Leistung',
    live: 'Diese Anordnung, live',
    noLink: 'Diese Anordnung passt nicht in einen Link.',
    code: 'QR-Code des Links',
  },
  verdicts: {
    name: 'Ziele',
    where: 'Wo',
    what: 'Was',
    target: 'Soll',
    actual: 'Ist',
    verdict: 'Bewertung',
    met: '✓ erfüllt',
    unmet: '✗ nicht erfüllt',
    wish: 'Wunsch',
  },
  schedule: {
    name: 'Leuchten',
    type: 'Typ',
    count: 'Anzahl',
    flux: 'lm je Stück',
    watts: 'W je Stück',
    mounting: 'Montage',
    square: (size) => `Lambert-Quadrat, ${size} m`,
    at: (facing, height) => `${facing} in ${height} m`,
    down: 'nach unten',
    up: 'nach oben',
    wall: 'an einer Wand,',
    aimed: 'ausgerichtet',
    tilted: (degrees) => `um ${degrees}° geneigt`,
    leaning: (how) => `${how}, montiert`,
    leaningOnWall: (how) => `an einer Wand, ${how},`,
  },
  plan: {
    label: 'Der Grundriss mit den Leuchten',
    caption: (corner) => `Grundriss: Leuchten und Maße; Koordinaten ab ${corner}`,
    north: 'N',
  },
  surfaces: {
    surface: 'Fläche',
    caption: (unit) => `Licht je Fläche, ${unit}`,
    mean: 'Mittel',
    min: 'min',
    max: 'max',
    signs: 'σ: Standardabweichung; Uₒ: dunkelste Stelle / Mittel; U_d: dunkelste / hellste Stelle',
  },
  rules: {
    all: (parts) => `Die Leuchten hängen nach Vorgabe: ${parts}.`,
    as: { symmetric: 'im Grundriss symmetrisch', rows: 'in Reihen', field: 'als regelmäßiges Feld' },
    apart: (metres) => `mindestens ${metres} m voneinander`,
    fromWalls: (metres) => `mindestens ${metres} m von Wänden`,
    areas: 'wo Flächen im Grundriss es zulassen',
  },
  basis: 'Worauf die Zahlen beruhen',
  record: 'Zum Nachvollziehen: wie gerechnet wurde',
  signature: { designed: 'Geplant von', checked: 'Geprüft von', place: 'Ort und Datum' },
  places: (corner) => `Orte der Leuchten: x, y, z in m ab ${corner}`,
  pointing: {
    luminaire: 'Leuchte',
    type: 'Typ',
    turn: 'Drehung',
    aim: 'Ausgerichtet auf',
    tilt: 'Neigung',
    azimuth: 'Azimut',
    turnSign:
      'Drehung: um die Normale der Montage ab deren Achse, an der Decke im Grundriss im Uhrzeigersinn.',
    aimSign: 'Neigung: gegen die Senkrechte nach unten. Azimut: im Grundriss ab Norden im Uhrzeigersinn.',
  },
  light: {
    caption: (name, height) =>
      `Beleuchtungsstärke auf „${name}“, ${height} m über dem Boden: Isoluxlinien in lx`,
    label: 'Das Licht im Grundriss, in Falschfarben mit Isoluxlinien',
    scale: 'Skala der Farben, lx',
  },
  assumptions: {
    scope:
      'Mit allen Reflexionen; Flächen sind matt, mit je einem Reflexionsgrad. Tageslicht und Glanz sind nicht berechnet.',
    files: 'Leuchten strahlen, wie ihre photometrischen Dateien sagen.',
    squares: 'Leuchten sind Lambert-Quadrate: Ein Produkt mit anderer Lichtverteilung gibt anderes Licht.',
    power: (efficacy) => `Leistung: ${efficacy} lm/W, wo ein Typ keine eigene nennt.`,
    leni: (value, hours, factors, standby) =>
      `LENI ${value} kWh/(m² a) nach EN 15193-1: ${hours} h bei Tag und Nacht; Fₒ, F_c, F_D ${factors}; Bereitschaft ${standby} kWh/(m² a).`,
    patches: (size) =>
      `σ, min, max, Uₒ und U_d gelten für Teilflächen von ${size} m: Kleinere Teilflächen zeigten mehr Kontrast.`,
    ownCopy: 'Zahlen aus Normen am eigenen Exemplar prüfen.',
  },
};

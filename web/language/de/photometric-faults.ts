/** What the readers of photometric files say. */
import type { photometricFaults as english } from '../en/photometric-faults.ts';

const fields = {
  lampLumens: 'der Lichtstrom je Lampe (-1 bei absoluter Photometrie)',
  multiplier: 'der Faktor der Lichtstärken',
  verticals: 'die Zahl der vertikalen Winkel',
  horizontals: 'die Zahl der horizontalen Winkel',
  type: 'der photometrische Typ (1 = C, 2 = B, 3 = A)',
  unit: 'die Einheit (1 = Fuß, 2 = Meter)',
  openingLength: 'eine Länge der Leuchtfläche',
  ballast: 'der Vorschaltgerätefaktor',
  afterBallast: 'die Zahl nach dem Vorschaltgerätefaktor',
  watts: 'die Anschlussleistung',
  vertical: 'der vertikale Winkel',
  horizontal: 'der horizontale Winkel',
  gamma: 'der Winkel Gamma',
  lamps: 'die Zahl der Lampen',
  lampSets: 'die Zahl der Lampensätze',
  aLampNumber: 'eine Zahl von Lampen',
  setFlux: 'der Lichtstrom eines Lampensatzes',
  setWatts: 'die Leistung eines Lampensatzes',
  typeIndicator: 'die Typkennzahl',
  symmetry: 'die Symmetriekennzahl',
  planes: 'die Zahl der C-Ebenen',
  planeDistance: 'der Abstand der C-Ebenen',
  gammas: 'die Zahl der Lichtstärken je Ebene',
  gammaDistance: 'der Abstand der Lichtstärken',
  luminaireLength: 'die Länge der Leuchte',
  luminaireWidth: 'die Breite der Leuchte',
  luminaireHeight: 'die Höhe der Leuchte',
  areaLength: 'eine Länge der leuchtenden Fläche',
  areaHeight: 'eine Höhe der leuchtenden Fläche',
  downward: 'der Anteil des unteren Lichtstroms',
  outputRatio: 'der Leuchtenbetriebswirkungsgrad',
  conversion: 'der Umrechnungsfaktor',
  tilt: 'die Neigung bei der Messung',
  directRatio: 'ein Direktanteil',
  intensity: 'eine Lichtstärke',
  measurement: 'die Nummer der Messung',
  tiltPosition: 'die Lage der Lampe (1, 2 oder 3) von TILT=INCLUDE',
  tiltAngles: 'die Zahl der Neigungswinkel',
  tiltAngle: 'ein Neigungswinkel',
  tiltFactor: 'ein Neigungsfaktor',
};

const kinds = {
  png: 'ein PNG-Bild',
  jpeg: 'ein JPEG-Bild',
  gif: 'ein GIF-Bild',
  webp: 'ein WebP-Bild oder ein Ton',
  bmp: 'ein BMP-Bild',
  tiff: 'ein TIFF-Bild',
  pdf: 'ein PDF-Dokument',
  model: 'ein 3D-Modell',
};

export const photometricFaults: typeof english = {
  atLine: (line, what) => `Zeile ${line}: ${what}`,
  ...fields,
  ...kinds,
  tableForeign: (kind) =>
    `Das ist ${kind}, keine photometrische Datei; die .ies- oder .ldt-Datei der Leuchte nehmen`,
  tableGzip: 'Das ist ein gzip-Archiv; zuerst entpacken',
  tableUtf16: 'Dieser Text ist UTF-16; als reinen Text (ANSI oder UTF-8) sichern',
  tablePage: 'Das ist eine Webseite; die photometrische Datei herunterladen, auf die sie verweist',
  tableXml: 'Dieses XML nennt keine .ies- oder .ldt-Datei; die des Herstellers nehmen',
  tableDialux: 'Das ist das eigene, geschlossene Format von DIALux (ULD); als EULUMDAT (.ldt) exportieren',
  tableRelux: 'Das ist das eigene, geschlossene Format von Relux (ROLF); als EULUMDAT (.ldt) exportieren',
  tableBinary:
    'Die Datei ist binär, kein photometrischer Text; aus .uld und .rolf (geschlossenen Formaten) EULUMDAT (.ldt) exportieren',
  tableLarge: (size) =>
    `Die Datei hat ${size} MB, mehr als die 4 MB der größten Tabelle; ist sie eine photometrische Datei?`,
  tableNeither:
    'Weder LM-63 (keine Zeile beginnt mit TILT) noch EULUMDAT (Zeilen 2 bis 7 sind keine Zahlen); die .ies- oder .ldt-Datei der Leuchte nehmen',
  tableNoTilt: 'Die Datei endet ohne eine Zeile TILT=, sie ist abgeschnitten; noch einmal herunterladen',
  tableLacksTilt: 'Vor diesen Zahlen fehlt die Zeile TILT=; darüber eine Zeile TILT=NONE einfügen',
  tableNoNumber: (found, what) => `Hier sollte ${what} stehen, ${found} ist keine Zahl; fehlt davor etwas?`,
  tableOutside: (what, value, least, most) =>
    `${what} ist ${value}, erlaubt ist ${least} bis ${most}; berichtigen oder die Datei noch einmal exportieren`,
  tableNotWhole: (what, value, least, most) =>
    `${what} ist ${value}, erlaubt ist eine ganze Zahl von ${least} bis ${most}; fehlt davor etwas?`,
  tableEnds: (what) =>
    `Die Datei endet, wo ${what} stehen sollte, sie ist abgeschnitten oder eine Zeile fehlt; noch einmal herunterladen`,
  tableOrder: (what, angle, before) =>
    `${what} ${angle} folgt auf ${before}: Winkel müssen steigen; passt ihre Anzahl zur Liste?`,
  tableNegative: (value) => `${value} cd: Lichtstärken können nicht negativ sein; den Wert berichtigen`,
  tableMore:
    'Es folgen mehr Zahlen, als die Anzahlen der Winkel ansagen; diese berichtigen oder die Datei noch einmal exportieren',
  tableNoFlux: 'Kein Lampensatz hat einen Lichtstrom; den Lichtstrom eines jeden in lm eintragen',
  tableOtherFlux: (told, held) =>
    `Laut Datei geben die Lampen ${told} lm, die Tabelle enthält ${held} lm; was stimmt?`,
  tableReach: (first, last) =>
    `Die Tabelle reicht nur von Gamma ${first} bis ${last}; außerhalb ist kein Licht`,
  tableTilted: (tilt) => `bei einer Neigung von ${tilt} Grad gemessen; gerechnet wie waagerecht aufgehängt`,
  tableOutput: (told, lamps, held, flux) =>
    `Laut Datei ${told} % des Lampenlichtstroms (${lamps} lm), laut Tabelle ${held} % (${flux} lm)`,
  tableDownward: (told, held) => `Laut Datei gehen ${told} % des Lichts nach unten, laut Tabelle ${held} %`,
  tableSymmetryPlanes: (symmetry, share, planes) =>
    `Symmetrie ${symmetry} verlangt eine durch ${share} teilbare Zahl von C-Ebenen, nicht ${planes} (Zeilen 3 und 4)`,
  tableSymmetryAngle: (symmetry, plane, angle) =>
    `Symmetrie ${symmetry} (Zeile 3) verlangt für C-Ebene ${plane} den Winkel ${angle}; die Symmetrie oder die Liste berichtigen`,
  tableSymmetryNone: 'Symmetrie 0 (Zeile 3) verlangt mindestens drei C-Ebenen',
  tableNoLamps: '0 Lampen; ihre Zahl eintragen, bei absoluter Photometrie eine negative',
  tableNegativeFlux: 'Der Lichtstrom je Lampe ist negativ; -1 oder einen Lichtstrom eintragen',
  tableNoFactor: (factor) =>
    `Die Faktoren der Lichtstärken und des Vorschaltgeräts ergeben ${factor}, was über 0 sein muss; die Datei noch einmal exportieren`,
  tableHorizontals: (first, last) =>
    `Die horizontalen Winkel gehen von ${first} bis ${last}; erlaubt sind 0 allein, von 0 bis 90, 180 oder 360 und von 90 bis 270`,
  tableBeam: 'Die Typen A und B verlangen mindestens zwei horizontale Winkel; als Typ C exportieren',
  tableBright: (value) =>
    `${value} cd sind mehr als 1e7; den Wert, den Faktor der Lichtstärken oder den Lampenlichtstrom berichtigen`,
  tableTilts:
    'Der Lichtstrom der Lampe hängt von der Neigung der Leuchte ab (TILT=INCLUDE); gerechnet wie ungeneigt aufgehängt',
  tableEmpty: 'Die Datei ist leer; noch einmal herunterladen',
  tableDark: 'Die Tabelle enthält kein Licht: jede Lichtstärke ist 0; die Datei noch einmal exportieren',
  tableGldf: 'Das ist ein GLDF-Container',
  tableZip: 'Das ist eine Zip-Datei',
  tableNothingIn: (container) =>
    `${container} ohne .ldt- oder .ies-Datei darin; beim Hersteller danach fragen`,
  tableUnzip: (container, files) => `${container}; entpacken und daraus ${files} nehmen`,
  tableProduct: (files) =>
    `Das ist die XML-Beschreibung eines GLDF-Produkts; die Datei nehmen, die sie nennt: ${files}`,
  tableOthers: (files) => `${files} und andere`,
};

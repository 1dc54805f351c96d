/** Opening, importing, computing and keeping rooms: what is said on the way and what goes wrong. */
import type { Words } from '../en.ts';

export const opening: Words['opening'] = {
  noLanguage:
    'Die Texte dieser Sprache konnten nicht geladen werden: Verbindung prüfen und noch einmal versuchen.',
  noRoom: 'Noch ist kein Raum geöffnet.',
  notStored:
    'Dieser Browser speichert die Arbeit nicht. Als Projektdatei oder Link sichern, damit sie bleibt.',
  opening: (name) => `${name} wird geöffnet`,
  lit: (title) => `„${title}“ hat Licht und steht unter den eigenen Räumen.`,
  asLastTime: (title) => `„${title}“ wird so verstanden wie beim letzten Mal.`,
  litFully: (title) => `${title} hat Licht in voller Qualität.`,
  moreRemarks: (count) => (count === 1 ? 'Noch ein Hinweis' : `Noch ${count} Hinweise`),
  about: (title, warning) => `„${title}“: ${warning}`,
  roomOffline: (room) =>
    `der Raum „${room}“ konnte nicht geladen werden: keine Verbindung; noch einmal versuchen`,
  roomMissing: (room) => `der Raum „${room}“ ist nicht auf diesem Server; mit npm run build erstellen`,
  firstOf: (count) => `Von ${count} Dateien wird die erste geöffnet.`,
  oneOfModels: (opened, others, more) =>
    `Von diesen Modellen ist „${opened}“ geöffnet; nicht geöffnet: ${others.replaceAll('“', '„').replaceAll('”', '“')}${more > 0 ? ` und ${more} weitere` : ''}. Ein anderes allein hineinziehen, um es zu beleuchten.`,
  tooLargeTogether: (name) =>
    `„${name}“ und die Dateien daneben sind zusammen größer als 256 MB; mehr kann der Browser nicht halten.`,
  tooLarge: (name) => `„${name}“ ist größer als 256 MB; mehr kann der Browser nicht halten.`,
  damagedMesh: 'ein komprimiertes Netz darin ist beschädigt: noch einmal exportieren, oder ohne Kompression',
  tooMuch: {
    node: (index) => `Knoten ${index}`,
    parts: (count, most) =>
      `es hat ${count} Teile, zeigen lassen sich hier ${most}: die eines Materials vereinen oder fiatlux precompute verwenden`,
    triangles: (count, most, name, percent) =>
      `es hat ${count} Dreiecke, beleuchten lassen sich hier ${most}: ${percent} % davon liegen in „${name}“; vereinfachen oder fiatlux precompute verwenden`,
    deep: (most) =>
      `seine Knoten liegen mehr als ${most} tief ineinander: ohne Verschachtelung neu exportieren`,
  },
  emptyFolder:
    'In diesem Ordner ist keine Datei: einen mit einem Modell, einer Szene oder Leuchten hierher ziehen.',
  unreadable: (name) => `„${name}“ konnte nicht vom Datenträger gelesen werden.`,
  notOurs: (name, models) =>
    `„${name}“ ist keine Datei von Fiat Lux: möglich sind Modelle (${models}, .zip), .stf, .flux, .ies, .ldt und Projektdateien.`,
  isOpenAndKept: (name) =>
    `„${name}“ ist geöffnet und von nun an einer der eigenen Räume. Die Datei bleibt auf diesem Rechner: Nichts wird hochgeladen.`,
  isOpen: (name) => `„${name}“ ist geöffnet. Die Datei bleibt auf diesem Rechner: Nichts wird hochgeladen.`,
  gone: (room) => `„${room}“ ist nicht mehr da: die Datei noch einmal öffnen.`,
  readable: 'Lesbares öffnen',
  lookingForRooms: 'Räume werden gesucht',
  again: 'Noch einmal versuchen',
  otherRoom: (room) => `Einen Raum „${room}“ gibt es hier nicht; dies ist ein anderer.`,
  openingRoom: 'Raum wird geöffnet',
  noSuchRoom: (room) => `es gibt keinen Raum „${room}“`,
  goingBack: 'Zurück',
  linkOfFile: (room) =>
    `Dieser Link handelt von „${room}“, einer Datei, die nicht zu dieser Seite gehört. Diese .flux-Datei hier öffnen, dann erscheint die Anordnung.`,
  solver: {
    noScript: 'sein Skript lässt sich nicht laden',
    stopped: (why) => `der Solver ist ausgefallen (${why})`,
    reload: (what) => `${what}; die Seite neu laden`,
    lost: 'die Verbindung ist abgebrochen',
    notArrived: (why) => `der Raum konnte nicht geladen werden: ${why}; noch einmal versuchen`,
    otherRoom: 'ein anderer Raum wurde geöffnet',
    whileReading: 'der Solver ist beim Lesen der Datei ausgefallen; noch einmal versuchen',
    whileLighting: 'der Solver ist beim Berechnen des Lichts ausgefallen; noch einmal versuchen',
  },
  openingLink: 'Link wird geöffnet',
  linkOutdated: (title) => `der Link wird nicht gezeigt: „${title}“ hat sich seitdem geändert`,
  linkNotMade: (why) => `Der Raum in diesem Link kann nicht erstellt werden: ${why}.`,
  otherVersion: (title) =>
    `Dieser Link wurde für eine andere Fassung von „${title}“ gemacht. In der jetzigen ist das Licht ein anderes.`,
  showAnyway: 'Trotzdem zeigen',
  openingProject: 'Projekt wird geöffnet',
  projectOfFile: (room) =>
    `dieses Projekt handelt von „${room}“, das nicht zu dieser Seite gehört; zuerst dessen .flux-Datei öffnen`,
  projectOutdated:
    'der Raum hat sich geändert, seit dieses Projekt gesichert wurde; seine Plätze passen nicht mehr',
  notReady: (title, waiting) => `„${title}“ ist noch nicht bereit: ${waiting}`,
  catalog: {
    offline: 'keine Verbindung',
    missing: 'scenes/catalog.json ist nicht auf diesem Server; mit npm run build erstellen',
    notJson: 'scenes/catalog.json ist kein JSON',
    unreadable: (fault) => `scenes/catalog.json ist nicht lesbar: ${fault}`,
    notLoaded: (why) => `Die Liste der Räume konnte nicht geladen werden: ${why}.`,
    notComputed: 'er konnte nicht berechnet werden',
    progress: (percent) => `wird berechnet, ${percent} %`,
  },
  own: {
    full: 'sein Speicher ist voll',
    refused: 'er speichert keine Dateien',
    notKept: (title, why) =>
      `„${title}“ wird in diesem Browser nicht behalten: ${why}. Den Raum als .flux sichern, damit er bleibt.`,
    gone: (title) => `„${title}“ ist nicht mehr im Speicher dieses Browsers`,
  },
  import: {
    noModel: 'unter diesen Dateien ist kein Modell',
    noCollada: 'es ist keine Collada-Datei',
    damaged: 'die Datei ist beschädigt oder nicht das, was ihr Name sagt',
    noReader: 'was solche Dateien liest, war nicht zu laden; die Verbindung prüfen und noch einmal versuchen',
    oldFbx: 'das FBX ist älter als Version 7 des Formats: neu exportieren',
    noSurfaces: 'es enthält keine Flächen',
    scaled: (widest, unit) => `Das Modell ist ${widest} Einheiten breit, darum gelten sie als ${unit}.`,
    theFile: 'Die Datei',
    anotherProgram: 'einem anderen Programm',
    noRoom: 'sie enthält keinen Raum',
    firstRoom: (count) => `Von ihren ${count} Räumen wird der erste geöffnet.`,
    unreadable: (name, why) => `„${name}“ ist nicht lesbar: ${why}.`,
    comesFrom: (name, cure) => `„${name}“ ist hier nicht lesbar. Sie kommt aus ${cure}.`,
    cures: {
      sketchUp:
        'SketchUp: als glTF (Datei, Exportieren, 3D-Modell, glTF) oder als Collada (.dae) exportieren',
      revit: 'Revit: als FBX exportieren (Datei, Exportieren, FBX)',
      rhino: 'Rhino: als glTF oder OBJ exportieren (Datei, Auswahl exportieren)',
      blender: 'Blender: als glTF exportieren (Datei, Exportieren, glTF 2.0)',
      other: 'dem Programm, das sie erstellt hat: als glTF oder FBX exportieren',
      cad: 'CAD: den Grundriss im Raumeditor zeichnen (Neuer Raum) oder ein 3D-Modell als FBX exportieren',
      bim: 'BIM: aus dem Ursprungsprogramm als .ifc (IFC-SPF) speichern',
      dialux: 'DIALux oder Relux: den Raum als STF (.stf) exportieren',
      cadModel: 'CAD: als glTF, OBJ oder STL exportieren',
    },
    zipDamaged: (name) => `„${name}“ ist eine beschädigte Zip-Datei; neu herunterladen.`,
    zipInZip: (name) =>
      `„${name}“ enthält eine weitere Zip-Datei: entpacken und die innere oder das Modell darin hierher ziehen.`,
    zipWithoutModel: (name, models) =>
      `„${name}“ enthält nichts, was sich öffnen lässt. Eine Zip-Datei kann ein Modell (${models}) mit seinen Texturen enthalten, einen Raum aus DIALux oder Relux (.stf), eine Szene (.flux) oder Leuchten (.ies, .ldt): eines davon exportieren und so oder als Zip hierher ziehen.`,
    zipMoreThan: (size) => `mehr als ${size}`,
    zipTooLarge: (name, size, count) =>
      `„${name}“ entpackt sich zu ${size} in ${count === 1 ? 'einer Datei' : `${count} Dateien`}: Unnötiges herausnehmen.`,
    ifc: {
      noIfc: 'sie ist keine IFC-Datei in STEP-Form (ISO-10303-21)',
      noGeometry: 'sie enthält keine Formen von Wänden, Böden oder Decken: mit Geometrie exportieren',
      tooMuch: 'sie enthält mehr als 5 Millionen Dreiecke: ein Geschoss davon exportieren',
      noLibrary: 'was IFC liest, konnte nicht geladen werden; Verbindung prüfen und erneut versuchen',
      broken: 'sie ist beschädigt oder zu groß für diesen Browser',
      luminaires: (count) =>
        count === 1
          ? 'Die Leuchte der Datei wurde weggelassen: ihr Platz wird neu gefunden.'
          : `Die ${count} Leuchten der Datei wurden weggelassen: ihre Plätze werden neu gefunden.`,
    },
    units: { millimetres: 'Millimeter', centimetres: 'Zentimeter' },
  },
  preview: {
    stages: {
      reading: 'Modell wird gelesen',
      casting: 'Licht wird ausgesandt',
      exchanging: 'Licht wird reflektiert',
      writing: 'Raum wird geschrieben',
    },
    name: 'Ein Raum ohne Licht',
    stopped: 'Die Berechnung wurde abgebrochen.',
    notUploaded: 'Nichts wurde hochgeladen.',
    working: 'Licht wird berechnet',
    of: (title) => `„${title}“: Vorschau`,
    lighting: (title) => `„${title}“: Licht`,
    full: 'Volle Qualität',
    left: (time) => `, noch etwa ${time}`,
    stays: '. Alles bleibt auf diesem Rechner.',
    edit: 'Raum bearbeiten',
    close: 'Vorschau schließen',
    stop: 'Berechnung abbrechen',
    lineCopied: 'Die Zeile ist in der Zwischenablage.',
    lineNotCopied: 'Der Browser lässt die Seite nicht kopieren: die Zeile markieren und kopieren.',
    command:
      'Der Befehl schafft es mit dem ganzen Speicher dieses Rechners; danach die .flux-Datei hier ablegen.',
    copy: 'Befehl kopieren',
    failed: (title) => `„${title}“ bekam kein Licht`,
    notFull: (title) => `„${title}“ bleibt eine Vorschau`,
    staysPreview: 'Zu sehen ist die Vorschau.',
    coarser: 'Mit größeren Teilflächen',
    long: (time, less) => `Insgesamt dauert das hier etwa ${time}, mit größeren Teilflächen etwa ${less}.`,
  },
  view: {
    notShown: (reason) => `Die Geometrie des Raums kann nicht gezeigt werden: ${reason}`,
    nothing: 'Der Raum hat keine Geometrie.',
    emptyCanvas: 'Das Bild konnte nicht gesichert werden: Die Zeichenfläche ist leer.',
  },
};

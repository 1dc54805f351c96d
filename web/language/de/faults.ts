/** What the solver, the builder and the readers of files say. */
import type { Words } from '../en.ts';
import { grouped } from '../numbers.ts';
import { photometricFaults } from './photometric-faults.ts';

/** Ways by which light leaves. */
const inGerman = (ways: string): string =>
  ways
    .replaceAll('to the west', 'nach Westen')
    .replaceAll('to the east', 'nach Osten')
    .replaceAll('to the north', 'nach Norden')
    .replaceAll('to the south', 'nach Süden')
    .replaceAll('upward', 'nach oben')
    .replaceAll('downward', 'nach unten')
    .replaceAll('in all directions', 'nach allen Seiten');

/** "1 mesh has", "3 meshes have". */
const withoutMaterial = (meshes: string, what: string): string =>
  meshes === '1 mesh has' ? `Ein Netz hat ${what}` : `${Number.parseInt(meshes, 10)} Netze haben ${what}`;

/** Surfaces in a list, with their areas: "'wall' 20.5 m2, 'floor' 3 m2 and 2 more". */
const listed = (names: string): string =>
  names
    .replace(/'([^']*)'/g, '„$1“')
    .replace(/(\d)\.(\d+) m/g, '$1,$2 m')
    .replaceAll(' m2', ' m²')
    .replaceAll(' m above the floor', ' m über dem Boden')
    .replace(', of other storeys ', ', in anderen Geschossen ')
    .replace(/ and (\d+) more$/, ' und $1 weitere');

const luminaires = (count: string): string =>
  `${count.replace(' to ', ' bis ')} ${count === '1' ? 'Leuchte' : 'Leuchten'}`;
const noKindOf = (what: string): string =>
  ({
    'regular field': 'kein regelmäßiges Feld',
    'symmetric layout': 'keine symmetrische Anordnung',
    'layout in rows': 'keine Anordnung in Reihen',
    layout: 'keine Anordnung',
  })[what] ?? `kein ${what}`;

export const faults: Words['faults'] = {
  ...photometricFaults,
  connectionLost:
    'Der Raum konnte nicht geladen werden, die Verbindung ist abgerissen; noch einmal versuchen',
  computationStopped: (why) => `Die Berechnung ist stehen geblieben (${why}); noch einmal versuchen`,
  noScript: 'ihr Skript kann nicht geladen werden',
  builderOffline: 'Was Licht berechnet, konnte nicht geladen werden: keine Verbindung; noch einmal versuchen',
  builderMissing:
    'Was im Browser Licht berechnet, ist noch nicht auf diesem Server; in ein paar Minuten noch einmal versuchen',
  sceneCut: (bytes) => `Die Raumdatei endet nach ${bytes} Byte; die Seite neu laden`,
  noCore: (code) =>
    `Das Rechenwerk (core.wasm) konnte nicht geladen werden (Status ${code}); die Seite neu laden`,
  coreOffline: 'das Rechenwerk (core.wasm) ist ohne Verbindung nicht zu laden',
  noRoom: 'Die Raumdatei enthält keinen Raum zum Ansehen; mit fiatlux precompute neu erzeugen',
  notUnderstood: (why) => `Die Datei wird nicht verstanden (${why}); noch einmal exportieren`,
  notFetched: (address) => `${address} konnte nicht geladen werden`,
  noScene: 'Das ist keine Raumdatei von Fiat Lux; sie entsteht mit fiatlux precompute',
  sceneNewer: (version, own) =>
    `Die Raumdatei hat Version ${version}, gelesen wird bis Version ${own}: ein neueres Fiat Lux nehmen oder die Datei neu erzeugen`,
  sceneDamaged: (where) => `Die Datei ist beschädigt: mit fiatlux precompute neu erzeugen (${where})`,
  glbCut: 'Die GLB-Datei ist abgeschnitten; noch einmal exportieren',
  glbEmpty: 'Die Datei ist leer; noch einmal exportieren',
  noGltf: 'Das ist weder GLB noch glTF-JSON in UTF-8; den Raum als .glb oder .gltf exportieren',
  extension: (name) =>
    `Die Datei verlangt die Erweiterung „${name}“, die hier nicht gelesen wird; ohne sie exportieren`,
  compressed: (name) =>
    `Die Datei verlangt die Erweiterung „${name}“, die hier nicht gelesen wird; ohne Kompression exportieren`,
  noTriangles:
    'Die Datei enthält keine Flächen: kein Dreieck ist darin; Netze exportieren, nicht Punkte oder Linien',
  allTransparent:
    'Die Datei enthält keine Flächen: alles ist durchsichtig oder eine Messebene; den Wänden ein undurchsichtiges Material geben',
  manyTriangles: (count, most) =>
    `Das Modell hat ${count} Dreiecke, höchstens ${most} Millionen sind möglich; die Netze vereinfachen`,
  pageMemory:
    'dieser Browser hat nicht genug Speicher: andere Seiten schließen oder größere Teilflächen nehmen',
  pageManyPatches: (needed, most, patches) =>
    `dafür wären ${needed} GB Speicher nötig, und eine Seite darf ${most} belegen: ${grouped(patches)} Teilflächen sind zu viele; größere nehmen, den Raum verkleinern oder den Befehl verwenden`,
  pageManyPlaces: (needed, most, places) =>
    `dafür wären ${needed} GB Speicher nötig, und eine Seite darf ${most} belegen: ${grouped(places)} Plätze für Leuchten sind zu viele; ein weiteres Raster nehmen, den Raum verkleinern oder den Befehl verwenden`,
  noMemory: 'Das Modell braucht mehr Speicher, als da ist; das Modell verkleinern',
  narrow: (width) =>
    `Der Raum ist nur ${width} m breit; die Einheit der Datei wählen (Wie es verstanden wurde)`,
  millimetres: (width) =>
    `Der Raum ist ${width} m breit, die Datei ist wohl in Millimetern; diese Einheit wählen (Wie es verstanden wurde)`,
  centimetres: (width) =>
    `Der Raum ist ${width} m breit, die Datei ist wohl in Zentimetern oder Millimetern; eine dieser Einheiten wählen (Wie es verstanden wurde)`,
  farNode: (name, metres) => `Knoten „${name}“ reicht bis ${metres} m vom Ursprung; seine Skalierung prüfen`,
  guessedUnit: (before, unit, after) =>
    `Als Meter gelesen wäre das Modell ${before}; es gilt als in ${unit} gezeichnet: ${after}`,
  guessedUp: (height, sizes) =>
    `Mit Y nach oben wäre das Modell ${height} m hoch; es gilt als mit Z nach oben gezeichnet: ${sizes}`,
  sizes: (width, depth, height) => `${width} × ${depth} m groß und ${height} m hoch`,
  inCentimetres: 'Zentimetern',
  inMillimetres: 'Millimetern',
  inInches: 'Zoll',
  inUnitsOf: (metres) => `Einheiten von ${metres} m`,
  inKilometres: 'Kilometern',
  onlyPlace: (where, sizes, kept, all) =>
    `Nur der Ort um ${where} bleibt, ${sizes}: ${kept} von ${all} Räumen, alles andere ist weggelassen`,
  noSuchPlace: (where) =>
    `Bei ${where} ist keine Luft, die zu einem Raum gehört; im Raum auf den Boden oder eine Wand klicken`,
  manyCells: (patch, cells) =>
    `Teilflächen von ${patch} m brauchen ${cells} Rasterzellen, mehr als der Speicher fasst; größere nehmen`,
  roomMemory: 'Nicht genug Speicher für diesen Raum; größere Teilflächen nehmen',
  lightMemory: 'Nicht genug Speicher für das Licht; größere Teilflächen nehmen',
  runMemory: 'Nicht genug Speicher; größere Teilflächen nehmen',
  noMaterial: (meshes, ceilings, walls, floors, others) =>
    `${withoutMaterial(meshes, 'kein Material')}: Decken gelten mit Reflexionsgrad ${ceilings}, Wände ${walls}, Böden ${floors}, anderes ${others}`,
  whiteMaterial: (meshes, name, ceilings, walls, floors, others) =>
    `${withoutMaterial(meshes, `kein Material außer Weiß („${name}“)`)}: Decken gelten mit Reflexionsgrad ${ceilings}, Wände ${walls}, Böden ${floors}, anderes ${others}`,
  smallNodes: (count, what) => `${count} Knoten: Die unter 0,5 % der Fläche sind ${what}`,
  partsOfRoom: 'der Boden, die Wände, die Decke oder die Dinge ihres Raums',
  oneSurface: (name) => `zusammen eine Fläche, „${name}“`,
  clusters: (edge, other, most) =>
    `Gruppen haben ${edge} × ${other} Teilflächen, damit es höchstens ${most} sind`,
  tooLow: (count, all, mount, drop) =>
    `${count} von ${all} Plätzen an „${mount}“ sind weggelassen: Etwas ist weniger als ${drop} m unter ihnen; weniger tief abhängen`,
  noSquare: (mount, size) =>
    `An „${mount}“ hat kein ganzes Quadrat von ${size} m Platz; die Plätze enger setzen`,
  nowhere: (names) =>
    `Leuchten können nirgends hängen: Nichts ist als Montageort markiert, nichts sieht auf einen Boden hinab, und über keinem Boden ist freier Raum; eine Fläche wählen (Wie es verstanden wurde), etwa ${names}`,
  noSite: (mount) =>
    `An keinem Montageort (${mount}) hat eine Leuchte Platz: die Plätze enger setzen oder einen anderen Ort wählen`,
  tooLarge: (sizes) => `${sizes} m sind zu viel, um Räume zu unterscheiden; einen Teil davon exportieren`,
  noSuchName: (name, names) =>
    `„${name}“: Kein Knoten und keine Fläche heißt so; am ähnlichsten sind ${names}`,
  noSuchMaterial: (name, which) => `„${name}“: Kein Material heißt so; ${which}`,
  noMaterials: 'das Modell hat keines',
  closest: (names) => `am ähnlichsten sind ${names}`,
  allWithoutArea:
    'Die Datei enthält keine Flächen: Alle Dreiecke sind ohne Flächeninhalt; die Skalierung der Knoten prüfen',
  clampedMore: (count, most, taken) =>
    `${count} weitere Materialien reflektieren mehr als ${most}; gerechnet wird mit ${taken}`,
  ofMaterial: (name) => `Material „${name}“`,
  clampedNode: (name, share, most) => `Knoten „${name}“: Reflexionsgrad ${share}; gerechnet wird mit ${most}`,
  clampedColour: (name) => `Material „${name}“: Seine Farbe liegt außerhalb von 0 bis 1 und wird begrenzt`,
  plainColour: (image, why) => `${image} ist ${why}: Es zählt die einfache Farbe des Materials`,
  imageOfMaterial: (index, name) => `Bild ${index} des Materials „${name}“`,
  pictureFormat: (format) => `${format}, das hier nicht gelesen wird (PNG oder JPEG nehmen)`,
  pictureUnknown: 'weder PNG noch JPEG',
  pictureDamaged: 'beschädigt',
  pictureLarge: (width, height) => `größer als ${width} × ${height} Pixel`,
  animated: 'Die Datei ist animiert: Sie steht in ihrer Ruhelage',
  skinned: 'Die Datei enthält Netze mit Gelenken: Sie stehen so, wie deren Ruhelage sie biegt',
  unbalanced: (share) =>
    `Die Bilanz des Lichts geht nicht auf (${share} des ausgesandten werden geschluckt): Sind Flächen doppelt gezeichnet?`,
  notSettled: (share) =>
    `Das reflektierte Licht ist nicht zur Ruhe gekommen (${share} fehlen): Es geht durch zu viele Räume; einen davon wählen (Wie es verstanden wurde)`,
  settledOnly: (share) => `Das reflektierte Licht ist nur auf ${share} genau, üblich ist 0,1 %`,
  numbersOff: (share) =>
    `Die Zahlen der Datei stimmen nur auf ${share}: Fast dunkle Flächen sind ein zu großer Teil von ihr; weniger Montageorte wählen (Wie es verstanden wurde)`,
  noArea: (count) => `Dreiecke ohne Fläche sind weggelassen: ${count}`,
  repeated: (count) => `Dreiecke, die andere wiederholen, sind weggelassen: ${count}`,
  proposedMount: (where) =>
    `Nichts ist als Montageort markiert: Leuchten sind vorgeschlagen an ${listed(where)}`,
  proposedPlane: (height, floor, area) =>
    `Nichts ist eine Decke: Leuchten sind vorgeschlagen in einer Ebene ${height} m über „${floor}“ (${area} m²)`,
  ceilingHeight: (height) => `Die Decke liegt ${height} m über dem Boden: Ist das so?`,
  ceilingInFeet: (height, metres) =>
    `Die Decke liegt ${height} m über dem Boden: Ist das so? In Fuß, wählbar unter „Wie es verstanden wurde“, wären es ${metres} m`,
  clamped: (name, share, most) => `${name} reflektiert ${share} des Lichts; gerechnet wird mit ${most}`,
  lightLost:
    'Fast alles Licht geht verloren: Die Leuchten hängen im Freien oder sehen auf Rückseiten; andere Montageorte, eine Ebene oder zweiseitige Flächen wählen (Wie es verstanden wurde)',
  staysDark: (share) =>
    `Der Raum bleibt dunkel: Keine Fläche bekommt mehr als ${share} des Lichts, die Leuchten hängen in einem Hohlraum; andere Montageorte oder eine Ebene wählen (Wie es verstanden wurde)`,
  black: (share) =>
    `Alles ist schwarz: Die Flächen reflektieren ${share} des Lichts, wie wenn beim Export die Farben verloren gehen; Reflexionsgrade eingeben (Wie es verstanden wurde)`,
  glassMore: (name, more) =>
    `Material „${name}“ und ${more} weitere: heißt Glas, ist aber undurchsichtig und zählt als Wand; wo Licht hindurch soll, durchsichtig machen (alpha BLEND)`,
  glass: (name) =>
    `Material „${name}“: heißt Glas, ist aber undurchsichtig und zählt als Wand; wo Licht hindurch soll, durchsichtig machen (alpha BLEND)`,
  transparent: (name) =>
    `Material „${name}“ ist durchsichtig (alpha BLEND oder Transmission): Es ist keine Wand, Licht geht unverändert hindurch`,
  transparentMore: (name, more) =>
    `Material „${name}“ ist durchsichtig (alpha BLEND oder Transmission): Es ist keine Wand, Licht geht unverändert hindurch; ebenso ${more} weitere`,
  roomOpen: (share, ways) =>
    `Der Raum ist offen: ${share} des Lichts seiner Leuchten trifft auf nichts und ist verloren; es entweicht ${inGerman(ways)}`,
  backsNear: (share, names) =>
    `${share} des Lichts schlucken Rückseiten, und zwar die von ${listed(names)}: Sie liegen dicht über etwas und verdecken es; Verdecktes ausschneiden, sonst zählt es als dunkel`,
  backs: (share, names) =>
    `${share} des Lichts schlucken Rückseiten, und zwar die von ${listed(names)}: ihre Dreiecke umdrehen oder ihr Material zweiseitig machen`,
  foreseenLoss: (share) =>
    `Etwa ${share} des Lichts ginge verloren: Es verlässt das Modell oder trifft auf Rückseiten; Öffnungen schließen, Dreiecke umdrehen oder alle Flächen zweiseitig nehmen`,
  outside: (area, names) =>
    `${area} m² sehen ins Leere oder liegen auf etwas, dorthin kommt kein Licht, und sie sind weggelassen: ${listed(names)}`,
  shutOff: (area, names) =>
    `${area} m² sind von allen Plätzen für Leuchten abgeschlossen und bleiben dunkel (ein versiegelter Raum, das Innere einer Wand): ${listed(names)}`,
  turned: (area, names) =>
    `${area} m² haben nur eine Seite, die von dem Raum wegsieht, den sie umschließen, und sind umgedreht: ${listed(names)}`,
  twoSided:
    'Keine Decke sieht in den Raum: Alle Flächen gelten als zweiseitig, und die nach außen sehen, sind umgedreht',
  fileLights:
    'Lichter und leuchtende Materialien der Datei leuchten nicht: nur die Leuchten, die aufgehängt werden',
  fitsNowhere: (name) =>
    `${name} passt auf keinen Platz in diesem Raum: eine kleinere Leuchte nehmen oder einen größeren Ausrichtwinkel zulassen`,
  fitNowhere: (names) =>
    `${names} passen auf keinen Platz in diesem Raum: eine kleinere Leuchte nehmen oder einen größeren Ausrichtwinkel zulassen`,
  noLuminousArea: (name) =>
    `${name} hat keine leuchtende Fläche, also lässt sich nicht sagen, wie sie blendet: eine andere Leuchte nehmen oder nicht nach Blendung fragen`,
  noFloor: 'Es gibt keinen Boden, über dem eine Nutzebene liegen könnte',
  narrowFloor: (rim) =>
    `Keine Nutzebene: Der Boden ist schmaler als zwei Randzonen von ${rim} m; die Randzone kleiner machen`,
  stfTooLarge: 'die Datei ist größer als 8 MB',
  stfNoSection: (section) => `der Abschnitt [${section}] fehlt`,
  stfNoLine: (section, name) => `in [${section}] fehlt die Zeile ${name}=`,
  stfFewPoints: (section, count) => `[${section}] hat ${count} Punkte; ein Raum hat mindestens drei`,
  stfNoReflectance: (section, line) => `[${section}] ${line} ist kein Reflexionsgrad`,
  stfNoNumber: (section, line) => `[${section}] ${line} ist keine Zahl`,
  stfNoNumbers: (section, line, count) => `[${section}] ${line} sind nicht ${count} Zahlen`,
  stfNotWhole: (section, line, most) => `[${section}] ${line} ist keine ganze Zahl bis ${most}`,
  alphaNoLayout: (promise) =>
    `Keine gefundene Anordnung gibt ${promise}: Schon die Mittelwerte reichen nicht.`,
  alphaTwoEmpty: (promise) =>
    `Kein Alpha führt zu ${promise}: Mit einem kleinen verfehlen es manche Teilflächen, mit einem größeren hält keine Anordnung den Abstand ein.`,
  planNone: 'das ist kein Raum',
  planVersion: (version, own) =>
    `er stammt aus einer anderen Fassung (Grundriss ${version}; hier werden Grundrisse bis ${own} gelesen)`,
  planNumbers: 'etwas darin ist keine ganze Zahl, oder es sind zu viele',
  planMissing: 'fehlt oder ist etwas anderes',
  planRange: (least, most) => `muss zwischen ${least} und ${most} liegen`,
  planMany: (most) => `mehr als ${most}`,
  planFewCorners: 'weniger als 3 Ecken',
  planColour: 'ist keine Farbe wie #f4f1ea',
  planCrossed: 'die Wände kreuzen oder berühren einander',
  planSmall: 'der Boden ist kleiner als 0,25 m²',
  planShortWall: 'eine Wand ist kürzer als 5 cm',
  noArrangement: (what, count) =>
    `Auf den freien Plätzen gibt es ${noKindOf(what)} von ${luminaires(count)}: die Anzahl ändern, einen Bereich angeben oder die Anordnung freigeben`,
  noRows: (what, count, least) =>
    `Auf den freien Plätzen gibt es ${noKindOf(what)} von ${luminaires(count)}, mindestens ${least} in jeder: die Anzahl ändern, einen Bereich angeben oder die Anordnung freigeben`,
  fewSites: (count, free) =>
    `Für ${luminaires(count)} sind ${free} Plätze frei: die Anzahl senken oder weniger Flächen frei halten`,
  roomForOnly: (found, count, apart) =>
    `Mit ${apart} m Abstand finden nur ${found} von ${luminaires(count)} Platz: die Anzahl oder den Mindestabstand senken`,
  roomForBodies: (found, count) =>
    `Nur ${found} von ${luminaires(count)} finden Platz, ohne aneinander zu stoßen: die Anzahl senken oder kleinere nehmen`,
  pinnedNear: (one, other, apart, least) =>
    `Die Leuchten, die auf den Plätzen ${one} und ${other} festgehalten werden, hängen ${apart} m auseinander, verlangt sind mindestens ${least} m: eine lösen oder den Mindestabstand senken`,
  pinnedMore: (pinned, count) =>
    `${luminaires(pinned)} werden festgehalten, die Anzahl ist aber ${count}: die Anzahl erhöhen oder welche lösen`,
  typesAskMore: (asked, count) =>
    `Die Typen verlangen zusammen ${asked}, die Anzahl ist aber ${count}: sie erhöhen oder von einem Typ weniger verlangen`,
  typesAskFirst: (asked, count, least) =>
    `Die Typen verlangen zusammen ${asked}, die Anzahl ist aber ${count}: ihren Bereich bei ${least} beginnen`,
  typesAllowFewer: (allowed, count) =>
    `Die Typen erlauben zusammen ${allowed}, die Anzahl ist aber ${count}: sie senken oder von einem Typ mehr erlauben`,
  typesNoPlaces: (count) =>
    `Es gibt keine ${count} Plätze mit so vielen Leuchten jedes Typs, wie verlangt sind: die Anzahl senken oder die Bereiche erweitern`,
  typeFitsNowhere: (which, type) => `${which} soll vom Typ ${type} sein, der nirgends in diesen Raum passt`,
  alphaStopped: (promise) => `Angehalten, bevor ein Alpha gefunden war für ${promise}.`,
  alphaAtLeast: (value, unit, surface) => `mindestens ${value} ${unit} auf jeder Teilfläche von ${surface}`,
  alphaAtMost: (value, unit, surface) => `höchstens ${value} ${unit} auf jeder Teilfläche von ${surface}`,
  alphaOthers: 'Auch die anderen Ziele sind nicht alle zu erfüllen: erst eines davon lockern.',
  alphaByPatches: (value) =>
    `Eine Suche auf den Teilflächen selbst findet eine solche Anordnung, mit ${value}.`,
  alphaFeasible: (which, value) =>
    `${which}, die gefunden wurde: ${value}. Danach fragen, oder mehr Leuchten oder Lichtstrom nehmen.`,
  alphaLargest: 'Die hellste unter den dunkelsten Stellen',
  alphaSmallest: 'Die dunkelste unter den hellsten Stellen',
};

/** Files that are written or read, and what is wrong with one. */
import type { Words } from '../en.ts';

export const files: Words['files'] = {
  misfit: (expected, received) => `erwartet ${expected}, gefunden ${received}`,
  misshapen: 'es hat nicht die erwartete Form',
  link: {
    tooLong: 'Das ist mehr, als ein Link fasst (1800 Zeichen). Stattdessen eine Projektdatei sichern.',
    unreadable: (what) =>
      `Dieser Link ist nicht lesbar: ${what}. Noch einmal anfordern; die App beginnt ohne ihn.`,
    characters: (thousands) => `er ist ${thousands} 000 Zeichen lang`,
    damaged: 'er ist beschädigt oder abgeschnitten',
    checksum: 'seine Prüfsumme stimmt nicht, ein Teil wurde geändert oder ging verloren',
    otherVersion: (version, own) =>
      `Dieser Link kommt aus einer anderen Version von Fiat Lux (Linkversion ${version}; diese App liest bis Version ${own}).`,
    tooMuch: 'er entpackt sich zu zu viel',
    otherContents: 'sein Inhalt ist nicht der eines Links',
    fault: (fault) => `sein Inhalt ist nicht der eines Links (${fault})`,
    missingPin: 'er fixiert eine Leuchte, die er nicht hat',
    countsDiffer: 'Leuchten und Lichtströme sind nicht gleich viele',
    mountsDiffer: 'Leuchten und Montagen sind nicht gleich viele',
    sameName: 'zwei seiner Leuchtentypen heißen gleich',
    whichFile: 'er sagt nicht, zu welcher Datei ein Leuchtentyp gehört',
    noSuchType: 'eine Leuchte ist von keinem Typ, den er hat',
    noPlace: (number) => `Leuchte L${number} dieses Links hängt, wo dieser Raum keinen Platz für sie hat.`,
    samePlace: (number) => `Zwei Leuchten dieses Links hängen am selben Platz (L${number}).`,
    tooMany: (count, places) => `Dieser Link hat ${count} Leuchten, dieser Raum ${places} Plätze.`,
  },
  project: {
    tooLarge: 'Diese Datei ist zu groß für ein Projekt (höchstens 32 MB).',
    notJson: 'Das ist kein Projekt von Fiat Lux: Die Datei ist kein JSON.',
    newer: (claimed, own) =>
      `Dieses Projekt kommt aus einem neueren Fiat Lux (Dateiversion ${claimed}; diese App liest bis ${own}).`,
    fault: (fault) => `Das ist kein Projekt von Fiat Lux (${fault}).`,
  },
  photometric: {
    tooLarge: 'sie hat mehr als 64 MB; die .ldt- oder .ies-Datei herausnehmen',
    zipDamaged: 'es ist eine beschädigte Zip-Datei; neu herunterladen',
    gldf: 'dieser GLDF-Container',
    zip: 'diese Zip-Datei',
    partTooLarge: (kind, part) =>
      `${kind} entpackt sich zu einer Datei von mehr als 4 MB (${part}), was keine photometrische Tabelle ist`,
    tooManyParts: (kind, most) =>
      `${kind} enthält mehr als ${most} photometrische Dateien; die nötigen herausnehmen`,
    noParts: (kind) => `${kind} enthält keine .ldt- oder .ies-Datei; beim Hersteller danach fragen`,
    xmlDamaged: 'ihr XML ist beschädigt; neu herunterladen',
    noTm33: 'dieses XML ist weder TM-33 noch ATLA S001; die .ies- oder .ldt-Datei der Leuchte nehmen',
    noEmitter: 'sie beschreibt keinen Lichtaustritt; beim Hersteller nach .ies oder .ldt fragen',
    wrongType: (type) =>
      `ihre Photometrie ist vom Typ ${type}, und aus XML wird nur Typ C gelesen; eine .ies-Datei nehmen`,
    noIntensities: 'sie enthält keine Lichtstärken, vielleicht nur ein Spektrum; eine .ies-Datei nehmen',
    tooManyIntensities: 'sie enthält mehr Lichtstärken als jede Tabelle (361 x 721)',
    otherAngles: (plane) =>
      `ihre Ebene ${plane} hat andere Winkel als die erste; beim Hersteller nach einer .ies-Datei fragen`,
  },
};

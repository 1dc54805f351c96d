/** Files that are written or read, and what is wrong with one. */

export const files = {
  misfit: (expected: string, received: string) => `expected ${expected}, found ${received}`,
  misshapen: 'it does not have the expected form',
  link: {
    tooLong: 'This is more than a link can carry (1800 characters). Save a project file instead.',
    unreadable: (what: string) =>
      `This link cannot be read: ${what}. Ask for it again; the app starts without it.`,
    characters: (thousands: number) => `it is ${thousands} 000 characters long`,
    damaged: 'it is damaged or cut off',
    checksum: 'its checksum does not fit, so a part of it was changed or lost',
    otherVersion: (version: number, own: number) =>
      `This link was made by another version of Fiat Lux (link version ${version}; this app reads up to version ${own}).`,
    tooMuch: 'it unpacks to too much',
    otherContents: 'its contents are not what a link holds',
    fault: (fault: string) => `its contents are not what a link holds (${fault})`,
    missingPin: 'it pins a luminaire that it does not have',
    countsDiffer: 'luminaires and fluxes differ in number',
    mountsDiffer: 'luminaires and mountings differ in number',
    sameName: 'two of its luminaire types have one name',
    whichFile: 'it does not say which file a luminaire type is of',
    noSuchType: 'a luminaire is of no type that it has',
    noPlace: (number: number) =>
      `Luminaire L${number} of this link hangs where this room has no place for it.`,
    samePlace: (number: number) => `Two luminaires of this link hang at the same place (L${number}).`,
    tooMany: (count: number, places: number) =>
      `This link has ${count} luminaires, this room ${places} places.`,
  },
  project: {
    tooLarge: 'This file is too large for a project (32 MB at most).',
    notJson: 'This is not a Fiat Lux project: the file is not JSON.',
    newer: (claimed: number, own: number) =>
      `This project was made by a newer Fiat Lux (file version ${claimed}; this app reads up to ${own}).`,
    fault: (fault: string) => `This is not a Fiat Lux project (${fault}).`,
  },
  photometric: {
    tooLarge: 'it has more than 64 MB; take the .ldt or .ies file out of it',
    zipDamaged: 'it is a damaged zip file; fetch it again',
    gldf: 'this GLDF container',
    zip: 'this zip file',
    partTooLarge: (kind: string, part: string) =>
      `${kind} unpacks to a file of more than 4 MB (${part}), which no photometric table is`,
    tooManyParts: (kind: string, most: number) =>
      `${kind} holds more than ${most} photometric files; take out the ones you need`,
    noParts: (kind: string) => `${kind} has no .ldt or .ies file in it; ask its maker for one of these`,
    xmlDamaged: 'its XML is damaged; fetch it again',
    noTm33: 'this XML is neither TM-33 nor ATLA S001; take the luminaire’s .ies or .ldt file',
    noEmitter: 'it describes no emitter; ask its maker for an .ies or .ldt file',
    wrongType: (type: string) =>
      `its photometry is of type ${type}, and only type C is read from XML; take an .ies file`,
    noIntensities: 'it holds no luminous intensities, perhaps a spectrum only; take an .ies or .ldt file',
    tooManyIntensities: 'it holds more intensities than any table (361 x 721)',
    otherAngles: (plane: number) =>
      `its plane ${plane} has other angles than its first one; ask its maker for an .ies file`,
  },
};

/** What the readers of photometric files say themselves, word for word (core/photometry): as in faults.ts. */

/** What should stand in a file, by the names that its readers give it. */
const fields = {
  lampLumens: 'the lumens per lamp (-1 for absolute photometry)',
  multiplier: 'the candela multiplier',
  verticals: 'the number of vertical angles',
  horizontals: 'the number of horizontal angles',
  type: 'the photometric type (1 = C, 2 = B, 3 = A)',
  unit: 'the unit (1 = feet, 2 = metres)',
  openingLength: 'a length of the luminous opening',
  ballast: 'the ballast factor',
  afterBallast: 'the number after the ballast factor',
  watts: 'the input watts',
  vertical: 'the vertical angle',
  horizontal: 'the horizontal angle',
  gamma: 'the angle gamma',
  lamps: 'the number of lamps',
  lampSets: 'the number of sets of lamps',
  aLampNumber: 'a number of lamps',
  setFlux: 'the flux of a set of lamps',
  setWatts: 'the watts of a set of lamps',
  typeIndicator: 'the type indicator',
  symmetry: 'the symmetry indicator',
  planes: 'the number of C planes',
  planeDistance: 'the distance of C planes',
  gammas: 'the number of intensities in a plane',
  gammaDistance: 'the distance of intensities',
  luminaireLength: "the luminaire's length",
  luminaireWidth: "the luminaire's width",
  luminaireHeight: "the luminaire's height",
  areaLength: 'a length of the luminous area',
  areaHeight: 'a height of the luminous area',
  downward: 'the downward flux fraction',
  outputRatio: 'the light output ratio',
  conversion: 'the conversion factor',
  tilt: 'the tilt during measurement',
  directRatio: 'a direct ratio',
  intensity: 'an intensity',
  measurement: 'the number of the measurement',
  tiltPosition: "the lamp's position (1, 2 or 3) of TILT=INCLUDE",
  tiltAngles: 'the number of tilt angles',
  tiltAngle: 'a tilt angle',
  tiltFactor: 'a tilt factor',
};

const kinds = {
  png: 'a PNG picture',
  jpeg: 'a JPEG picture',
  gif: 'a GIF picture',
  webp: 'a WebP picture or a sound',
  bmp: 'a BMP picture',
  tiff: 'a TIFF picture',
  pdf: 'a PDF document',
  model: 'a 3D model',
};

export const photometricFaults = {
  atLine: (line: string, what: string) => `line ${line}: ${what}`, // first: what it tells is a fault of its own
  ...fields,
  ...kinds,
  tableForeign: (kind: string) =>
    `this is ${kind}, not a photometric file; take the luminaire's .ies or .ldt file`,
  tableGzip: 'this is a gzip container; unpack it first',
  tableUtf16: 'this text is UTF-16; save it as plain text (ANSI or UTF-8)',
  tablePage: 'this is a web page; download the photometric file that it links to',
  tableXml: "this is XML and names no .ies or .ldt file; take its maker's .ies or .ldt file",
  tableDialux: "this is DIALux's own format (ULD), which is closed; export it as EULUMDAT (.ldt)",
  tableRelux: "this is Relux's own format (ROLF), which is closed; export it as EULUMDAT (.ldt)",
  tableBinary:
    'this is binary, not a photometric text; of a .uld or .rolf file (closed formats), export EULUMDAT (.ldt)',
  tableLarge: (size: string) =>
    `the file has ${size} MB, more than the 4 MB of the largest table; is it a photometric file?`,
  tableNeither:
    "neither LM-63 (no line begins with TILT) nor EULUMDAT (lines 2 to 7 are no numbers); take the luminaire's .ies or .ldt file",
  tableNoTilt: 'the file ends without a TILT= line; it was cut short, fetch it again',
  tableLacksTilt: 'the TILT= line is missing before these counts; insert a line TILT=NONE above them',
  tableNoNumber: (found: string, what: string) =>
    `${found} stands where ${what} should, and is no number; is something missing before it?`,
  tableOutside: (what: string, value: string, least: string, most: string) =>
    `${what} is ${value}, but must lie within ${least} and ${most}; correct it or export the file again`,
  tableNotWhole: (what: string, value: string, least: string, most: string) =>
    `${what} is ${value}, but must be a whole number from ${least} to ${most}; is something missing before it?`,
  tableEnds: (what: string) =>
    `the file ends where ${what} should stand; it was cut short or a line is missing, fetch it again`,
  tableOrder: (what: string, angle: string, before: string) =>
    `${what} of ${angle} follows ${before}: they must ascend; does the number of angles agree with the list?`,
  tableNegative: (value: string) => `${value} cd: intensities cannot be negative; correct the value`,
  tableMore:
    'more numbers follow than the counts of angles announce; correct the counts or export the file again',
  tableNoFlux: 'no set of lamps has a flux; write the flux of each in lm',
  tableOtherFlux: (told: string, held: string) =>
    `the file says that its lamps give ${told} lm, its table holds ${held} lm; which is right?`,
  tableReach: (first: string, last: string) =>
    `the table reaches from gamma ${first} to ${last} only; there is no light outside it`,
  tableTilted: (tilt: string) => `measured at a tilt of ${tilt} degrees; taken as if it hung level`,
  tableOutput: (told: string, lamps: string, held: string, flux: string) =>
    `the file says ${told} % of the lamps' flux (${lamps} lm), its table holds ${held} % (${flux} lm)`,
  tableDownward: (told: string, held: string) =>
    `the file says that ${told} % of the light goes down, its table ${held} %`,
  tableSymmetryPlanes: (symmetry: string, share: string, planes: string) =>
    `symmetry ${symmetry} needs a number of C planes that ${share} divides, not ${planes} (lines 3 and 4)`,
  tableSymmetryAngle: (symmetry: string, plane: string, angle: string) =>
    `symmetry ${symmetry} (line 3) needs C plane ${plane} to be ${angle}; correct the symmetry or the list`,
  tableSymmetryNone: 'symmetry 0 (line 3) needs three C planes or more',
  tableNoLamps: '0 lamps; write how many, or a negative number for absolute photometry',
  tableNegativeFlux: 'the lumens per lamp are negative; write -1 or a flux',
  tableNoFactor: (factor: string) =>
    `multiplier and ballast factors make ${factor}; they must be above 0, export the file again`,
  tableHorizontals: (first: string, last: string) =>
    `the horizontal angles go from ${first} to ${last}; they must be 0 alone, go from 0 to 90, 180 or 360, or from 90 to 270`,
  tableBeam: 'types A and B need two horizontal angles or more; export as type C',
  tableBright: (value: string) =>
    `${value} cd is more than 1e7; correct the value, the multiplier or the lamps' flux`,
  tableTilts:
    "the lamp's flux changes with the luminaire's tilt (TILT=INCLUDE); it is taken as it hangs untilted",
  tableEmpty: 'the file is empty; fetch it again',
  tableDark: 'the table holds no light: every intensity is 0; export the file again',
  tableGldf: 'this is a GLDF container',
  tableZip: 'this is a zip container',
  tableNothingIn: (container: string) =>
    `${container} without an .ldt or .ies file in it; ask its maker for one of these`,
  tableUnzip: (container: string, files: string) => `${container}; unzip it and take out ${files}`,
  tableProduct: (files: string) =>
    `this is the XML description of a GLDF product; take the file that it names: ${files}`,
  tableOthers: (files: string) => `${files} and others`, // last: sentences may end so
};

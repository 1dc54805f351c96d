/** Opening, importing, computing and keeping rooms: what is said on the way and what goes wrong. */

export const opening = {
  noLanguage: 'The words of that language could not be loaded: check the connection and try again.',
  noRoom: 'No room is open yet.',
  notStored: 'This browser refuses to store the work. Save a project file or a link to keep it.',
  opening: (name: string) => `Opening ${name}`,
  lit: (title: string) => `“${title}” is lit: it is among your rooms.`,
  asLastTime: (title: string) => `“${title}” is understood as it was last time.`,
  litFully: (title: string) => `${title} is lit in full quality.`,
  moreRemarks: (count: number) => (count === 1 ? 'One more remark' : `${count} more remarks`),
  about: (title: string, warning: string) => `“${title}”: ${warning}`,
  roomOffline: (room: string) => `the room "${room}" could not be loaded: no connection; try again`,
  roomMissing: (room: string) => `the room "${room}" is not on this server; build it with: npm run build`,
  firstOf: (count: number) => `Of ${count} files the first is opened.`,
  oneOfModels: (opened: string, others: string, more: number) =>
    `Of these models “${opened}” is opened; not opened: ${others}${more > 0 ? ` and ${more} more` : ''}. To light another, drop it by itself.`,
  tooLargeTogether: (name: string) =>
    `“${name}” and the files beside it are larger than 256 MB together, which is more than the browser can hold.`,
  tooLarge: (name: string) => `“${name}” is larger than 256 MB, which is more than the browser can hold.`,
  damagedMesh: 'a compressed mesh of it is damaged: export it again, or without compression',
  tooMuch: {
    node: (index: number) => `node ${index}`, // one without a name
    parts: (count: string, most: string) =>
      `it has ${count} parts, and a page can show ${most}: join those of one material, or use fiatlux precompute`,
    triangles: (count: string, most: string, name: string, percent: string) =>
      `it has ${count} triangles, and a page can light ${most}: ${percent} % of them are in “${name}”; make it simpler, or use fiatlux precompute`,
    deep: (most: string) => `its nodes lie in each other more than ${most} deep: export it again, flattened`,
  },
  emptyFolder: 'There is no file in this folder: drop one with a model, a scene or luminaires in it.',
  unreadable: (name: string) => `“${name}” could not be read from the disk.`,
  notOurs: (name: string, models: string) =>
    `“${name}” is not a file of Fiat Lux: it takes models (${models}, .zip), .stf, .flux, .ies, .ldt and project files.`,
  isOpenAndKept: (name: string) =>
    `“${name}” is open, and one of your rooms from now on. It stays on this computer: nothing is uploaded.`,
  isOpen: (name: string) => `“${name}” is open. It stays on this computer: nothing is uploaded.`,
  gone: (room: string) => `“${room}” is not here any more: open its file again.`,
  readable: 'Open what can be read',
  lookingForRooms: 'Looking for the rooms',
  again: 'Try again',
  otherRoom: (room: string) => `There is no room “${room}” here; this is another one.`,
  openingRoom: 'Opening the room',
  noSuchRoom: (room: string) => `there is no room "${room}"`,
  goingBack: 'Going back',
  linkOfFile: (room: string) =>
    `This link is about “${room}”, a file that is not part of this site. Open that .flux file here and the layout appears.`,
  solver: {
    noScript: 'its script cannot be loaded',
    stopped: (why: string) => `the solver stopped (${why})`,
    reload: (what: string) => `${what}; reload the page to go on`,
    lost: 'the connection was lost',
    notArrived: (why: string) => `the room could not be loaded: ${why}; try again`,
    otherRoom: 'another room was opened',
    whileReading: 'the solver stopped while it read the file; try again',
    whileLighting: 'the solver stopped while it computed the light; try again',
  },
  openingLink: 'Opening the link',
  linkOutdated: (title: string) => `the link was not shown: “${title}” has changed since it was made`,
  linkNotMade: (why: string) => `The room in this link cannot be made: ${why}.`,
  otherVersion: (title: string) =>
    `This link was made for another version of “${title}”. In the present one the light will differ.`,
  showAnyway: 'Show it anyway',
  openingProject: 'Opening the project',
  projectOfFile: (room: string) =>
    `this project is about “${room}”, which is not part of this site; open its .flux file first`,
  projectOutdated: 'the room has changed since this project was saved; its places no longer fit',
  notReady: (title: string, waiting: string) => `“${title}” is not ready yet: ${waiting}`,
  catalog: {
    offline: 'no connection',
    missing: 'scenes/catalog.json is not on this server; build it with npm run build',
    notJson: 'scenes/catalog.json is not JSON',
    unreadable: (fault: string) => `scenes/catalog.json cannot be read: ${fault}`,
    notLoaded: (why: string) => `The list of rooms could not be loaded: ${why}.`,
    notComputed: 'it could not be computed',
    progress: (percent: number) => `being computed, ${percent} %`,
  },
  own: {
    full: 'its storage is full',
    refused: 'it refuses to store files',
    notKept: (title: string, why: string) =>
      `“${title}” is not kept in this browser: ${why}. Save the room as .flux to keep it.`,
    gone: (title: string) => `“${title}” is no longer in this browser's storage`,
  },
  import: {
    noModel: 'there is no model among these files',
    noCollada: 'it is no Collada file',
    damaged: 'it is damaged, or not what its name says',
    noReader: 'what reads such files could not be loaded; check the connection and try again',
    oldFbx: 'its FBX is older than version 7 of the format: export it anew',
    noSurfaces: 'it holds no surfaces',
    scaled: (widest: number, unit: string) => `It is ${widest} units wide, so these were taken as ${unit}.`,
    theFile: 'The file',
    anotherProgram: 'another program',
    noRoom: 'it holds no room',
    firstRoom: (count: number) => `Of its ${count} rooms the first is opened.`,
    unreadable: (name: string, why: string) => `“${name}” cannot be read: ${why}.`,
    comesFrom: (name: string, cure: string) => `“${name}” cannot be read here. It comes from ${cure}.`,
    cures: {
      sketchUp: 'SketchUp: export it as glTF (File, Export, 3D Model, glTF) or as Collada (.dae)',
      revit: 'Revit: export it as FBX (File, Export, FBX)',
      rhino: 'Rhino: export it as glTF or OBJ (File, Export Selected)',
      blender: 'Blender: export it as glTF (File, Export, glTF 2.0)',
      other: 'the program that made it: export it as glTF or FBX',
      cad: 'CAD: draw the plan in the room maker (New room), or export a 3D model as FBX',
      bim: 'BIM: save it as .ifc (IFC-SPF) from the program that made it',
      dialux: 'DIALux or Relux: export the room as STF (.stf)',
      cadModel: 'CAD: export it as glTF, OBJ or STL',
    },
    zipDamaged: (name: string) => `“${name}” is a damaged zip file; fetch it again.`,
    zipInZip: (name: string) =>
      `“${name}” holds another zip file: unpack it, and drop the inner one or the model in it.`,
    zipWithoutModel: (name: string, models: string) =>
      `“${name}” holds nothing that can be opened. A zip may hold a model (${models}) with its textures, a room of DIALux or Relux (.stf), a scene (.flux) or luminaires (.ies, .ldt): export one of these, and drop it or its zip.`,
    zipTooLarge: (name: string, size: number, count: number) =>
      `“${name}” unpacks to ${size} MB in ${count === 1 ? 'one file' : `${count} files`}: take out what is not needed.`,
    ifc: {
      noIfc: 'it is no IFC file of the STEP form (ISO-10303-21)',
      noGeometry: 'it holds no shapes of walls, floors or ceilings: export it with geometry',
      tooMuch: 'it holds more than 5 million triangles: export one storey of it',
      noLibrary: 'what reads IFC could not be loaded; check the connection and try again',
      broken: 'it is damaged, or too large for this browser',
      luminaires: (count: number) =>
        count === 1
          ? 'The luminaire of the file was left out: its place is found anew.'
          : `The ${count} luminaires of the file were left out: their places are found anew.`,
    },
    units: { millimetres: 'millimetres', centimetres: 'centimetres' },
  },
  preview: {
    stages: {
      reading: 'Reading the model',
      casting: 'Casting light',
      exchanging: 'Reflecting light',
      writing: 'Writing the room',
    },
    name: 'A room without light',
    stopped: 'It was stopped.',
    notUploaded: 'Nothing was uploaded.',
    working: 'Light is being computed',
    of: (title: string) => `Preview of “${title}”`,
    lighting: (title: string) => `Lighting “${title}”`,
    full: 'Full quality',
    left: (time: string) => `, about ${time} left`,
    stays: '. It stays on this computer.',
    edit: 'Edit the room',
    close: 'Close the preview',
    stop: 'Stop computing',
    lineCopied: 'The line is on the clipboard.',
    lineNotCopied: 'The browser does not let the page copy: select the line and copy it.',
    command: "The command does it with all of this computer's memory; then drop the .flux file here.",
    copy: 'Copy the command',
    failed: (title: string) => `“${title}” could not be lit`,
    notFull: (title: string) => `“${title}” stays a preview`,
    staysPreview: 'What is shown is the preview.',
    coarser: 'With larger patches',
    long: (time: string, less: string) =>
      `All of it takes about ${time} here; with larger patches about ${less}.`,
  },
  view: {
    notShown: (reason: string) => `The room's geometry cannot be displayed: ${reason}`,
    nothing: 'The room has no geometry to display.',
    emptyCanvas: 'The picture could not be saved: the canvas is empty.',
  },
};

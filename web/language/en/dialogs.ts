/** The dialogues: rooms, share, help, palette, presets. */

export const dialogs = {
  palette: {
    find: 'Find an action',
    prompt: 'What would you like to do?',
    list: 'Actions',
    none: 'No action is called that.',
  },
  help: {
    how: 'Pick a surface, choose a verb, drag its range: a search places the luminaires anew and the bounced light follows while you drag. Drag a luminaire by hand and it stays; the others make up for it.',
    scope:
      'Computed: illuminance and exitance of matt surfaces under these luminaires, with all bounces, as means over patches. Not computed: shine, daylight and the time of day.',
    pointer: 'Pointer',
    drag: { what: 'Drag', does: 'orbit (one finger)' },
    pan: { what: 'Right or Shift drag', does: 'pan (two fingers)' },
    wheel: { what: 'Wheel', does: 'zoom to the pointer' },
    click: { what: 'Click', does: 'select a surface or a luminaire' },
    doubleClick: { what: 'Double click', does: 'stand there, on the floor; else turn around that point' },
    paint: {
      what: 'Click a surface, then Paint',
      does: 'another reflectance; which paint helps most stands there, too',
    },
    luminaire: { what: 'Drag a luminaire', does: 'pin it elsewhere; the others compensate' },
    area: {
      what: 'Luminaires, Keep out or Keep in',
      does: 'drag a rectangle in the plan, or click corners, where none, or all, may hang',
    },
    arrangement: {
      what: 'Luminaires, Arrangement',
      does: 'free, symmetric, in rows or as one field in the middle; below, the watts of each number and what it meets',
    },
    verdict: {
      what: 'Ready-made intentions',
      does: 'a room type of EN 12464-1 or EN 1838 writes all its wishes; the verdict stands first in Results',
    },
    report: {
      what: 'File and export, Report',
      does: 'verdict, plan and schedule to print and sign; DXF, STF and CSV for other programs',
    },
    arrows: { what: 'Arrows on a slider', does: 'one step; Shift × 10, Alt × 0.1' },
  },
  copy: 'Copy',
  noCopy: 'The browser does not let the page copy. The line is selected: press Ctrl+C.',
  close: 'Close',
  gallery: {
    newHint: 'From its size or its plan: walls, windows, furniture, where luminaires hang.',
    ownFile: 'A file of your own',
    ownFileHint:
      'A model (glTF, OBJ, FBX, DAE, 3DS, STL), a building (IFC), a room of DIALux or Relux (STF), a ZIP of them, a scene (.flux) or a project. It stays on this computer.',
    experiments: 'Experiments of the paper, on the E corridor',
  },
  luminaires: {
    in: (name: string) => `Luminaires in ${name}`,
    find: 'Find a luminaire',
    prompt: 'Find: panel, spot, 24 degrees, pendant …',
    open: 'Open a file',
    none: 'No luminaire is called that.',
    beam: (degrees: number) => `beam ${degrees}°`,
  },
  own: {
    name: 'Your rooms',
    where: 'They are kept in this browser only.',
    taken: (where: string, taken: string, granted: string) => `${where} ${taken} of ${granted} are taken.`,
    mayGo: 'When the disk is full, the browser may clear them: save as .flux what is to stay.',
    deleted: (title: string) => `“${title}” is deleted.`,
    bringBack: 'Bring it back',
    rename: (title: string) => `Rename ${title}`,
    save: (title: string) => `Save ${title} as .flux`,
    delete: (title: string) => `Delete ${title}`,
    nameOf: 'Name of the room',
    doRename: 'Rename',
  },
  place: {
    name: (building: string) => `Which place of “${building}”?`,
    about: 'What lies there is lit by itself; the rest of the building is left out.',
    building: 'The whole building',
    storey: 'Storey',
    space: 'Space',
    size: (width: string, depth: string) => `${width} × ${depth} m`,
  },
  presets: {
    noRoute: 'Draw the escape route as a task area first; each is judged along its middle.',
    noSurface: (title: string) => `This room has no surface that “${title}” could be asked of.`,
    name: 'Ready-made intentions',
    for: 'For',
    check: '. These are numbers to start from; check them in your own copy of the standard.',
    wholeRoom: 'The whole room: all cards at once',
    maintained: '; maintained',
  },
  share: {
    name: 'Share this layout',
    how: 'Whoever opens the link sees this very layout, its intentions and this view. Nothing is uploaded: it is all in the link.',
    link: 'Link',
    copied: 'The link is on the clipboard.',
    score: (points: number) => `It takes your score along: ${points}, where the solver has 100.`,
    dare: (points: number) => `My score is ${points}, the solver’s is 100. Can you do better?`,
    holdsKept: 'It takes A along, to be compared with. ',
    holdsRoom: 'It holds the room, too: whoever opens it has it made and computed there.',
    namesRoom: (room: string) =>
      `It names the room “${room}” but does not hold it: send the .flux file along.`,
    send: 'Send',
    characters: (count: string) => `${count} characters.`,
    left: {
      one: (names: string) =>
        `One photometric file is too long for a link and only named in it: send ${names} along, or a project file, which holds all.`,
      many: (names: string) =>
        `Photometric files are too long for a link and only named in it: send ${names} along, or a project file, which holds all.`,
    },
  },
  embed: {
    name: 'Embed',
    how: 'In a page of your own: the room to look around in, without the panel.',
    label: 'HTML to embed',
    copy: 'Copy HTML',
    copied: 'The HTML is on the clipboard: paste it into a page.',
  },
};

/** The sheet on which a person sees how a model was understood, and changes it. */

export const sheet = {
  open: 'How it was understood',
  name: 'How the model was understood',
  title: (model: string) => `How “${model}” is understood`,
  close: 'Close without a change',
  light: 'Light it so',
  looking: 'Looking at the model',
  size: {
    title: 'Size',
    is: (width: string, depth: string, height: string) => `${width} × ${depth} m, ${height} m high`,
    unit: 'Unit of the file',
    guess: 'Guess',
    guessed: (unit: string) => `Guessed: ${unit}.`,
    other: (metres: string) => `${metres} m a unit`,
    metres: 'metres',
    up: 'Which axis is up',
    upY: 'Y up',
    upZ: 'Z up',
  },
  place: {
    title: 'Part of the building',
    whole: 'All of it is lit.',
    pick: 'Choose one room',
    picking: 'Click inside a room in the picture.',
    stop: 'Not now',
    only: 'Only the room that was clicked is lit.',
    doors: 'Rooms behind open doors',
    doorsUnit: (count: number): string => (count === 1 ? 'door' : 'doors'),
    lid: 'Close its doors and windows',
    lids: { none: 'No', dark: 'Dark', white: 'White' },
    again: 'Another room',
    all: 'The whole building',
  },
  mounts: {
    title: 'Luminaires hang on',
    none: 'Nothing here is a ceiling: they hang in a plane over the largest floor.',
    pick: 'A click on a surface of the picture adds it, or takes it away.',
    surfaceOver: (area: string, height: string) => `${area} m², ${height} m over the floor`,
    plane: 'Plane over the floor instead',
    planeHeight: 'Height of the plane over the floor',
    proposed: 'As proposed',
    noCeiling: 'Luminaires have to hang somewhere: choose a surface instead of the plane.',
    last: (surface: string) =>
      `Luminaires have to hang somewhere: add another surface before taking ${surface} away.`,
    storeys: 'In one storey alone',
    storey: (number: number) => `Storey ${number}`,
    floorAt: (height: string) => `Ceilings over the floor at ${height} m`,
  },
  luminaires: {
    title: 'Places of luminaires',
    spacing: 'From one to the next',
    size: 'Size of a luminaire',
    drop: 'Below where they hang',
    proposed: 'proposed',
    asSpacing: 'same',
    asDrawn: 'as drawn',
    places: (count: number) =>
      count === 0
        ? 'None of them fits: smaller ones, or a closer grid.'
        : count === 1
          ? '1 place for a luminaire'
          : `${count} places for luminaires`,
  },
  plane: {
    title: 'Working plane',
    wanted: 'Measure on a plane over the floor',
    height: 'Height over the floor',
    rim: 'Rim left out',
    drawn: (name: string) => `Drawn: ${name}`,
    border: 'Border left out',
    tooNarrow: 'Its border leaves nothing of it.',
    remove: (name: string) => `Remove ${name}`,
  },
  foreseen: (patches: string, size: string, time: string) =>
    `About ${patches} patches of ${size} m: some ${time} on this computer, a first picture sooner.`,
  lost: {
    much: (percent: string) =>
      `About ${percent} % of the light would be lost: it leaves the model, or meets the backs of faces.`,
    doubleSided: 'Faces have two sides',
  },
  materials: {
    title: 'Reflectances',
    reflectance: (material: string) => `Reflectance of ${material}`,
    byRole: 'by its surface',
    byRoleTip: 'No colour yet: ceilings 70 %, walls 50 %, floors 20 %, other things 40 %',
    byPicture: 'picture',
    none: 'No materials: ceilings reflect 70 %, walls 50 %, floors 20 %, other things 40 %.',
    nameless: (index: number) => `Material ${index}`,
    more: (count: number) => `and ${count} more`,
  },
  remarks: 'Remarks',
};

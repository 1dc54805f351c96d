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
    luminaire: { what: 'Drag a luminaire', does: 'pin it elsewhere; the others compensate' },
    area: {
      what: 'Luminaires, Keep out or Keep in',
      does: 'drag a rectangle in the plan where none, or all, may hang',
    },
    arrows: { what: 'Arrows on a slider', does: 'one step; Shift × 10, Alt × 0.1' },
  },
  language: 'Language',
};

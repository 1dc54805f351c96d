// From a catalogue id to a finished room.
import { makeBox } from './box.mjs';
import { makeClassroom } from './classroom.mjs';
import { makeECorridor } from './e-corridor.mjs';
import { makeGallery } from './gallery.mjs';
import { makeOffice } from './office.mjs';

const makers = {
  'e-corridor': makeECorridor,
  office: makeOffice,
  classroom: makeClassroom,
  gallery: makeGallery,
  box: makeBox,
};

/** The room of a catalogue id, ready to be written. */
export const makeRoom = (id) => makers[id]();

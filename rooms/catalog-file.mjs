// scenes/catalog.json: the list of rooms that the page reads when it opens. A site's owner adds a room by copying its
// .flux beside it and adding an entry to "rooms": { "id", "title", "description", "file" } and, if wished, "opening" and
// "translations": { "de": { "title", "description" } }.
import path from 'node:path';
import { catalog, experiments } from './catalog.mjs';
import { writeWhole } from './whole-files.mjs';

/**
 * What the file says. `states`: by room, what of an entry is not as it should be in the end, such as
 * { office: { state: 'computing', progress: 0.4 } }; an entry without a state is ready.
 * `ids`: the rooms that it names.
 */
export function catalogFile(states = {}, ids = catalog.map(({ id }) => id)) {
  const entry = ({ id, said: { en, ...translations }, opening, view, roomType, taskAreas }, room) => ({
    id,
    ...en,
    translations,
    file: `${room}.flux`,
    ...states[room],
    opening,
    view,
    roomType,
    taskAreas,
  });
  return {
    rooms: catalog.filter(({ id }) => ids.includes(id)).map((room) => entry(room, room.id)),
    experiments: experiments.map((experiment) => entry(experiment, experiment.room)),
  };
}

/** Writes it into a folder, where a page may read it meanwhile. */
export async function writeCatalog(folder, states, ids) {
  await writeWhole(
    path.join(folder, 'catalog.json'),
    `${JSON.stringify(catalogFile(states, ids), null, 2)}\n`,
  );
}

/** What comes from other programs: fetched when such a file is dropped. */
import type { PackedPlan } from '../../document/made-room.ts';
import { readStf } from '../../document/stf.ts';
import { importModel, type Imported } from './import-model.ts';
import { importIfc, type ChoosePlace } from './ifc/import-ifc.ts';
import { cureOf, isIfc, isModel } from './model-files.ts';
import { planOfStf } from './stf-plan.ts';
import { inOurWords } from '../../language/faults.ts';
import { words } from '../../language/language.ts';
import { reasonOf } from '../../document/reason.ts';

export type Import = Imported | { readonly plan: PackedPlan; readonly note: string | null };

/** A model as .glb, or a room as a plan; null where no place of a building was chosen. Throws one sentence. */
export async function imported(files: readonly File[], choose: ChoosePlace): Promise<Import | null> {
  const stf = files.find(({ name }) => /\.stf$/i.test(name));
  const main = files.find((file) => isModel(file.name)) ?? stf ?? files.find((file) => cureOf(file.name));
  const name = main?.name ?? words.value.opening.import.theFile;
  try {
    if (main && isIfc(main.name)) return await importIfc(main, choose);
    if (main && isModel(main.name)) return await importModel(files);
    if (stf) return stfRoom(await stf.text());
  } catch (error) {
    throw new Error(words.value.opening.import.unreadable(name, inOurWords(reasonOf(error))));
  }
  throw new Error(
    words.value.opening.import.comesFrom(name, cureOf(name) ?? words.value.opening.import.anotherProgram),
  );
}

function stfRoom(text: string): Import {
  const project = readStf(text);
  if (typeof project === 'string') throw new Error(project);
  const [room, ...others] = project.rooms;
  if (!room) throw new Error(words.value.opening.import.noRoom);
  const note = others.length > 0 ? words.value.opening.import.firstRoom(others.length + 1) : null;
  return { plan: planOfStf(room), note };
}

/** An .ifc as a binary glTF of the place in it that a person chooses; where there is only one, nobody is asked. */
import type { Imported } from '../import-model.ts';
import { words } from '../../../language/language.ts';
import type { IfcPlace } from './ifc-places.ts';
import type { FromIfc, ToIfc } from './ifc-worker.ts';

/** Resolves to the chosen one's index; null: none of them. */
export type ChoosePlace = (name: string, places: readonly IfcPlace[]) => Promise<number | null>;

/** null where no place was chosen. Throws one clause where it cannot be read. */
export async function importIfc(file: File, choose: ChoosePlace): Promise<Imported | null> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const worker = new Worker(new URL('./ifc-worker.ts', import.meta.url), { type: 'module', name: 'ifc' });
  try {
    const { places, luminaires } = await asked(worker, { type: 'read', bytes }, 'read');
    const stem = file.name.replace(/\.[^.]*$/, '');
    const place = places.length > 1 ? await choose(stem, places) : 0;
    if (place === null) return null;
    const { glb } = await asked(worker, { type: 'take', place }, 'taken');
    if (!glb) throw new Error(words.value.opening.import.ifc.noGeometry);
    const { name } = places[place]!;
    const note = luminaires > 0 ? words.value.opening.import.ifc.luminaires(luminaires) : null;
    return { file: new File([glb], `${name ? `${stem} ${name}` : stem}.glb`), note };
  } finally {
    worker.terminate();
  }
}

type Answer<Type> = Extract<FromIfc, { readonly type: Type }>;

function asked<Type extends FromIfc['type']>(
  worker: Worker,
  question: ToIfc,
  type: Type,
): Promise<Answer<Type>> {
  const faults = words.value.opening.import.ifc;
  return new Promise((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<FromIfc>) => {
      if (data.type === type) resolve(data as Answer<Type>);
      else reject(new Error(data.type === 'failed' ? faults[data.fault] : faults.broken));
    };
    worker.onerror = () => reject(new Error(faults.broken));
    worker.postMessage(question);
  });
}

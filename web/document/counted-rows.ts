/** Which patches of a scene count for a surface: all that nothing covers. */
import type { SceneInfo } from './types.ts';

type Rows = Pick<SceneInfo, 'surfaceOfPatch' | 'patchCovered'>;

/** Many ask, for one surface each. */
const known = new WeakMap<Rows['surfaceOfPatch'], Pick<Rows, 'patchCovered'> & { rows: Uint32Array[] }>();

/** The rows of a leaf, ascending. */
export function countedRows(scene: Rows, leaf: number): Uint32Array {
  const { surfaceOfPatch, patchCovered } = scene;
  let sorted = known.get(surfaceOfPatch);
  if (sorted?.patchCovered !== patchCovered) {
    sorted = { patchCovered, rows: rowsByLeaf(scene) };
    known.set(surfaceOfPatch, sorted);
  }
  return sorted.rows[leaf] ?? new Uint32Array();
}

function rowsByLeaf({ surfaceOfPatch, patchCovered }: Rows): Uint32Array[] {
  const counts: number[] = [];
  for (let row = 0; row < surfaceOfPatch.length; row++)
    if (patchCovered[row] !== 1) counts[surfaceOfPatch[row]!] = (counts[surfaceOfPatch[row]!] ?? 0) + 1;
  const rows = Array.from(counts, (count) => new Uint32Array(count ?? 0));
  const ends = rows.map(() => 0);
  for (let row = 0; row < surfaceOfPatch.length; row++)
    if (patchCovered[row] !== 1) rows[surfaceOfPatch[row]!]![ends[surfaceOfPatch[row]!]!++] = row;
  return rows;
}

/**
 * Models that would freeze a page before anything could be said of them: too many parts, too many triangles, or nodes in
 * nodes without end. Counted from the glTF's JSON alone, nothing is unpacked; of an .obj by its lines.
 */
import { readContainer } from '../../document/gltf-container.ts';
import type { Model } from '../../builder/protocol.ts';
import { breaths } from '../../viewer/stage/breath.ts';
import { words } from '../../language/language.ts';
import { fixed } from '../../language/numbers.ts';

const mostParts = 20_000;
const mostTriangles = 2e6;
const deepest = 1000; // nodes in nodes
const cornersOfOne = 3;

/** Those parts of a glTF's JSON that are read; all of it is a stranger's. */
interface Gltf {
  scene?: number;
  scenes?: { nodes?: number[] }[];
  nodes?: { name?: string; mesh?: number; children?: number[] }[];
  meshes?: { primitives?: { indices?: number; attributes?: { POSITION?: number } }[] }[];
  accessors?: { count?: number }[];
}

/** One clause; null where it is not too much, or broken: what lights it tells that better. */
export function tooMuchIn(glb: Model['bytes']): string | null {
  try {
    return counted(JSON.parse(readContainer(glb).text) as Gltf, glb.length);
  } catch {
    return null;
  }
}

function counted(
  { scene = 0, scenes = [], nodes = [], meshes = [], accessors = [] }: Gltf,
  bytes: number,
): string | null {
  const text = words.value.opening.tooMuch;
  const triangles = meshes.map(({ primitives = [] }) =>
    primitives.reduce((sum, { indices, attributes }) => {
      const corners = accessors[indices ?? attributes?.POSITION ?? -1]?.count ?? 0;
      return corners > bytes ? sum : sum + Math.floor(corners / cornersOfOne); // what the file cannot hold is broken
    }, 0),
  );
  const held = new Map<string, number>(); // triangles by name
  let parts = 0;
  let level = scenes[scene]?.nodes ?? nodes.map((_, i) => i);
  for (let depth = 0; level.length > 0; depth++) {
    if (depth > deepest) return nodes.length > deepest ? text.deep(fixed(deepest, 0)) : null; // else a cycle
    const next: number[] = [];
    for (const index of level) {
      const { name = text.node(index), mesh, children = [] } = nodes[index] ?? {};
      if (next.length < nodes.length) next.push(...children.slice(0, nodes.length));
      if (mesh === undefined) continue;
      const own = triangles[mesh] ?? 0;
      parts += 1;
      held.set(name, (held.get(name) ?? 0) + own);
    }
    level = next;
  }
  if (parts > mostParts) return text.parts(fixed(parts, 0), fixed(mostParts, 0));
  return tooManyOf(held);
}

/** Triangles by name. */
function tooManyOf(held: ReadonlyMap<string, number>): string | null {
  const all = [...held.values()].reduce((sum, own) => sum + own, 0);
  if (all <= mostTriangles) return null;
  const [most, own] = [...held].reduce((one, other) => (other[1] > one[1] ? other : one));
  const share = fixed((100 * own) / all, 0);
  return words.value.opening.tooMuch.triangles(fixed(all, 0), fixed(mostTriangles, 0), most, share);
}

const [feed, space, f, g, o] = [10, 32, 102, 103, 111]; // characters
const longestName = 200; // characters of it

/** One clause; null where the faces of an .obj are not too many. Whoever reads it holds the page up for as long as it takes. */
export async function tooMuchInObj(name: string, text: Uint8Array): Promise<string | null> {
  const rested = breaths();
  const held = new Map<string, number>(); // faces by object or group
  let [part, own] = [name, 0];
  const end = () => void (own > 0 && held.set(part, (held.get(part) ?? 0) + own));
  for (let line = 0, count = 0; line < text.length; count++) {
    const kind = text[line + 1] === space ? text[line] : 0;
    const next = text.indexOf(feed, line) + 1 || text.length;
    if (kind === f) own += 1;
    if (kind === o || kind === g) {
      end();
      const ends = Math.min(next, line + longestName);
      [part, own] = [new TextDecoder().decode(text.subarray(line + 2, ends)).trim() || name, 0];
    }
    line = next;
    if (count % 4096 === 0) await rested();
  }
  end();
  return tooManyOf(held);
}

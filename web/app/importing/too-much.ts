/**
 * Models that would freeze a page before anything could be said of them: too many parts, too many triangles, or nodes in
 * nodes without end. Counted from the glTF's JSON alone, nothing is unpacked.
 */
import { readContainer } from '../../document/gltf-container.ts';
import type { Model } from '../../builder/protocol.ts';
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
  let [parts, all] = [0, 0];
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
      all += own;
      held.set(name, (held.get(name) ?? 0) + own);
    }
    level = next;
  }
  if (parts > mostParts) return text.parts(fixed(parts, 0), fixed(mostParts, 0));
  if (all <= mostTriangles) return null;
  const [most, own] = [...held].reduce((one, other) => (other[1] > one[1] ? other : one));
  return text.triangles(fixed(all, 0), fixed(mostTriangles, 0), most, fixed((100 * own) / all, 0));
}

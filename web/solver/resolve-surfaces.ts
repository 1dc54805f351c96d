/**
 * From names to leaf surfaces. A name is a leaf of the surface tree or an inner node of it ("desk" means "desk/top",
 * "desk/legs", ...); 'all' is every leaf but the measuring planes.
 */
import type { SurfaceNames } from '../document/types.ts';

export interface NamedSurface {
  readonly name: string;
  readonly measuring: boolean;
}

/** Sorted leaf indices, none for 'all' (as in the core). Throws one readable line for a name that is not there. */
export function resolveSurfaces(names: SurfaceNames, leaves: readonly NamedSurface[]): Uint32Array {
  if (names.every((name) => name === 'all')) return new Uint32Array();
  const members = new Set<number>();
  for (const name of names) {
    let found = name === 'all';
    leaves.forEach((leaf, index) => {
      if (name === 'all' ? leaf.measuring : leaf.name !== name && !leaf.name.startsWith(`${name}/`)) return;
      members.add(index);
      found = true;
    });
    if (!found) throw new Error(unknown(name, leaves));
  }
  return Uint32Array.from([...members].sort((a, b) => a - b));
}

function unknown(name: string, leaves: readonly NamedSurface[]): string {
  const some = leaves.slice(0, 6).map((leaf) => `"${leaf.name}"`);
  const more = leaves.length > some.length ? ` and ${leaves.length - some.length} more` : '';
  return `this room has no surface "${name}"; it has ${some.join(', ')}${more}, and "all"`;
}

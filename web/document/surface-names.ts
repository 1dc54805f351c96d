/**
 * From names to leaf surfaces. A name is a leaf of the surface tree or an inner node of it ("desk" means "desk/top",
 * "desk/legs", ...); 'all' is every leaf but the measuring planes.
 */
import type { SurfaceNames } from './types.ts';

export interface NamedSurface {
  readonly name: string;
  readonly measuring: boolean;
  readonly part?: { readonly leaf: number; readonly rows: Uint32Array };
}

/** Sorted leaf indices; a name that is not there means no leaf. */
export function leavesOf(names: SurfaceNames, leaves: readonly NamedSurface[]): number[] {
  return leaves.flatMap((leaf, index) => (names.some((name) => isMeant(leaf, name)) ? [index] : []));
}

/**
 * The set that the core is asked about: sorted leaf indices, and none at all where they are every leaf but the
 * measuring planes, so that "all" has one form however it is spelled. Throws one readable line for a name that is not
 * there.
 */
export function surfaceSetOf(names: SurfaceNames, leaves: readonly NamedSurface[]): Uint32Array {
  const stranger = names.find((name) => name !== 'all' && !leaves.some((leaf) => isMeant(leaf, name)));
  if (stranger !== undefined) throw new Error(unknown(stranger, leaves));
  const set = leavesOf(names, leaves);
  const all = leavesOf(['all'], leaves);
  const isAll = set.length === all.length && set.every((leaf, i) => leaf === all[i]);
  return Uint32Array.from(isAll ? [] : set);
}

function isMeant(leaf: NamedSurface, name: string): boolean {
  return name === 'all' ? !leaf.measuring : leaf.name === name || leaf.name.startsWith(`${name}/`);
}

function unknown(name: string, leaves: readonly NamedSurface[]): string {
  const some = leaves.slice(0, 6).map((leaf) => `"${leaf.name}"`);
  const more = leaves.length > some.length ? ` and ${leaves.length - some.length} more` : '';
  return `this room has no surface "${name}"; it has ${some.join(', ')}${more}, and "all"`;
}

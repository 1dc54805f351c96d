/** Which surfaces are meant, in few words. */
import type { SurfaceNames } from '../../document/types.ts';
import { surfaceText } from '../../language/surface-names.ts';
import { words } from '../../language/language.ts';
import { familyOf, folded } from '../rooms/families.ts';

const isWhole = (names: SurfaceNames): boolean => names.length === 1 && names[0] === 'all';

/** "12 × desk" of a family, else each by its name. */
export function namesText(names: SurfaceNames): string {
  const [family] = new Set(names.map(familyOf));
  const isFamily = names.length > 1 && names.every((name) => familyOf(name) === family);
  return isFamily && family ? `${names.length} × ${surfaceText(family)}` : eachText(names);
}

/** "desk 1–12, floor": each by its name, but of a family its numbers alone. */
export function placesText(names: SurfaceNames): string {
  if (isWhole(names)) return words.value.values.wholeRoom;
  return folded(names, (name) => name)
    .map(({ title }) => title)
    .join(', ');
}

/** Each by its name. */
export function eachText(names: SurfaceNames): string {
  return isWhole(names) ? words.value.values.wholeRoom : names.map(surfaceText).join(', ');
}

/** The horizontal direction, in the room's axes (x east, z south); null where it is none of the four. */
export function compassOf(x: number, z: number): string | null {
  const { east, west, south, north } = words.value.values.compass;
  if (Math.abs(z) < 1e-6) return x < 0 ? west : east;
  if (Math.abs(x) < 1e-6) return z < 0 ? north : south;
  return null;
}

/** "place 3, looking east" of an observer that the core has placed ("P3 +x"); one that a person has placed has a name. */
export function observerText(name: string): string {
  const [, place, sign, axis] = /^P(\d+) ([+-])([xz])$/.exec(name) ?? [];
  if (place === undefined) return name;
  const along = sign === '-' ? -1 : 1;
  const way = compassOf(axis === 'x' ? along : 0, axis === 'z' ? along : 0);
  return words.value.values.looking(place, way ?? '');
}

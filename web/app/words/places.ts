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

const sideOfAxis = { '+x': 'east', '-x': 'west', '+z': 'south', '-z': 'north' } as const;

/** "place 3, looking east" of an observer that the core has placed ("P3 +x"); one that a person has placed has a name. */
export function observerText(name: string): string {
  const [, place, axis] = /^P(\d+) ([+-][xz])$/.exec(name) ?? [];
  if (place === undefined) return name;
  const { looking, compass } = words.value.values;
  return looking(place, compass[sideOfAxis[axis as keyof typeof sideOfAxis]]);
}

/** Names of surfaces as a person reads them. Files, links and the solver know each by the name that its room gives it. */
import { computed, signal } from '@preact/signals';
import { words } from './language.ts';

/** The floor of the room on the screen, where its name does not say so: it is called the floor, too. */
export const unnamedFloor = signal<string | null>(null);

/** Names of the surfaces of the room on the screen. */
export const roomSurfaces = signal<readonly string[]>([]);

export const numbered = /^(.*\D)\s(\d+)$/; // a family and a number in it
const role = /(^|\/)(floor|ceiling|wall)$/;
const partOfPlane = /^(.+) (surround|background)$/;

/** The surface whose other side has this name; null of a front. */
export const frontOf = (name: string): string | null => /^(.+) \(back\)$/.exec(name)?.[1] ?? null;

/** The name without its number and its side. */
function stemOf(name: string): string {
  const front = frontOf(name) ?? name;
  return numbered.exec(front)?.[1] ?? front;
}

/**
 * What a floor, a ceiling and walls are called whose mesh and material say nothing that a person must read: of each family
 * of theirs, as much of the end of its path as no other family of the room has.
 */
const shortFamilies = computed(() => {
  const families = [...new Set(roomSurfaces.value.map(stemOf))];
  const isOnlyOne = (end: string) =>
    families.filter((each) => each === end || each.endsWith(`/${end}`)).length === 1;
  return new Map(
    families
      .filter((family) => role.test(family))
      .map((family) => {
        const parts = family.split('/');
        const ends = parts.map((_, i) => parts.slice(parts.length - 1 - i).join('/'));
        return [family, ends.find(isOnlyOne) ?? family];
      }),
  );
});

/** In the page's language where it has words for the name, or for that of a family ("desk 3"); else as the room has it. */
export function surfaceText(name: string): string {
  const text = ownText(name);
  return name === unnamedFloor.value ? words.value.surfaces.floor(text) : text;
}

function ownText(name: string): string {
  const { names, surround, background, back } = words.value.surfaces;
  if (Object.hasOwn(names, name)) return names[name as keyof typeof names];
  const front = frontOf(name);
  if (front !== null) return back(ownText(front));
  const short = shortened(name);
  if (short !== name) return ownText(short);
  if (name.includes('/')) return name.split('/').map(ownText).join('/');
  const [, whole, part] = partOfPlane.exec(name) ?? [];
  if (whole) return (part === 'surround' ? surround : background)(surfaceText(whole));
  const [, family, number] = numbered.exec(name) ?? [];
  return family && Object.hasOwn(names, family) ? `${ownText(family)} ${number}` : name;
}

function shortened(name: string): string {
  const family = stemOf(name);
  return (shortFamilies.value.get(family) ?? family) + name.slice(family.length);
}

/** Whether a name holds what was typed, as it is read or as the room has it. */
export function isFoundBy(typed: string, name: string): boolean {
  const sought = typed.toLowerCase();
  return [name, surfaceText(name)].some((each) => each.toLowerCase().includes(sought));
}

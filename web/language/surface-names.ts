/** Names of surfaces as a person reads them. Files, links and the solver know each by the name that its room gives it. */
import { signal } from '@preact/signals';
import { words } from './language.ts';

/** The floor of the room on the screen, where its name does not say so: it is called the floor, too. */
export const unnamedFloor = signal<string | null>(null);

const numbered = /^(.*\D) (\d+)$/;
const partOfPlane = /^(.+) (surround|background)$/;

/** The surface whose other side has this name; null of a front. */
export const frontOf = (name: string): string | null => /^(.+) \(back\)$/.exec(name)?.[1] ?? null;

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
  if (name.includes('/')) return name.split('/').map(ownText).join('/');
  const [, whole, part] = partOfPlane.exec(name) ?? [];
  if (whole) return (part === 'surround' ? surround : background)(surfaceText(whole));
  const [, family, number] = numbered.exec(name) ?? [];
  return family && Object.hasOwn(names, family) ? `${ownText(family)} ${number}` : name;
}

/** Whether a name holds what was typed, as it is read or as the room has it. */
export function isFoundBy(typed: string, name: string): boolean {
  const sought = typed.toLowerCase();
  return [name, surfaceText(name)].some((each) => each.toLowerCase().includes(sought));
}

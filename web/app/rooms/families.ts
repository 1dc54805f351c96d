/** Families of numbered surfaces ("desk 1" ... "desk 12"): folded into one line wherever surfaces are listed. */

import { numbered, surfaceText } from '../../language/surface-names.ts';

/** "desk" of "desk 7"; null where a name carries no number. */
export function familyOf(name: string): string | null {
  return numbered.exec(name)?.[1] ?? null;
}

/** One line of a folded list: a single item, or several of one family in the order of their numbers. */
export interface Fold<T> {
  readonly title: string;
  readonly items: readonly T[];
}

/** Folds families of two or more; each stands where its first member stood, its title in the page's words. */
export function folded<T>(items: readonly T[], nameOf: (item: T) => string): Fold<T>[] {
  const families = new Map<string, T[]>();
  for (const item of items) {
    const name = nameOf(item);
    const family = familyOf(name);
    const key = family === null ? `\n${name}` : family; // no name holds a line break
    families.set(key, [...(families.get(key) ?? []), item]);
  }
  const numberOf = (item: T) => Number(numbered.exec(nameOf(item))?.[2] ?? 0);
  return [...families].map(([family, members]) => {
    const sorted = [...members].sort((a, b) => numberOf(a) - numberOf(b));
    const [first] = sorted;
    return {
      title:
        sorted.length === 1 && first
          ? surfaceText(nameOf(first))
          : `${surfaceText(family)} ${numbersText(sorted.map(numberOf))}`,
      items: sorted,
    };
  });
}

/** 1, 2, 3, 7 -> "1–3, 7"; a long list is only counted. */
function numbersText(numbers: readonly number[]): string {
  const runs: [number, number][] = [];
  for (const number of numbers) {
    const last = runs.at(-1);
    if (last && number <= last[1] + 1) last[1] = number;
    else runs.push([number, number]);
  }
  if (runs.length > 3) return `(${numbers.length})`;
  return runs.map(([low, high]) => (low === high ? String(low) : `${low}–${high}`)).join(', ');
}

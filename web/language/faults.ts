/**
 * Faults that the solver, the builder and the readers of files tell in English, in the page's language: each is found by its
 * English sentence in the dictionary, whose arguments stand where a fault tells something of its own.
 */
import { en } from './en.ts';
import { language, words } from './language.ts';

type Name = keyof typeof en.faults;
type Telling = string | ((...told: string[]) => string);

const marks = ['\u0001', '\u0002', '\u0003', '\u0004', '\u0005', '\u0006'];
const say = (telling: Telling, told: readonly string[]): string =>
  typeof telling === 'string' ? telling : telling(...told);

/** "room.glb: " may stand before a sentence. */
function patternOf(telling: Telling): RegExp {
  const escaped = say(telling, marks).replace(/[\\^$.*+?()[\]{}|/]/g, '\\$&');
  return new RegExp(`^(.*?: )?${marks.reduce((text, mark) => text.replace(mark, '(.+?)'), escaped)}$`, 's');
}

const patterns = Object.entries(en.faults).map(
  ([name, telling]) => [name as Name, patternOf(telling)] as const,
);

const decimal = (told: string): string => told.replace(/^(\d+)\.(\d+)( %)?$/, '$1,$2$3');

/** A fault as it was told, in the language of the page where that has words for it. */
export function inOurWords(fault: string): string {
  if (language.value === 'en') return fault;
  for (const [name, pattern] of patterns) {
    const [found, place = '', ...told] = pattern.exec(fault) ?? [];
    if (found === undefined) continue;
    const own = told.map((text) => inOurWords(language.value === 'de' ? decimal(text) : text));
    return place + say(words.value.faults[name] as Telling, own);
  }
  return fault;
}

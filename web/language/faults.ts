/**
 * Faults that the solver, the builder and the readers of files tell in English, in the page's language: each is found by its
 * English sentence in the dictionary, whose arguments stand where a fault tells something of its own. What names options of
 * the command is told with what the page has instead, in English, too.
 */
import { en } from './en.ts';
import { pageFaults } from './en/page-faults.ts';
import { language, words } from './language.ts';

type Name = keyof typeof en.faults;
type Telling = string | ((...told: string[]) => string);

const marks = ['\u0001', '\u0002', '\u0003', '\u0004', '\u0005', '\u0006'];
const say = (telling: Telling, told: readonly string[]): string =>
  typeof telling === 'string' ? telling : telling(...told);

/** "room.glb: " may stand before a sentence, and an option of the command. */
function patternOf(telling: Telling): RegExp {
  const escaped = say(telling, marks).replace(/[\\^$.*+?()[\]{}|/]/g, '\\$&');
  const sentence = marks.reduce((text, mark) => text.replace(mark, '(.+?)'), escaped);
  return new RegExp(`^((?!--).*?: )?(?:--[a-z-]+:? )?${sentence}$`, 's');
}

const patterns = Object.entries(en.faults).map(
  ([name, telling]) => [name as Name, patternOf(telling)] as const,
);

const decimal = (told: string): string => told.replace(/^(\d+)\.(\d+)( %)?$/, '$1,$2$3');

/** The command writes plain ASCII. */
const squared = (text: string): string => text.replace(/ m2(?![\w²])/g, ' m²');

/** The arguments of a fault of this name; null where another one was told. */
export function toldIn(wanted: Name, fault: string): readonly string[] | null {
  const pattern = patterns.find(([name]) => name === wanted)?.[1];
  return pattern?.exec(fault)?.slice(2) ?? null; // after the whole of it, and what stands before
}

/** A fault as it was told, in the language of the page where that has words for it, and without options of the command. */
export function inOurWords(fault: string): string {
  const own: Partial<typeof en.faults> = language.value === 'en' ? pageFaults : words.value.faults;
  for (const [name, pattern] of patterns) {
    const telling = own[name];
    if (telling === undefined) continue;
    const [found, place = '', ...told] = pattern.exec(fault) ?? [];
    if (found === undefined) continue;
    const parts = told.map((text) => inOurWords(language.value === 'de' ? decimal(text) : text));
    return squared(place + say(telling as Telling, parts));
  }
  return squared(fault);
}

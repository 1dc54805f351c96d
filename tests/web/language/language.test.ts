/** Which language is spoken, and how it writes numbers. Covers web/language/language.ts and numbers.ts. */
import { afterEach, expect, test } from '@jest/globals';
import { inEnglish, speak, wishedLanguage, words } from '../../../web/language/language.ts';
import { counted, decimalSign, fixed, listed, shortest, typed } from '../../../web/language/numbers.ts';

const own = { navigator: globalThis.navigator, location: globalThis.location };

function inBrowser(languages: readonly string[], search = ''): void {
  for (const [name, value] of Object.entries({ navigator: { languages }, location: { search } }))
    Object.defineProperty(globalThis, name, { value, configurable: true });
}

afterEach(async () => {
  for (const [name, value] of Object.entries(own))
    Object.defineProperty(globalThis, name, { value, configurable: true });
  await speak('en');
});

test.each([
  [['en-US'], '', 'en'],
  [['de-AT', 'en'], '', 'de'],
  [['fr-FR', 'de'], '', 'de'],
  [['fr-FR'], '', 'en'],
  [['en-US'], '?lang=de', 'de'],
  [['de'], '?room=box&lang=en-GB', 'en'],
  [['de'], '?lang=constructor', 'de'],
])('a browser of %j at "%s" is spoken to in %s', (languages, search, language) => {
  inBrowser(languages, search);
  expect(wishedLanguage()).toBe(language);
});

test('numbers follow the language; thousands stand apart by a thin space', async () => {
  expect([fixed(12345.678, 1), shortest(0.6), typed(1234.5), decimalSign()]).toEqual([
    '12\u202f345.7',
    '0.6',
    '1234.5',
    '.',
  ]);
  expect(listed(['1.20', '3.40'])).toBe('1.20, 3.40');
  inBrowser(['en-US']);
  await speak('de');
  expect([fixed(12345.678, 1), shortest(0.6), typed(1234.5), decimalSign()]).toEqual([
    '12\u202f345,7',
    '0,6',
    '1234,5',
    ',',
  ]);
  expect(listed(['1,20', '3,40'])).toBe('1,20; 3,40');
  expect(words.value.panel.tabs.luminaires).toBe('Leuchten');
});

test('a browser set to Switzerland writes German numbers with a point', async () => {
  inBrowser(['de-CH']);
  await speak('de');
  expect(fixed(1234.5, 1)).toBe('1\u202f234.5');
});

test('files for other programs are written in English', async () => {
  inBrowser(['de']);
  await speak('de');
  expect(inEnglish(() => `${words.value.values.unmet} ${fixed(0.5, 1)}`)).toBe('not met 0.5');
  expect(words.value.values.unmet).toBe('nicht erfüllt');
});

test('one and many', () => {
  expect([0, 1, 1500].map((n) => counted(n, 'lamp', 'lamps'))).toEqual([
    '0 lamps',
    '1 lamp',
    '1\u202f500 lamps',
  ]);
});

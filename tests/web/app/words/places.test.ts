/** Where somebody sits and looks, in the page's language. */
import { afterEach, expect, test } from '@jest/globals';
import { observerText } from '../../../../web/app/words/places.ts';
import { speak } from '../../../../web/language/language.ts';

afterEach(() => speak('en'));

test('a place that was found is told with the side that it looks to, one that a person named by its name', async () => {
  expect(['P3 +x', 'P3 -x', 'P12 +z', 'P1 -z'].map(observerText)).toEqual([
    'place 3, looking east',
    'place 3, looking west',
    'place 12, looking south',
    'place 1, looking north',
  ]);
  expect(observerText('P3 by the window')).toBe('P3 by the window');
  await speak('de');
  expect(observerText('P3 -z')).toBe('Platz 3, Blick nach Norden');
});

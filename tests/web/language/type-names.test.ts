/** Names of luminaire types: the site's own in the page's language, as its list has them; others as their makers call them. */
import { afterEach, expect, test } from '@jest/globals';
import { luminaires } from '../../../rooms/luminaire-catalog.mjs';
import { speak } from '../../../web/language/language.ts';
import { typeText } from '../../../web/language/type-names.ts';

afterEach(() => speak('en'));

const own = (name: string) => typeText({ name, maker: 'Fiat Lux' });

test('luminaires of the list are called in German as the list calls them', async () => {
  for (const { title } of luminaires) expect(own(title)).toBe(title);
  await speak('de');
  for (const { title, translations } of luminaires) expect(own(title)).toBe(translations.de.title);
  expect(own('Cylinder, pendant')).toBe('Zylinder, Pendel'); // of the restaurant
});

test('what another maker calls the same, or we do not know, keeps its name', async () => {
  await speak('de');
  expect(typeText({ name: 'Wall washer', maker: 'Someone' })).toBe('Wall washer');
  expect(own('toString')).toBe('toString');
});

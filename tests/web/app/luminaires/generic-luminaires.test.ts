/** The list of the site's generic luminaires, told in the language of the page; a list of an older site has one alone. */
import { afterEach, expect, test } from '@jest/globals';
import { genericLuminaires } from '../../../../web/app/luminaires/generic-luminaires.ts';
import { speak } from '../../../../web/language/language.ts';

const fetchBefore = globalThis.fetch;
const documentBefore = globalThis.document;

afterEach(async () => {
  globalThis.fetch = fetchBefore;
  globalThis.document = documentBefore;
  await speak('en');
});

test('is told in the language of the page where it has words in it', async () => {
  const list = [
    {
      title: 'Panel 600, batwing',
      description: 'Even tables.',
      translations: { de: { title: 'Panel 600, breitstrahlend', description: 'Gleichmäßig helle Tische.' } },
      file: 'a.ldt',
    },
    { title: 'Older', description: 'As it was.', file: 'b.ies' },
  ];
  globalThis.document = { baseURI: 'http://site/' } as Document;
  globalThis.fetch = async () => Response.json(list);
  const titles = async () => (await genericLuminaires()).map(({ title }) => title);
  expect(await titles()).toEqual(['Panel 600, batwing', 'Older']);
  await speak('de');
  expect(await titles()).toEqual(['Panel 600, breitstrahlend', 'Older']);
});

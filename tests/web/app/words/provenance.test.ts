/** What a room's file tells of its light before anything is read off it, over the picture. */
import { afterEach, expect, test } from '@jest/globals';
import { lightNote } from '../../../../web/app/words/provenance.ts';
import { speak } from '../../../../web/language/language.ts';

afterEach(() => speak('en'));

test('a room that loses much of its light says so over the picture', async () => {
  const note = lightNote({ provenance: { lostLight: 0.71 } });
  expect(note?.title).toBe('Much of the light is lost');
  expect(note?.text).toMatch(/^71 % of it leaves/);
  expect(lightNote({ provenance: { lostLight: 0.05 } })).toBeNull();
  expect(lightNote({ provenance: null })).toBeNull();
  await speak('de');
  expect(lightNote({ provenance: { lostLight: 0.71 } })?.title).toBe('Viel Licht geht verloren');
});

test('a room whose light is of no use says why, whatever is lost', async () => {
  const useless =
    'everything is black: surfaces reflect 0 % of the light, as where colours were lost on export; pass --reflectance MATERIAL=0.5 for each';
  expect(lightNote({ provenance: { useless, lostLight: 0.9 } })?.text).toMatch(/^Everything is black/);
  await speak('de');
  expect(lightNote({ provenance: { useless } })?.text).toMatch(
    /^Alles ist schwarz: Die Flächen reflektieren 0 %/,
  );
});

/** What a room's file tells of its light before anything is read off it, over the picture. */
import { afterEach, expect, test } from '@jest/globals';
import { lightNote } from '../../../../web/app/words/provenance.ts';
import { speak } from '../../../../web/language/language.ts';

afterEach(() => speak('en'));

test('a room that loses much of its light says so over the picture', async () => {
  const note = lightNote({ provenance: { lostLight: 0.71 } }, false);
  expect(note?.title).toBe('Much of the light is lost');
  expect(note?.text).toMatch(/^71 % of it leaves/);
  expect(lightNote({ provenance: { lostLight: 0.05 } }, false)).toBeNull();
  expect(lightNote({ provenance: null }, false)).toBeNull();
  await speak('de');
  expect(lightNote({ provenance: { lostLight: 0.71 } }, false)?.title).toBe('Viel Licht geht verloren');
});

test('what closes openings is named as the sheet calls it, where the room has one', async () => {
  const textOf = (hasSheet: boolean) => lightNote({ provenance: { lostLight: 0.71 } }, hasSheet)?.text;
  expect(textOf(false)).toMatch(/; where openings are to be closed, close them in the model\.$/);
  expect(textOf(true)).toMatch(
    /in the model, or under “How it was understood”: “Choose one room”, click inside it, then “Close its doors and windows”\.$/,
  );
  await speak('de');
  expect(textOf(true)).toMatch(
    /„Einen Raum wählen“, in ihn klicken, dann „Türen und Fenster verschließen“\.$/,
  );
});

test('a room whose light is of no use says why, whatever is lost', async () => {
  const useless =
    'everything is black: surfaces reflect 0 % of the light, as where colours were lost on export; pass --reflectance MATERIAL=0.5 for each';
  expect(lightNote({ provenance: { useless, lostLight: 0.9 } }, false)?.text).toMatch(/^Everything is black/);
  await speak('de');
  expect(lightNote({ provenance: { useless } }, true)?.text).toMatch(
    /^Alles ist schwarz: Die Flächen reflektieren 0 %/,
  );
});

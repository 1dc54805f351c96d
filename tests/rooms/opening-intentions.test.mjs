// What the precompute is asked for a room's first light is what the page asks when it opens the room.
import { expect, test } from '@jest/globals';
import { catalog } from '../../rooms/catalog.mjs';
import { openingIntentions } from '../../rooms/opening-intentions.mjs';
import { intentionsOf } from '../../web/document/intentions.ts';

/** Of intentions.json, in the page's words. */
const inPageWords = ({ surface, ...rest }) => ({ ...rest, surfaces: surface });

test.each(catalog)('$id', ({ opening, precompute }) => {
  const { saving = false, quantity = 'illuminance', cards, luminaires, types } = opening;
  const document = { cards: cards.map((card) => ({ weight: 1, ...card })), saving, quantity, luminaires };
  const asked = openingIntentions(opening);
  const inFolder = ({ photometry }) => `public/luminaires/${photometry}`;
  expect(asked.luminaires).toMatchObject(luminaires);
  expect(asked.luminaires.types?.map(({ photometry }) => photometry)).toEqual(types?.map(inFolder));
  expect({
    ...asked,
    luminaires,
    goals: asked.goals.map(inPageWords),
    constraints: asked.constraints.map(inPageWords),
  }).toEqual(intentionsOf(document).intentions);
  expect(precompute.slice(-2)).toEqual(['--opening', JSON.stringify(asked)]);
});

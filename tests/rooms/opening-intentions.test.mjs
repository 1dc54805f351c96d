// What the precompute is asked for a room's first light is what the page asks when it opens the room.
import { expect, test } from '@jest/globals';
import { catalog } from '../../rooms/catalog.mjs';
import { openingIntentions } from '../../rooms/opening-intentions.mjs';
import { intentionsOf } from '../../web/document/intentions.ts';
import { asNew, maintenanceOf } from '../../web/document/maintenance.ts';

/** Of intentions.json, in the page's words. */
const inPageWords = ({ surface, ...rest }) => ({ ...rest, surfaces: surface });

test.each(catalog)('$id', ({ opening, precompute }) => {
  const { saving = false, quantity = 'illuminance', cards, luminaires, types } = opening;
  const document = { cards: cards.map((card) => ({ weight: 1, ...card })), saving, quantity, luminaires };
  const asked = openingIntentions(opening);
  const inFolder = ({ photometry }) => `public/luminaires/${photometry}`;
  const { most, arrangement, maintenance: _, ...rest } = luminaires;
  expect(asked.luminaires).toMatchObject({ ...rest, ...(most && { count: [luminaires.count, most] }) });
  expect(asked.arrangement).toEqual(arrangement);
  expect(asked.luminaires.types?.map(({ photometry }) => photometry)).toEqual(types?.map(inFolder));
  const { arrangement: __, ...onLight } = asked;
  expect({
    ...onLight,
    luminaires,
    goals: asked.goals.map(inPageWords),
    constraints: asked.constraints.map(inPageWords),
  }).toEqual(asNew(intentionsOf(document).intentions, maintenanceOf(luminaires)));
  expect(precompute.slice(-2)).toEqual(['--opening', JSON.stringify(asked)]);
});

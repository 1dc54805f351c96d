/** What rows of the verdict could reach alone. */
import { expect, jest, test } from '@jest/globals';
import { appInRoom } from '../app-in-room.ts';
import { askedAlone, figureOf } from '../../../web/app/best-figures.ts';
import type { Intentions } from '../../../web/document/types.ts';
import { impossibleText } from '../../../web/app/words/best-text.ts';
import { usualLuminaires } from '../../../web/app/rooms/opening-wish.ts';

const even = { statistic: 'uniformity', surfaces: ['floor'], min: 0.4, on: 'grid' } as const;
const asked: Intentions = {
  luminaires: usualLuminaires,
  goals: [{ statistic: 'sigma', sense: 'min', weight: 1, surfaces: ['floor'] }],
  constraints: [even, { statistic: 'mean', surfaces: ['walls'], min: 50 }],
  quantity: 'illuminance',
  glare: { max: 19 },
};

test('a row is asked for alone, by the same luminaires; observers stay, their limit goes', () => {
  expect(askedAlone(asked, even)).toEqual({ ...asked, goals: [], constraints: [even], glare: {} });
  const glare = askedAlone(asked, { ugr: 16 });
  expect(glare).toEqual({ ...asked, goals: [], constraints: [], glare: { max: 16 } });
});

test('what was met has its target, what was not is as far from it as the violation says', () => {
  expect(figureOf(even, { met: true, violation: 0 })).toBe(0.4);
  expect(figureOf(even, { met: false, violation: 0.25 })).toBeCloseTo(0.3);
  const most = { statistic: 'mean', surfaces: ['wall'], max: 50 } as const;
  expect(figureOf(most, { met: false, violation: 0.1 })).toBeCloseTo(55);
  expect(figureOf({ ugr: 19 }, { met: false, violation: 9 })).toBeCloseTo(27);
});

test('a row is called impossible where a proof says so, rounded so that it holds', () => {
  const row = { where: 'floor', what: 'U', target: 0.4, actual: 0.11, unit: '', margin: -0.7, met: false };
  expect(impossibleText(row, { found: 0.11 })).toBeNull();
  expect(impossibleText(row, { found: 0.11, limit: 0.41 })).toBeNull();
  expect(impossibleText(row, { found: 0.11, limit: 0.1412 })).toMatch(/0\.40.*0\.15 at most, proved/);
});

test('a row is searched for where a layout is shown as given, too', async () => {
  const { app, settle } = await appInRoom();
  app.addCard('illuminate', ['floor']);
  const [card] = app.store.document.value.cards;
  app.changeCard(card!.id, 'mean', (each) => ({ ...each, mean: { min: 1e6 } }));
  await settle();
  app.solving.show(app.store.shown.value!.layout);
  await settle();
  expect(app.store.progress.value.state).toBe('shown');
  const compare = jest.spyOn(app.solving, 'compare');
  app.store.tab.value = 'results';
  await settle();
  const tried = compare.mock.calls.flatMap(([variants]) => variants);
  expect(tried).toContainEqual(expect.objectContaining({ goals: [], constraints: [expect.anything()] }));
});

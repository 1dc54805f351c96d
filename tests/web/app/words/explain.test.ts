/** What cannot be met, and goals that contradict each other. */
import { expect, test } from '@jest/globals';
import { conflicting, easedCards, opposedCards } from '../../../../web/app/words/explain.ts';
import { documentFrom } from '../../../../web/app/rooms/opening-wish.ts';
import { intentionsOf } from '../../../../web/document/intentions.ts';
import type { Card, Verb } from '../../../../web/document/types.ts';
import { sixLuminaires } from '../../six-luminaires.ts';

test('what conflicts is told in the words of its card, with the number that would do', () => {
  const card: Card = { id: 'c', surfaces: ['floor'], verb: 'keep', weight: 1, mean: { min: 300, max: 400 } };
  const asked = { cards: [card], saving: false, quantity: 'illuminance', seed: 1 } as const;
  const luminaires = { ...sixLuminaires, count: 2 };
  const document = documentFrom({ ...asked, luminaires }, '', 'box');
  const { origins } = intentionsOf(document);
  const results = [
    { value: 150, met: false, violation: 0.5, margin: -0.5 },
    { value: 150, met: true, violation: 0, margin: 0.6 },
  ];
  const layout = { sites: [], flux: [], dimming: 1 };
  const single = [{ change: { constraint: 0, bound: 145 }, layout }];
  expect(conflicting(document, origins, results, { conflict: [0], single })).toMatchObject([
    { field: 'mean.min', asked: 300, reached: 150, met: false, way: { change: { bound: 145 } } },
  ]);
  const eased = (bound: number | null) => easedCards(document.cards, origins, [{ constraint: 0, bound }]);
  expect(eased(145)[0]?.mean).toEqual({ min: 145, max: 400 });
  expect(eased(null)[0]?.mean).toEqual({ max: 400 });
});

test('goals that pull the same surfaces in opposite directions are named', () => {
  const card = (id: string, verb: Verb, surfaces: string[], weight = 1) => ({ id, verb, surfaces, weight });
  const pairs = (...cards: Card[]) => opposedCards(cards).map((pair) => pair.map(({ id }) => id));
  const up = card('up', 'illuminate', ['floor', 'wall']);
  expect(pairs(card('down', 'overshadow', ['wall', 'floor']), up)).toEqual([['up', 'down']]);
  expect(pairs(up, card('down', 'overshadow', ['wall']))).toEqual([]);
  expect(pairs(up, card('down', 'overshadow', ['wall', 'floor'], 0))).toEqual([]);
  expect(pairs(up, card('vary', 'vary', ['floor', 'wall']))).toEqual([]);
});

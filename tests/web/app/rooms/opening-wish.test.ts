/** Bounds that are shares of what can be had in a room. */
import { expect, test } from '@jest/globals';
import {
  asEvenLight,
  askedOfUnknown,
  hasShares,
  usualLuminaires,
  withoutShares,
  withSharesFound,
  type OpeningCard,
  type OpeningWish,
} from '../../../../web/app/rooms/opening-wish.ts';

const wall: OpeningCard = {
  id: 'a',
  surfaces: ['wall'],
  verb: 'homogenize',
  weight: 1,
  mean: { min: { illuminate: 0.3 / 0.42 }, max: { illuminate: 0.35 / 0.42 } },
  spread: { min: { homogenize: 0.75, vary: 0.25 }, max: 90 },
  guarantee: { by: 'chebyshev', alpha: 2, min: { illuminate: 0.05 } },
};
const wish: OpeningWish = {
  cards: [wall, { id: 'b', surfaces: ['floor'], verb: 'overshadow', weight: 0.5, mean: { max: 7 } }],
  luminaires: usualLuminaires,
  saving: false,
  quantity: 'exitance',
  seed: 1,
};

test('are left out until they are known, and nothing is left of a range without ends', () => {
  expect(hasShares(wish)).toBe(true);
  const asked = withoutShares(wish);
  expect(asked.cards).toEqual([
    { id: 'a', surfaces: ['wall'], verb: 'homogenize', weight: 1, spread: { max: 90 } },
    wish.cards[1],
  ]);
  expect(hasShares(asked)).toBe(false);
});

test('are sums of shares, to three digits; each best is asked for once', async () => {
  const asked: string[] = [];
  const best = async (verb: string, surfaces: readonly string[]) => {
    asked.push(`${verb} ${surfaces.join()}`);
    return { illuminate: 123.456, homogenize: 10, vary: 50 }[verb] ?? NaN;
  };
  const { cards } = await withSharesFound(wish, best);
  expect(cards[0]).toMatchObject({
    mean: { min: 88.2, max: 103 },
    spread: { min: 20, max: 90 },
    guarantee: { by: 'chebyshev', alpha: 2, min: 6.17 },
  });
  expect(cards[1]).toEqual(wish.cards[1]);
  expect(asked).toEqual(['illuminate wall', 'homogenize wall', 'vary wall']);
});

test('a room that nobody has described is lit where its file says, else on its measuring plane or floor', () => {
  const surfaces = [
    { name: 'house/floor', measuring: false },
    { name: 'desk plane', measuring: true },
  ];
  const ask = { surface: 'house/floor', mean: 240, count: 24, apart: 1.2 };
  expect(askedOfUnknown(surfaces, 100, { ask })).toMatchObject({
    cards: [{ surfaces: ['house/floor'], verb: 'illuminate', mean: { min: 240 } }],
    luminaires: { count: 24, minDistance: 1.2 },
  });
  const { apart: _, ...older } = ask;
  expect(askedOfUnknown(surfaces, 100, { ask: older })).toMatchObject({
    cards: [{ verb: 'homogenize' }],
    luminaires: { count: 24, minDistance: 0 },
  });
  expect(asEvenLight(askedOfUnknown(surfaces, 100, { ask }))).toMatchObject({
    cards: [{ surfaces: ['house/floor'], verb: 'homogenize', mean: { min: 240 } }],
    luminaires: { count: 24, minDistance: 0 },
  });
  expect(askedOfUnknown(surfaces, 4, { ask }).luminaires.count).toBe(4);
  for (const odd of [undefined, { ask: { ...ask, surface: 'roof' } }, { ask: { ...ask, count: -1 } }])
    expect(askedOfUnknown(surfaces, 4, odd)).toMatchObject({
      cards: [{ surfaces: ['desk plane'], verb: 'illuminate' }],
      luminaires: { count: 4 },
    });
  expect(askedOfUnknown(surfaces.slice(0, 1), 400).cards[0]?.surfaces).toEqual(['house/floor']);
  expect(askedOfUnknown([{ name: 'x', measuring: false }], 1).cards[0]?.surfaces).toEqual(['all']);
});

/** What arrives from outside is bounded: every number, every length, and the characters of names. */
import { describe, expect, test } from '@jest/globals';
import * as v from 'valibot';
import { cardsSchema, cleanName, documentSchema, firstFault } from '../../../web/document/schema.ts';
import { sampleDocument } from '../sample-rooms.ts';

const document = sampleDocument('0123456789abcdef', 'office');
const faultOf = (value: unknown): string => {
  const read = v.safeParse(documentSchema, value);
  return read.success ? '' : firstFault(read.issues);
};
const { luminaires } = document;
const [card] = document.cards;

describe('a document', () => {
  test('that the app made passes as it is', () => {
    expect(v.parse(documentSchema, document)).toEqual(document);
  });

  test.each([
    ['a flux that is no number', { luminaires: { ...luminaires, flux: NaN } }, /^luminaires\.flux/],
    ['no luminaire', { luminaires: { ...luminaires, count: 0 } }, /^luminaires\.count/],
    ['half a luminaire', { luminaires: { ...luminaires, count: 1.5 } }, /^luminaires\.count/],
    ['501 luminaires', { luminaires: { ...luminaires, count: 501 } }, /^luminaires\.count/],
    ['dimming upside down', { luminaires: { ...luminaires, dimming: [1, 0.5] } }, /upside down/],
    ['61 cards', { cards: Array.from({ length: 61 }, () => card) }, /^cards/],
    ['a card of nothing', { cards: [{ ...card, surfaces: [] }] }, /^cards\.0\.surfaces/],
    ['an endless bound', { cards: [{ ...card, mean: { min: Infinity } }] }, /^cards\.0\.mean\.min/],
    ['a share for a bound', { cards: [{ ...card, mean: { min: { illuminate: 1 } } }] }, /^cards\.0\.mean/],
    ['sites without fluxes', { layout: { sites: [1], flux: [], dimming: 1 } }, /differ in number/],
    ['a seed below 0', { seed: -1 }, /^seed/],
    ['another quantity', { quantity: 'luminance' }, /^quantity/],
    ['an identity that is none', { scene: 'office' }, /^scene/],
  ])('with %s is refused, and the fault has its place', (_, change, fault) => {
    expect(faultOf({ ...document, ...change })).toMatch(fault);
  });

  test('loses what it does not know, and what could mislead in a name', () => {
    const parsed = v.parse(documentSchema, { ...document, room: 'off\u202eice\u0000', extra: 1 });
    expect(parsed.room).toBe('office');
    expect(parsed).not.toHaveProperty('extra');
    expect(cleanName('a'.repeat(300))).toHaveLength(200);
  });
});

test('an optional bound is there or not, never undefined', () => {
  expect(v.safeParse(cardsSchema, [{ ...card, uniformity: undefined }]).success).toBe(false);
});

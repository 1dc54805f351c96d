/** When no layout meets the intentions: the bounds that conflict (app/relief.ts), in the words of their cards. */
import {
  boundOf,
  planeStatistics,
  withBound,
  type BoundField,
  type Origin,
} from '../../document/intentions.ts';
import type { Card, FiatLuxDocument, Verb } from '../../document/types.ts';
import type { IntentionResult } from '../../solver/protocol.ts';
import type { EasedBound, Relief, Way } from '../relief.ts';
import { alphaText } from './format.ts';
import { placesText } from './places.ts';
import { words } from '../../language/language.ts';

/** What a relief says of a bound, in the words of its card. */
export interface Conflicting {
  readonly card: Card;
  readonly field: BoundField;
  readonly asked: number;
  readonly reached: number;
  readonly met: boolean; // in the layout shown, at the cost of the others
  readonly way: Way<EasedBound> | null; // with which all the others are met
}

/** The bounds that cannot be met together, those first that are missed by the most. */
export function conflicting(
  document: FiatLuxDocument,
  origins: readonly Origin[],
  results: readonly IntentionResult[],
  { conflict, single }: Pick<Relief, 'conflict' | 'single'>,
): Conflicting[] {
  return conflict.flatMap((constraint) => {
    const [origin, result] = [origins[constraint], results[constraint]];
    const card = document.cards.find((each) => each.id === origin?.card);
    const asked = card && origin && boundOf(card, origin.field);
    if (!origin || !result || !card || asked === undefined) return [];
    const way = single.find(({ change }) => change.constraint === constraint) ?? null;
    return [{ card, field: origin.field, asked, reached: result.value, met: result.met, way }];
  });
}

/** The cards with bounds eased; one that is null goes. */
export function easedCards(
  cards: readonly Card[],
  origins: readonly Origin[],
  eased: readonly EasedBound[],
): Card[] {
  return cards.map((card) =>
    eased.reduce((next, { constraint, bound }) => {
      const origin = origins[constraint];
      return origin?.card === card.id ? withBound(next, origin.field, bound ?? undefined) : next;
    }, card),
  );
}

export function fieldText(card: Card, field: BoundField): string {
  const isOfAll = planeStatistics.some((each) => field.startsWith(each));
  const isRead = card.onGrid && (field.startsWith('mean') || field === 'uniformity');
  const text = isRead ? words.value.values.onGrid(textOf(card, field)) : textOf(card, field);
  return card.direct && !isOfAll ? words.value.values.direct(text) : text;
}

function textOf(card: Card, field: BoundField): string {
  const { by, alpha = 2 } = card.guarantee ?? {};
  const { bounds, boundsOf } = words.value.intentions;
  const guaranteed = by === 'patches' ? '' : boundsOf.guaranteed(alphaText(alpha));
  switch (field) {
    case 'guarantee.min':
      return boundsOf.spotMin(guaranteed);
    case 'guarantee.max':
      return boundsOf.spotMax(guaranteed);
    case 'contrast':
      return boundsOf.contrast(placesText(card.contrast?.over ?? []));
    default:
      return bounds[field];
  }
}

const opposite: Partial<Record<Verb, Verb>> = { illuminate: 'overshadow', homogenize: 'vary' };

/** Pairs of goals that pull the same surfaces in opposite directions: no layout can serve both. */
export function opposedCards(cards: readonly Card[]): [Card, Card][] {
  const active = cards.filter((card) => card.weight > 0 && card.aim === undefined);
  const place = (card: Card) => [...card.surfaces].sort().join('\n');
  return active.flatMap((card) =>
    active
      .filter((other) => opposite[card.verb] === other.verb && place(card) === place(other))
      .map((other): [Card, Card] => [card, other]),
  );
}

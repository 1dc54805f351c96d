/**
 * When no layout meets the intentions: which bounds bind, and the change that would make each of them possible. The layout
 * shown is the one of least violation, so a bound eased to what it reaches there is met there.
 */
import { boundOf, isRatio, withBound, type BoundField, type Origin } from '../../document/intentions.ts';
import type { Card, FiatLuxDocument, Verb } from '../../document/types.ts';
import type { IntentionResult } from '../../solver/protocol.ts';
import { alphaText, easedBound } from './format.ts';

export interface BindingBound {
  readonly card: Card;
  readonly field: BoundField;
  readonly asked: number;
  readonly reached: number;
  readonly eased: number; // what the bound would have to be
  readonly violation: number; // relative
}

/** The bounds that the shown layout breaks, the worst first. */
export function bindingBounds(
  document: FiatLuxDocument,
  origins: readonly Origin[],
  results: readonly IntentionResult[],
): BindingBound[] {
  return origins
    .flatMap((origin, index) => {
      const result = results[index];
      const card = document.cards.find((each) => each.id === origin.card);
      const asked = card && boundOf(card, origin.field);
      if (!result || result.met || !card || asked === undefined) return [];
      const end = origin.field.endsWith('max') ? 'max' : 'min';
      const eased = isRatio(origin.field)
        ? Math.max(0, Math.floor(result.value * 100 - 0.1) / 100)
        : easedBound(result.value, end);
      return [
        { card, field: origin.field, asked, reached: result.value, eased, violation: result.violation },
      ];
    })
    .sort((a, b) => b.violation - a.violation);
}

/** The cards with the given bounds eased; a bound that nothing would be left of goes. */
export function easedCards(cards: readonly Card[], bounds: readonly BindingBound[]): Card[] {
  return cards.map((card) =>
    bounds
      .filter((bound) => bound.card.id === card.id)
      .reduce((next, bound) => withBound(next, bound.field, bound.eased > 0 ? bound.eased : undefined), card),
  );
}

/**
 * The flux of each luminaire that would lift every broken lower bound on light, with the places as they are (light is
 * linear in flux); null where that is not what is missing.
 */
export function fluxThatWouldDo(document: FiatLuxDocument, bounds: readonly BindingBound[]): number | null {
  const liftable = bounds.every(
    ({ field, reached }) => (field === 'mean.min' || field === 'guarantee.min') && reached > 0,
  );
  if (!liftable || bounds.length === 0) return null;
  const factor = Math.max(...bounds.map(({ asked, reached }) => asked / reached));
  const flux = Math.ceil((document.luminaires.flux * factor * 1.005) / 10) * 10;
  return factor <= 20 ? flux : null;
}

export function fieldText(card: Card, field: BoundField): string {
  const { by, alpha = 2 } = card.guarantee ?? {};
  const guaranteed = by === 'patches' ? '' : ` (guaranteed, α ${alphaText(alpha)})`;
  switch (field) {
    case 'mean.min':
      return 'mean at least';
    case 'mean.max':
      return 'mean at most';
    case 'spread.min':
      return 'spread at least';
    case 'spread.max':
      return 'spread at most';
    case 'guarantee.min':
      return `darkest spot${guaranteed} at least`;
    case 'guarantee.max':
      return `brightest spot${guaranteed} at most`;
    case 'uniformity':
      return 'evenness Uₒ at least';
    case 'contrast':
      return `contrast over ${card.contrast?.over.join(', ') ?? ''} at least`;
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

/** "Check this layout": what recomputing every surface from its patches has shown, as one sentence. */
import { boundOf, isUpper, type Origin } from '../../document/intentions.ts';
import type { FiatLuxDocument, Layout } from '../../document/types.ts';
import { fieldText } from './explain.ts';
import { placesText } from './places.ts';
import { compact, percent, unitOfBound } from './format.ts';
import { fine } from './provenance.ts';
import { words } from '../../language/language.ts';
import { surfaceText } from '../../language/surface-names.ts';

export interface LayoutCheck {
  readonly layout: Layout; // the one that was checked
  readonly largestDifference: number; // of a mean or a spread, as a share of the surface's mean
  readonly surface: string;
  readonly margins: readonly { readonly constraint: number; readonly margin: number }[]; // relative, < 0 = not met
}

const little = 0.02; // a margin below this is worth naming

/** Names at most three bounds: those with the least to spare. */
export function checkText(
  { largestDifference, surface, margins }: LayoutCheck,
  document: FiatLuxDocument,
  origins: readonly Origin[],
): string {
  const where =
    surface === 'all'
      ? words.value.results.check.wholeRoom
      : words.value.results.check.surface(surfaceText(surface));
  const difference = words.value.results.check.difference(fine(largestDifference), where);
  if (margins.length === 0) return difference;
  const tight = [...margins].filter(({ margin }) => margin < little).sort((a, b) => a.margin - b.margin);
  if (tight.length === 0) {
    const least = Math.min(...margins.map(({ margin }) => margin));
    return words.value.results.check.spare(difference, percent(least));
  }
  const named = tight.slice(0, 3).flatMap(({ constraint, margin }) => {
    const origin = origins[constraint];
    const card = origin && document.cards.find((each) => each.id === origin.card);
    const bound = card && boundOf(card, origin.field);
    if (!card || bound === undefined) return [];
    const unit = ` ${unitOfBound(origin.field, document.quantity)}`.trimEnd();
    const what = `${placesText(card.surfaces)}: ${fieldText(card, origin.field)} ${compact(bound)}${unit}`;
    return [`${what}, ${marginText(margin, { isMost: isUpper(origin.field) })}`];
  });
  const more = tight.length > 3 ? words.value.results.check.more(tight.length - 3) : '';
  return words.value.results.check.little(difference, named.join('; '), more);
}

// Rounding of the sums, and of bounds that are met exactly.
const exactly = 1e-6;

interface OfBound {
  readonly isMost?: boolean; // it is an upper one
  readonly isMet?: boolean; // what is missed by next to nothing is, too
}

/** "3.0 % to spare", "0.4 % short" of a lower bound, "0.4 % over" an upper one, "within 0.02 %" where that counts as met. */
export function marginText(margin: number, { isMost = false, isMet = false }: OfBound = {}): string {
  if (Math.abs(margin) <= exactly) return words.value.values.exactly;
  if (isMet && margin < 0) return words.value.values.within(fine(-margin));
  if (margin > 0) return words.value.values.toSpare(percent(margin));
  return words.value.values[isMost ? 'over' : 'short'](percent(-margin));
}

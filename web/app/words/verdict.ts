/** What was asked beside what is reached: a row for each wish and each bound, in the order of the cards. */
import { boundOf, isRatio, type TracedIntentions } from '../../document/intentions.ts';
import type { Card, FiatLuxDocument, Quantity, SceneInfo, SurfaceNames } from '../../document/types.ts';
import { leavesOf } from '../../document/surface-names.ts';
import type { Shown, SurfaceResult } from '../../solver/protocol.ts';
import { patchesOf, sampleOf } from '../state/statistics.ts';
import { fieldText } from './explain.ts';
import { compact, ratio, unitOf } from './format.ts';

export interface Verdict {
  readonly where: string;
  readonly what: string; // "mean at least"
  readonly target: number | null; // null: as much, as little or as even as can be
  readonly actual: number;
  readonly unit: string; // of both; '' for a ratio
  readonly margin: number | null; // relative, negative = short; null where nothing is to be met
  readonly met: boolean | null; // null = a wish without a bound
}

type Asked = Pick<FiatLuxDocument, 'cards' | 'quantity'>;

export function verdicts(
  document: Asked,
  { origins }: Pick<TracedIntentions, 'origins'>,
  shown: Pick<Shown, 'constraints' | 'surfaces' | 'illuminance'>,
  scene: SceneInfo,
): Verdict[] {
  const unit = unitOf(document.quantity);
  return document.cards.flatMap((card) => {
    const where = namesOf(card.surfaces);
    const bounds = origins.flatMap((origin, i): Verdict[] => {
      const target = boundOf(card, origin.field);
      const result = shown.constraints[i];
      if (origin.card !== card.id || target === undefined || !result) return [];
      return [
        {
          where,
          what: fieldText(card, origin.field),
          target,
          actual: result.value,
          unit: isRatio(origin.field) ? '' : unit,
          margin: result.margin,
          met: result.met,
        },
      ];
    });
    const wish = wishOf(card, reachedOn(card.surfaces, shown, scene, document.quantity));
    return wish ? [{ where, unit, margin: null, met: null, ...wish }, ...bounds] : bounds;
  });
}

/** "612 lx", "0.62". */
export function valueText(value: number, unit: string): string {
  return unit === '' ? ratio(value) : `${compact(value)} ${unit}`;
}

export function targetText({ target, unit }: Verdict): string {
  return target === null ? '–' : valueText(target, unit);
}

export const namesOf = (names: SurfaceNames): string =>
  names.map((name) => (name === 'all' ? 'whole room' : name)).join(', ');

type Readings = Pick<SurfaceResult, 'mean' | 'sigma'>;

function wishOf(card: Card, reached: Readings | null): Pick<Verdict, 'what' | 'target' | 'actual'> | null {
  if (!reached || !(card.weight > 0)) return null;
  const { mean, sigma } = reached;
  switch (card.verb) {
    case 'illuminate':
    case 'overshadow':
      if (card.aim !== undefined) return { what: 'mean about', target: card.aim, actual: mean };
      return {
        what: `mean as ${card.verb === 'illuminate' ? 'high' : 'low'} as can be`,
        target: null,
        actual: mean,
      };
    case 'homogenize':
      return { what: 'as even as can be (σ)', target: null, actual: sigma };
    case 'vary':
      return { what: 'as varied as can be (σ)', target: null, actual: sigma };
    case 'keep':
      return null;
  }
}

/** The readings of a set of surfaces: the solver's where it is one leaf or the whole room, else those of its patches. */
function reachedOn(
  names: SurfaceNames,
  shown: Pick<Shown, 'surfaces' | 'illuminance'>,
  scene: SceneInfo,
  quantity: Quantity,
): Readings | null {
  const row = names.length === 1 ? shown.surfaces.find(({ name }) => name === names[0]) : undefined;
  return (
    row ?? sampleOf(scene, shown.illuminance, patchesOf(scene, leavesOf(names, scene.surfaces)), quantity)
  );
}

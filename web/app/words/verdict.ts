/** What was asked beside what is reached: a row for each wish and each bound, in the order of the cards. */
import { leastTold, ugrText } from '../../document/glare.ts';
import { boundOf, isUpper, type BoundField, type TracedIntentions } from '../../document/intentions.ts';
import { withTaskAreas } from '../../document/task-areas.ts';
import type { Card, Constraint, FiatLuxDocument, Quantity, SceneInfo } from '../../document/types.ts';
import { leavesOf } from '../../document/surface-names.ts';
import type { Shown, SurfaceResult } from '../../solver/protocol.ts';
import { gridLightOf } from '../state/grid-light.ts';
import { patchesOf, sampleOf } from '../state/statistics.ts';
import { fieldText } from './explain.ts';
import { compact, ratio, unitOf, unitOfBound } from './format.ts';
import { marginText } from './layout-check.ts';
import { placesText } from './places.ts';
import { words } from '../../language/language.ts';
import { fixed } from '../../language/numbers.ts';

export interface Verdict {
  readonly where: string;
  readonly what: string; // "mean at least"
  readonly target: number | null; // null: as much, as little or as even as can be
  readonly actual: number | null; // null: nobody has computed it
  readonly each?: readonly [low: number, high: number]; // of single surfaces; absent: it is of one
  readonly unit: string; // of all; '' for a ratio
  readonly isMost?: boolean; // the target is the most that there may be; absent: it is not
  readonly margin: number | null; // relative, negative = missed; null where nothing is to be met
  readonly met: boolean | null; // null = a wish without a bound
  readonly alone?: Alone; // how the row could be asked for by itself; absent: it cannot
}

/** One bound, with light as the document has it (maintained where that is), or a limit of glare. */
export type Alone = Constraint | { readonly ugr: number };

/** What tells a row from the others. */
export const nameOf = ({ where, what }: Verdict): string => `${where}\n${what}`;

type Asked = Pick<FiatLuxDocument, 'cards' | 'quantity' | 'taskAreas'>;

export function verdicts(
  document: Asked,
  { origins, intentions }: Pick<TracedIntentions, 'origins' | 'intentions'>,
  shown: Pick<Shown, 'constraints' | 'grids'> & Lit,
  scene: SceneInfo,
): Verdict[] {
  const unit = unitOf(document.quantity);
  const whole = withTaskAreas(scene, document.taskAreas);
  return document.cards.flatMap((card) => {
    const singles = singlesOf(card, shown, whole, document.quantity);
    const where = placesText(card.surfaces);
    const bounds = origins.flatMap((origin, i): Verdict[] => {
      const target = boundOf(card, origin.field);
      const result = shown.constraints[i];
      const alone = intentions.constraints[i];
      if (origin.card !== card.id || target === undefined || !result) return [];
      return [
        {
          where,
          what: fieldText(card, origin.field),
          target,
          actual: result.value,
          ...rangeOf(singles.map((single) => boundedOn(card, origin.field, single, shown))),
          unit: unitOfBound(origin.field, document.quantity),
          isMost: isUpper(origin.field),
          margin: result.margin,
          met: result.met,
          ...(alone && { alone }),
        },
      ];
    });
    const told = (what: string) => (card.direct ? words.value.values.direct(what) : what);
    const wishes = wishesOf(card, reachedOn(card, shown, whole, document.quantity)).map((wish, i) => ({
      ...wish,
      ...rangeOf(singles.map((single) => wishesOf(card, single)[i]?.actual ?? null)),
    }));
    return [
      ...wishes.map((wish) => ({ where, unit, margin: null, met: null, ...wish, what: told(wish.what) })),
      ...bounds,
    ];
  });
}

/** "612 lx", "0.62". */
export function valueText(value: number | null, unit: string): string {
  if (value === null) return words.value.values.notComputed;
  if (unit === 'UGR') return ugrText(value);
  return unit === '' ? ratio(value) : `${compact(value)} ${unit}`;
}

/** "10.0 to 30.8 each": what the surfaces of a row have one by one; null where it is of one, or they read alike. */
export function singlesText({ each, unit }: Verdict): string | null {
  if (!each) return null;
  const [low, high] = [each[0], each[1]].map((value) => (unit === '' ? ratio(value) : compact(value)));
  return low === undefined || high === undefined || low === high ? null : words.value.values.each(low, high);
}

/** How far within its bound a row is, or beyond; null where nothing is to be met, or where that cannot be told. */
export function spareText({ margin, actual, target, unit, isMost = false, met }: Verdict): string | null {
  if (unit === 'UGR' && actual !== null && target !== null) {
    const spare = Math.round(10 * target) / 10 - Math.round(10 * actual) / 10; // of what is read
    if (actual < leastTold) return null;
    if (spare === 0) return words.value.values.exactly;
    const { toSpare, over } = words.value.values;
    return spare > 0 ? toSpare(fixed(spare, 1)) : over(fixed(-spare, 1));
  }
  return margin !== null && Number.isFinite(margin)
    ? marginText(margin, { isMost, isMet: met === true })
    : null;
}

export function targetText({ target, unit }: Verdict): string {
  return target === null ? '–' : valueText(target, unit);
}

type Readings = Pick<SurfaceResult, 'mean' | 'sigma' | 'min' | 'max'>;
type Lit = Pick<Shown, 'surfaces' | 'illuminance' | 'direct'>;

/** The least and the most of the values of single surfaces. */
export function rangeOf(values: readonly (number | null)[]): Pick<Verdict, 'each'> {
  const known = values.filter((value) => value !== null && Number.isFinite(value)) as number[];
  return known.length > 1 ? { each: [Math.min(...known), Math.max(...known)] } : {};
}

interface Single extends Readings {
  readonly name: string;
}

/** Each surface of a card that names several: they may all miss what they have together. */
function singlesOf({ surfaces, direct }: Card, shown: Lit, scene: SceneInfo, quantity: Quantity): Single[] {
  const leaves = surfaces.includes('all') ? [] : leavesOf(surfaces, scene.surfaces);
  if (leaves.length < 2) return [];
  return leaves.flatMap((leaf) => {
    const { name } = scene.surfaces[leaf]!;
    const reached = reachedOn({ surfaces: [name], ...(direct && { direct }) }, shown, scene, quantity);
    return reached ? [{ ...reached, name }] : [];
  });
}

/** What one surface has of that which a field of its card bounds; null of what is no reading of a single one. */
function boundedOn(
  { guarantee, onGrid }: Card,
  field: BoundField,
  { name, mean, sigma, min, max }: Single,
  shown: Pick<Shown, 'grids'>,
): number | null {
  const read = onGrid ? gridLightOf(shown, name) : { mean, uniformity: min / mean };
  const alphaSigma = guarantee?.by === 'chebyshev' ? guarantee.alpha * sigma : null;
  switch (field) {
    case 'mean.min':
    case 'mean.max':
      return read?.mean ?? null;
    case 'uniformity':
      return read?.uniformity ?? null;
    case 'spread.min':
    case 'spread.max':
      return sigma;
    case 'guarantee.min':
      return alphaSigma === null ? min : mean - alphaSigma;
    case 'guarantee.max':
      return alphaSigma === null ? max : mean + alphaSigma;
    default:
      return null;
  }
}

function wishesOf(
  card: Card,
  reached: Pick<Readings, 'mean' | 'sigma'> | null,
): Pick<Verdict, 'what' | 'target' | 'actual'>[] {
  if (!reached || !(card.weight > 0) || card.verb === 'keep') return [];
  const { mean, sigma } = reached;
  const best = {
    illuminate: { what: words.value.values.best.illuminate, target: null, actual: mean },
    overshadow: { what: words.value.values.best.overshadow, target: null, actual: mean },
    homogenize: { what: words.value.values.best.homogenize, target: null, actual: sigma },
    vary: { what: words.value.values.best.vary, target: null, actual: sigma },
  }[card.verb];
  if (card.aim === undefined) return [best];
  const about = { what: words.value.values.about, target: card.aim, actual: mean };
  return card.verb === 'illuminate' || card.verb === 'overshadow' ? [about] : [about, best];
}

/** The readings of a set of surfaces: the solver's where it is one leaf or the whole room, else those of its patches. */
function reachedOn(
  { surfaces: names, direct }: Pick<Card, 'surfaces' | 'direct'>,
  shown: Lit,
  scene: SceneInfo,
  quantity: Quantity,
): Readings | null {
  const isOwn = direct === true && quantity !== 'direct';
  const row = names.length === 1 && !isOwn ? shown.surfaces.find(({ name }) => name === names[0]) : undefined;
  if (row) return row;
  const light = isOwn ? shown.direct : shown.illuminance;
  const patches = patchesOf(scene, leavesOf(names, scene.surfaces));
  return light ? sampleOf(scene, light, patches, isOwn ? 'direct' : quantity) : null;
}

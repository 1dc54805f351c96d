/**
 * What is asked of a room when it is opened. Bounds of an opening may be shares of the best that can be had in the very
 * room: they are found out by searches for a verb alone, and until then nothing is asked of them.
 */
import { readProvenance } from '../words/provenance.ts';
import type {
  Card,
  FiatLuxDocument,
  Luminaires,
  LuminaireType,
  SurfaceNames,
  Verb,
} from '../../document/types.ts';

export type Asked = Pick<
  FiatLuxDocument,
  'cards' | 'saving' | 'luminaires' | 'quantity' | 'seed' | 'glare' | 'roomType'
>;

/** A sum of shares of what verbs alone reach on the card's surfaces, such as { homogenize: 0.5, vary: 0.5 }. */
export type Shares = { readonly [Key in Exclude<Verb, 'keep'>]?: number | undefined };
export type OpeningBound = number | Shares;

interface OpeningRange {
  readonly min?: OpeningBound;
  readonly max?: OpeningBound;
}

/** A card, some of whose bounds are shares. */
export interface OpeningCard extends Omit<Card, 'mean' | 'spread' | 'guarantee'> {
  readonly mean?: OpeningRange;
  readonly spread?: OpeningRange;
  readonly guarantee?: OpeningRange & Pick<NonNullable<Card['guarantee']>, 'by' | 'alpha'>;
}

/** A luminaire type by its photometric file in luminaires/ of the site; what is left out is as the file says. */
export interface OpeningType
  extends
    Pick<LuminaireType, 'count' | 'turns' | 'aims'>,
    Partial<Pick<LuminaireType, 'maxAimingAngle' | 'name' | 'flux' | 'watts'>> {
  readonly photometry: string;
}

export interface OpeningWish extends Omit<Asked, 'cards'> {
  readonly cards: readonly OpeningCard[];
  readonly types?: readonly OpeningType[]; // absent: Lambertian squares
}

/** The mean (illuminate, overshadow) or the spread (homogenize, vary) that a verb alone reaches on surfaces. */
export type Best = (verb: Verb, surfaces: SurfaceNames) => Promise<number>;

/** Whether a bound has to be found out before the opening can be asked as it is meant. */
export function hasShares({ cards }: OpeningWish): boolean {
  return cards.some((card) => sharesOf(card).length > 0);
}

/** The opening without the bounds that are shares. */
export function withoutShares(wish: OpeningWish): Asked {
  return { ...wish, cards: wish.cards.map((card) => withValues(card, new Map())) };
}

/** The opening with numbers for all its bounds, to three digits. Each best is asked for once. */
export async function withSharesFound(wish: OpeningWish, best: Best): Promise<Asked> {
  const known = new Map<string, number>();
  const bestOf = async (verb: Verb, surfaces: SurfaceNames) => {
    const key = [verb, ...surfaces].join('\n');
    const value = known.get(key) ?? (await best(verb, surfaces));
    known.set(key, value);
    return value;
  };
  const cards: Card[] = [];
  for (const card of wish.cards) {
    const values = new Map<Shares, number>();
    for (const shares of sharesOf(card)) {
      let sum = 0;
      for (const [verb, share] of Object.entries(shares) as [Verb, number][])
        sum += share * (await bestOf(verb, card.surfaces));
      values.set(shares, Number(sum.toPrecision(3)));
    }
    cards.push(withValues(card, values));
  }
  return { ...wish, cards };
}

function sharesOf({ mean, spread, guarantee }: OpeningCard): Shares[] {
  return [mean, spread, guarantee]
    .flatMap((range) => [range?.min, range?.max])
    .filter((bound) => typeof bound === 'object');
}

/** The card with numbers for its bounds; one without a value goes, and so does what is left without bounds. */
function withValues(card: OpeningCard, values: ReadonlyMap<Shares, number>): Card {
  const { mean, spread, guarantee, ...rest } = card;
  const valueOf = (bound: OpeningBound | undefined) =>
    typeof bound === 'object' ? values.get(bound) : bound;
  const ends = (range: OpeningRange | undefined) => {
    const [min, max] = [valueOf(range?.min), valueOf(range?.max)];
    if (min === undefined && max === undefined) return null;
    return { ...(min !== undefined && { min }), ...(max !== undefined && { max }) };
  };
  const [meanEnds, spreadEnds, guaranteeEnds] = [ends(mean), ends(spread), ends(guarantee)];
  return {
    ...rest,
    ...(meanEnds && { mean: meanEnds }),
    ...(spreadEnds && { spread: spreadEnds }),
    ...(guarantee &&
      guaranteeEnds && { guarantee: { by: guarantee.by, alpha: guarantee.alpha, ...guaranteeEnds } }),
  };
}

export const usualLuminaires: Luminaires = {
  count: 6,
  flux: 3000,
  dimming: [1, 1],
  pinned: [],
  excluded: [],
  minDistance: 0,
};

/**
 * What is asked at first of a room that nobody has described: light on what its file names for it, the floor below the
 * places or a measuring plane, at least so much, from luminaires that are no heap; of a file that names nothing, light on
 * the first of these that it has.
 */
export function askedOfUnknown(
  surfaces: readonly { name: string; measuring: boolean }[],
  sites: number,
  provenance?: unknown,
): Asked {
  const { ask } = readProvenance(provenance);
  const told = ask && surfaces.some(({ name }) => name === ask.surface) ? ask : null;
  const likely =
    surfaces.find(({ measuring }) => measuring) ?? surfaces.find(({ name }) => isFloor.test(name));
  const count = Math.max(1, Math.min(told?.count ?? usualLuminaires.count, sites));
  const isOlder = told !== null && told.apart === undefined; // of its file nothing keeps the most light from being a heap
  const card: Card = {
    id: 'c-first',
    surfaces: [told?.surface ?? likely?.name ?? 'all'],
    verb: isOlder ? 'homogenize' : 'illuminate',
    weight: 1,
    ...(told && { mean: { min: told.mean } }),
  };
  return {
    cards: [card],
    luminaires: { ...usualLuminaires, count, minDistance: told?.apart ?? 0 },
    saving: false,
    quantity: 'illuminance',
    seed: 1,
  };
}

/** Of a room that was drawn here, whose luminaires are to be a field: the same light as even as it goes. */
export function asEvenLight(asked: Asked): Asked {
  const cards = asked.cards.map((card): Card => (card.mean ? { ...card, verb: 'homogenize' } : card));
  return { ...asked, cards, luminaires: { ...asked.luminaires, minDistance: 0 } };
}

const isFloor = /(^|\/)floor( \d+)?$/i;

export function documentFrom(asked: Asked, scene: string, room: string): FiatLuxDocument {
  const { cards, saving, luminaires, quantity, seed, glare, roomType } = asked;
  const document = { scene, room, cards, saving, luminaires, quantity, seed, layout: null };
  return { ...document, ...(glare && { glare }), ...(roomType !== undefined && { roomType }) };
}

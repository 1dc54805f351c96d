/**
 * The gallery: rooms that come with the app, each with the document its first screen shows, and the experiments of
 * the paper (section 5) on its E corridor.
 */
import type { Card, FiatLuxDocument, Luminaires, SurfaceNames, Verb } from '../../document/types.ts';

export type Asked = Pick<FiatLuxDocument, 'cards' | 'saving' | 'luminaires' | 'quantity' | 'seed'>;

/** The mean (illuminate, overshadow) or the spread (homogenize, vary) that a verb alone reaches on surfaces. */
export type Best = (verb: Verb, surfaces: SurfaceNames) => Promise<number>;
export type Relative = (best: Best) => Promise<readonly Card[]>;

export interface GalleryEntry {
  readonly id: string;
  readonly room: string; // file name in scenes/
  readonly title: string;
  readonly description: string;
  readonly asked: Asked;
  /** Cards whose bounds are shares of the best that can be had in this room: found out on opening. */
  readonly relative?: Relative;
}

const rules = (count: number, flux: number, more: Partial<Luminaires> = {}): Luminaires => ({
  count,
  flux,
  dimming: [1, 1],
  pinned: [],
  excluded: [],
  minDistance: 0,
  ...more,
});

function card(verb: Verb, surfaces: SurfaceNames, more: Partial<Card> = {}): Card {
  return {
    id: `c-${surfaces.join('-').replace(/\W+/g, '-').slice(0, 30)}`,
    surfaces,
    verb,
    weight: 1,
    ...more,
  };
}

const asks = (
  cards: readonly Card[],
  luminaires: Luminaires,
  more: Partial<Pick<Asked, 'saving' | 'quantity'>> = {},
): Asked => ({
  cards,
  luminaires,
  saving: false,
  quantity: 'illuminance',
  seed: 1,
  ...more,
});

const pictures = Array.from({ length: 12 }, (_, i) => `picture ${i + 1}`);

export const rooms: readonly GalleryEntry[] = [
  {
    id: 'office',
    room: 'office',
    title: 'Open office',
    description: 'Twelve desks under a tiled ceiling; a working plane at 0.75 m, lit evenly.',
    asked: asks(
      [
        card('homogenize', ['working plane'], { mean: { min: 500, max: 650 } }),
        card('keep', ['whiteboard'], { mean: { min: 200, max: 500 } }),
      ],
      rules(15, 4000, { minDistance: 1.8 }),
    ),
  },
  {
    id: 'e-corridor',
    room: 'e-corridor',
    title: 'E corridor',
    description: 'The room of the paper: a corridor with three arms and one yellow wall.',
    asked: asks([card('homogenize', ['yellow wall'], { mean: { min: 30, max: 35 } })], rules(6, 3000)),
  },
  {
    id: 'classroom',
    room: 'classroom',
    title: 'Classroom',
    description: 'A whiteboard wall, twelve tables and a working plane at 0.75 m.',
    asked: asks(
      [
        card('homogenize', ['working plane'], { mean: { min: 500, max: 650 } }),
        card('keep', ['whiteboard'], { mean: { min: 300 } }),
      ],
      rules(12, 3500, { minDistance: 1.5 }),
    ),
  },
  {
    id: 'gallery',
    room: 'gallery',
    title: 'Gallery',
    description: 'Pictures on the walls, a free-standing wall and sculptures on plinths.',
    asked: asks(
      [
        card('homogenize', pictures, { mean: { min: 150, max: 200 } }),
        card('overshadow', ['floor'], { weight: 0.3 }),
      ],
      rules(14, 2200),
    ),
  },
  {
    id: 'box',
    room: 'box',
    title: 'Box',
    description: 'Two blocks between a red and a green wall, for a first look.',
    asked: asks([card('homogenize', ['floor'], { mean: { min: 200, max: 350 } })], rules(4, 5000)),
  },
];

const wall: SurfaceNames = ['yellow wall'];
const six = rules(6, 3000);
const exitance = { quantity: 'exitance' } as const;
const rounded = (value: number) => Number(value.toPrecision(3));
// The paper's bounds on the yellow wall as shares of the mean that its "illuminate" reaches (0.420).
const paperRange = (mean: number) => ({
  min: rounded((0.3 / 0.42) * mean),
  max: rounded((0.35 / 0.42) * mean),
});
// The paper's floor (0.1 / 0.42) cannot be met on this wall, where light falls off faster than on the paper's; this can.
const floorShare = 0.05;

/** Cards from the mean that "illuminate" reaches on the yellow wall. */
const ofBrightest =
  (cards: (mean: number) => readonly Card[]): Relative =>
  async (best) =>
    cards(await best('illuminate', wall));

/** Least spread of the whole room above a step of the ladder between the least and the largest there is. */
const ladderStep =
  (share: number): Relative =>
  async (best) => {
    const least = await best('homogenize', ['all']);
    const most = await best('vary', ['all']);
    return [card('homogenize', ['all'], { spread: { min: rounded(least + share * (most - least)) } })];
  };

const experiment = (
  id: string,
  title: string,
  description: string,
  cards: readonly Card[],
  relative?: Relative,
): GalleryEntry => ({
  id,
  room: 'e-corridor',
  title,
  description,
  asked: asks(cards, six, exitance),
  ...(relative && { relative }),
});

export const experiments: readonly GalleryEntry[] = [
  experiment('5.1-even', '5.1 Most even', 'Least spread over the whole room, six luminaires.', [
    card('homogenize', ['all']),
  ]),
  ...[0.25, 0.5, 0.75].map((share) =>
    experiment(
      `5.1-ladder-${100 * share}`,
      `5.1 Spread at least ${100 * share} %`,
      'A step between the most even and the most varied light.',
      [card('homogenize', ['all'])],
      ladderStep(share),
    ),
  ),
  experiment('5.1-varied', '5.1 Most varied', 'Largest spread over the whole room: they huddle together.', [
    card('vary', ['all']),
  ]),
  experiment(
    '5.2-illuminate',
    '5.2 Illuminate',
    'As much light on the yellow wall as six luminaires can give.',
    [card('illuminate', wall)],
  ),
  experiment('5.2-overshadow', '5.2 Overshadow', 'As little light on the yellow wall as can be.', [
    card('overshadow', wall),
  ]),
  experiment(
    '5.2-homogenize',
    '5.2 Homogenize',
    'Least spread on the yellow wall, its mean held in a range.',
    [card('homogenize', wall)],
    ofBrightest((mean) => [card('homogenize', wall, { mean: paperRange(mean) })]),
  ),
  experiment(
    '5.2-vary',
    '5.2 Vary',
    'Largest spread on the yellow wall, its mean held in the same range.',
    [card('vary', wall)],
    ofBrightest((mean) => [card('vary', wall, { mean: paperRange(mean) })]),
  ),
  ...[0.5, 0.75, 1].map((alpha) =>
    experiment(
      `5.3-alpha-${alpha}`,
      `5.3 Guarantee, α = ${alpha}`,
      `Least light on the yellow wall with μ − ${alpha === 1 ? '' : alpha}σ above a bound.`,
      [card('overshadow', wall)],
      ofBrightest((mean) => [
        card('overshadow', wall, { guarantee: { by: 'chebyshev', alpha, min: rounded(floorShare * mean) } }),
      ]),
    ),
  ),
  experiment(
    '5.4-find-alpha',
    '5.4 Find alpha',
    'The smallest alpha that keeps every patch of the wall above the bound: press “Find alpha”.',
    [card('overshadow', wall)],
    ofBrightest((mean) => [
      card('overshadow', wall, { guarantee: { by: 'chebyshev', alpha: 1, min: rounded(floorShare * mean) } }),
    ]),
  ),
];

/** A room or experiment by id. */
export function entryOf(id: string): GalleryEntry | undefined {
  return [...rooms, ...experiments].find((entry) => entry.id === id);
}

export const isRoom = (id: string): boolean => rooms.some((room) => room.room === id);

/** What is asked at first of a room that nobody has described (a file of one's own). */
export function askedOfUnknown(
  surfaces: readonly { name: string; measuring: boolean }[],
  sites: number,
): Asked {
  const plane = surfaces.find((surface) => surface.measuring)?.name ?? 'all';
  return asks([card('homogenize', [plane])], rules(Math.max(1, Math.min(6, sites)), 3000));
}

export function documentFrom(asked: Asked, scene: string, room: string): FiatLuxDocument {
  return { scene, room, ...asked, layout: null };
}

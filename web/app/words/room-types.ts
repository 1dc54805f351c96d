/**
 * What a standard asks of a whole room: one choice writes the cards that a layout can be searched for, and the verdict
 * judges everything else that is asked, on the standard's own grid. Numbers are those of standards.ts.
 */
import type { Draft } from 'immer';
import { usualMaintenance } from '../../document/maintenance.ts';
import { mostLuminaires } from '../../document/schema.ts';
import type { Card, FiatLuxDocument, LuminaireType, SceneInfo } from '../../document/types.ts';
import type { GridResult, Shown } from '../../solver/protocol.ts';
import type { OpeningType } from '../rooms/opening-wish.ts';
import type { Store } from '../state/store.ts';
import { unionOf } from '../state/statistics.ts';
import { glareVerdict } from './glare.ts';
import { presets, type Preset } from './standards.ts';
import { verdicts, type Verdict } from './verdict.ts';
import { words } from '../../language/language.ts';
import { fixed } from '../../language/numbers.ts';

export interface RoomType {
  readonly id: string;
  readonly title: () => string;
  readonly numbers: Preset;
  readonly onFloor: boolean; // the task is the floor, though there be measuring planes
  readonly cylindrical?: number; // lx
  readonly ugr?: number; // at most
  readonly luminaire?: string; // a file of the site's that serves where luminaires are of no type: squares glare
}

const numbersOf = (id: string): Preset => {
  const preset = presets.find((each) => each.id === id);
  if (!preset) throw new Error(`there is no preset "${id}"`);
  return preset;
};

export const roomTypes: readonly RoomType[] = [
  {
    id: 'writing',
    title: () => words.value.values.types.writing,
    numbers: numbersOf('writing'),
    onFloor: false,
    cylindrical: 150,
    ugr: 19,
    luminaire: 'panel.ldt',
  },
  {
    id: 'classroom',
    title: () => words.value.values.types.classroom,
    numbers: numbersOf('classroom'),
    onFloor: false,
    cylindrical: 150,
    ugr: 19,
    luminaire: 'panel.ldt',
  },
  {
    id: 'corridor',
    title: () => words.value.values.types.corridor,
    numbers: numbersOf('corridor'),
    onFloor: true,
    cylindrical: 50,
    ugr: 28,
  },
  {
    id: 'museum',
    title: () => words.value.values.types.museum,
    numbers: numbersOf('museum-high'),
    onFloor: false,
  },
];

// Cards ask of a whole surface; the mean on its grid, by which it is judged, may be less by about a hundredth.
const gridSpare = 1.02;

type Surfaces = SceneInfo['surfaces'];

const named = (surfaces: Surfaces, name: RegExp): string[] =>
  surfaces.filter((each) => !each.measuring && name.test(each.name)).map((each) => each.name);

/** Where the parts of a type are in a room; lists are empty where the room has no such surface. */
function placesOf({ onFloor, numbers }: RoomType, surfaces: Surfaces) {
  const planes = surfaces.filter(({ measuring }) => measuring).map(({ name }) => name);
  const floor = named(surfaces, /(^|\/)floor\b/i);
  const exhibits = named(surfaces, /picture (?!frames)|exhibit|sculpture/i);
  const task = numbers.most !== undefined ? exhibits : onFloor || planes.length === 0 ? floor : planes;
  return { task, walls: named(surfaces, /(^|\/| )walls?\b/i), ceiling: named(surfaces, /ceiling/i) };
}

/** The luminaires that a type would have from the site: none where a person has chosen some, or the file lights squares only. */
export function luminairesFor(
  { luminaire }: RoomType,
  { luminaires }: FiatLuxDocument,
  scene: Pick<SceneInfo, 'hasOperator'>,
): OpeningType[] {
  if (!luminaire || !scene.hasOperator || (luminaires.types ?? []).length > 0) return [];
  return [{ photometry: luminaire, count: [0, mostLuminaires], turns: [0], aims: [] }];
}

/**
 * The document asks for a type: its cards replace the others, and light is maintained. With luminaires that come from the
 * site there may be more of them than of those before, up to twice as many.
 */
export function askForType(
  draft: Draft<FiatLuxDocument>,
  type: RoomType,
  { surfaces, sites }: Pick<SceneInfo, 'surfaces' | 'sites'>,
  fromSite: readonly LuminaireType[] = [],
): void {
  const { luminaires } = draft;
  if (fromSite.length > 0) {
    luminaires.types = [...fromSite] as Draft<LuminaireType>[];
    luminaires.most ??= Math.min(2 * luminaires.count, sites.size.length, mostLuminaires);
  }
  draft.cards = cardsOf(type, surfaces) as Draft<Card>[];
  draft.roomType = type.id;
  draft.quantity = 'illuminance';
  const { max: _, ...looking } = draft.glare ?? {};
  if (type.ugr !== undefined) draft.glare = { ...looking, max: type.ugr };
  else delete draft.glare;
  luminaires.maintenance ??= [...usualMaintenance];
}

export function cardsOf(type: RoomType, surfaces: Surfaces): Card[] {
  const { numbers } = type;
  const { task, walls, ceiling } = placesOf(type, surfaces);
  const least = (id: string, names: string[], min: number | undefined): Card[] =>
    names.length > 0 && min !== undefined
      ? [{ id: `type-${id}`, surfaces: names, verb: 'keep', weight: 1, mean: { min } }]
      : [];
  if (task.length === 0) return [];
  const card: Card = { id: 'type-task', surfaces: task, verb: 'homogenize', weight: 1 };
  if (numbers.most !== undefined)
    return [{ ...card, verb: 'illuminate', guarantee: { by: 'patches', alpha: 2, max: numbers.most } }];
  return [
    {
      ...card,
      ...(numbers.required !== undefined && { mean: { min: Math.round(gridSpare * numbers.required) } }),
    },
    ...least('walls', walls, numbers.walls),
    ...least('ceiling', ceiling, numbers.ceiling),
  ];
}

/** The rows of the type first, then those of the cards. */
export function everyVerdict(store: Store, shown: Shown | null = store.shown.value): Verdict[] {
  const document = store.document.value;
  const scene = store.painted.value;
  if (!shown || !scene) return [];
  const type = roomTypes.find(({ id }) => id === document.roomType);
  const most = document.glare?.max;
  const isOfType = type?.ugr === most;
  const rows = (cards: readonly Card[]) => [
    ...verdicts({ ...document, cards }, store.traced.value, shown, scene),
    ...(most === undefined || isOfType ? [] : [glareVerdict(shown.observers, most)]),
  ];
  if (!type || document.quantity !== 'illuminance' || type.numbers.most !== undefined)
    return rows(document.cards);
  // Cards that are as the type wrote them would only say again what its own rows say.
  const written = cardsOf(type, scene.surfaces).map((card) => JSON.stringify(card));
  const others = document.cards.filter((card) => !written.includes(JSON.stringify(card)));
  return [...typeVerdicts(type, scene, shown), ...rows(others)];
}

export function typeVerdicts(type: RoomType, scene: SceneInfo, shown: Shown): Verdict[] {
  const { numbers, cylindrical, ugr } = type;
  const { task, walls, ceiling } = placesOf(type, scene.surfaces);
  const rows: Verdict[] = [];
  for (const name of task) {
    const reading = gridOf(shown, name);
    if (numbers.required !== undefined)
      rows.push(atLeast(name, words.value.values.gridMean, reading?.mean ?? null, numbers.required, 'lx'));
    if (numbers.uniformity !== undefined)
      rows.push(
        atLeast(name, words.value.values.gridUniformity, reading?.uniformity ?? null, numbers.uniformity, ''),
      );
  }
  for (const [where, names, target] of [
    [words.value.results.places.walls, walls, numbers.walls],
    [words.value.results.places.ceiling, ceiling, numbers.ceiling],
  ] as const) {
    const readings = shown.surfaces.filter(({ name }) => names.includes(name));
    const mean = readings.length > 0 ? unionOf(readings).mean : null;
    if (target !== undefined) rows.push(atLeast(where, 'Ēₘ', mean, target, 'lx'));
  }
  if (cylindrical !== undefined)
    rows.push(
      atLeast(
        words.value.values.atHeight,
        words.value.values.cylindrical,
        meanCylindrical(shown),
        cylindrical,
        'lx',
      ),
    );
  if (ugr !== undefined) rows.push(glareVerdict(shown.observers, ugr));
  return rows;
}

/** Of all pieces of a surface together; null where it has no point of a grid. */
function gridOf(
  { grids }: Pick<Shown, 'grids'>,
  surface: string,
): { mean: number; uniformity: number } | null {
  const pieces: GridResult[] = grids.filter(({ name }) => name === surface);
  const points = pieces.reduce((sum, piece) => sum + piece.points, 0);
  if (points === 0) return null;
  const mean = pieces.reduce((sum, piece) => sum + piece.points * piece.mean, 0) / points;
  const least = Math.min(...pieces.map(({ min }) => min));
  return { mean, uniformity: mean > 0 ? least / mean : 0 };
}

/** Of the observers; null where nobody looks, or the room's file cannot tell. */
function meanCylindrical({ observers }: Shown): number | null {
  if (observers.length === 0) return null;
  return observers.reduce((sum, each) => sum + each.cylindrical, 0) / observers.length;
}

function atLeast(where: string, what: string, actual: number | null, target: number, unit: string): Verdict {
  const margin = actual === null ? null : actual / target - 1;
  return {
    where,
    what: words.value.values.atLeastOf(what),
    target,
    actual,
    unit,
    margin,
    met: margin === null ? null : margin >= 0,
  };
}

/** "Maintained light, factor 0.80." */
export function maintenanceText(factor: number): string {
  return factor === 1 ? words.value.values.asNew : words.value.values.maintained(fixed(factor, 2));
}

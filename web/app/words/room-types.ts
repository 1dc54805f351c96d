/**
 * What a standard asks of a whole room: one choice writes the cards that a layout can be searched for, and the verdict
 * judges everything else that is asked, on the standard's own grid. Numbers are those of standards.ts.
 */
import type { Draft } from 'immer';
import { usualMaintenance } from '../../document/maintenance.ts';
import { mostLuminaires } from '../../document/schema.ts';
import { backgroundOf, surroundOf, withTaskAreas } from '../../document/task-areas.ts';
import type {
  Card,
  Constraint,
  FiatLuxDocument,
  LuminaireType,
  SceneInfo,
  TaskArea,
} from '../../document/types.ts';
import type { Shown } from '../../solver/protocol.ts';
import type { OpeningType } from '../rooms/opening-wish.ts';
import { gridLightOf } from '../state/grid-light.ts';
import type { Store } from '../state/store.ts';
import { unionOf } from '../state/statistics.ts';
import { glareVerdict } from './glare.ts';
import { emergency, largestDiversity, presets, type Preset } from './standards.ts';
import { verdicts, type Verdict } from './verdict.ts';
import { words } from '../../language/language.ts';
import { surfaceText } from '../../language/surface-names.ts';
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
    luminaire: 'batten.ldt',
  },
  {
    id: 'museum',
    title: () => words.value.values.types.museum,
    numbers: numbersOf('museum-high'),
    onFloor: false,
  },
  ...[emergency.escape, emergency.openArea].map((numbers) => ({
    id: numbers.id,
    title: numbers.title,
    numbers,
    onFloor: true,
    luminaire: 'emergency.ies',
  })),
];

const mostEmergency = 24;
const rounding = 1e-6; // what is met exactly may be less by that

type Surfaces = SceneInfo['surfaces'];

const named = (surfaces: Surfaces, name: RegExp): string[] =>
  surfaces.filter((each) => !each.measuring && name.test(each.name)).map((each) => each.name);

/** Task areas themselves, without the bands around them and their backgrounds. */
function routesOf(surfaces: Surfaces): string[] {
  const isPart = ({ part }: Surfaces[number]) => part !== undefined;
  const bands = new Set(surfaces.filter(isPart).map(({ name }) => surroundOf(name)));
  const rests = new Set(surfaces.map(({ name }) => backgroundOf(name)));
  return surfaces
    .filter((each) => isPart(each) && !bands.has(each.name) && !rests.has(each.name))
    .map(({ name }) => name);
}

/** Where the parts of a type are in a room; lists are empty where the room has no such surface. */
function placesOf({ onFloor, numbers }: RoomType, surfaces: Surfaces) {
  const planes = surfaces.filter(({ measuring, part }) => measuring && !part).map(({ name }) => name);
  const floor = named(surfaces, /(^|\/)floor\b/i);
  const exhibits = named(surfaces, /picture (?!frames)|exhibit|sculpture/i);
  const lit = onFloor || planes.length === 0 ? floor : planes;
  const task =
    numbers.centreLine !== undefined ? routesOf(surfaces) : numbers.most !== undefined ? exhibits : lit;
  return { task, walls: named(surfaces, /(^|\/| )walls?\b/i), ceiling: named(surfaces, /ceiling/i) };
}

/**
 * The luminaires that a type would have from the site: none where a person has chosen some, or the file lights squares only.
 * Emergency lighting has its own.
 */
export function luminairesFor(
  { luminaire, numbers }: RoomType,
  { luminaires }: FiatLuxDocument,
  scene: Pick<SceneInfo, 'hasOperator'>,
): OpeningType[] {
  if (!luminaire || !scene.hasOperator) return [];
  if (numbers.least === undefined && (luminaires.types ?? []).length > 0) return [];
  if ((luminaires.types ?? []).some(({ file, isAllowed }) => file === luminaire && isAllowed)) return [];
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
  if (type.numbers.least !== undefined) askForEmergency(draft, fromSite, sites);
  else if (fromSite.length > 0) {
    luminaires.types = [...fromSite] as Draft<LuminaireType>[];
    luminaires.most ??= Math.min(2 * luminaires.count, sites.size.length, mostLuminaires);
  }
  draft.cards = cardsOf(type, surfaces) as Draft<Card>[];
  draft.roomType = type.id;
  draft.quantity = type.numbers.least === undefined ? 'illuminance' : 'direct';
  const { max: _, ...looking } = draft.glare ?? {};
  if (type.ugr !== undefined) draft.glare = { ...looking, max: type.ugr };
  else delete draft.glare;
  luminaires.maintenance ??= [...usualMaintenance];
}

/** Other luminaires are off; of those of the emergency as few as do. */
function askForEmergency(
  draft: Draft<FiatLuxDocument>,
  fromSite: readonly LuminaireType[],
  sites: SceneInfo['sites'],
): void {
  const { luminaires } = draft;
  draft.saving = true;
  delete luminaires.arrangement;
  Object.assign(luminaires, { count: 1, most: Math.min(mostEmergency, sites.size.length) });
  Object.assign(luminaires, { pinned: [], dimming: [1, 1], minDistance: 0 });
  delete luminaires.ofType;
  if (fromSite.length === 0) return;
  const others = (luminaires.types ?? []).map((each, i) => ({ ...each, id: `n${i + 1}`, isAllowed: false }));
  luminaires.types = [...others, ...fromSite] as Draft<LuminaireType>[];
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
  if (numbers.least !== undefined) {
    const min = numbers.centreLine ?? numbers.least;
    return [{ ...card, verb: 'keep', guarantee: { by: 'patches', alpha: 2, min }, onGrid: true }];
  }
  if (numbers.most !== undefined)
    return [{ ...card, verb: 'illuminate', guarantee: { by: 'patches', alpha: 2, max: numbers.most } }];
  return [
    {
      ...card,
      ...(numbers.required !== undefined && { mean: { min: numbers.required } }),
      ...(numbers.uniformity !== undefined && { uniformity: numbers.uniformity }),
      onGrid: true,
    },
    ...least('walls', walls, numbers.walls),
    ...least('ceiling', ceiling, numbers.ceiling),
  ];
}

/** A card as a text, whatever the order of its fields. */
const textOf = (card: Card): string => JSON.stringify(Object.entries(card).sort());

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
  const quantity = type?.numbers.least === undefined ? 'illuminance' : 'direct';
  if (!type || document.quantity !== quantity || type.numbers.most !== undefined) return rows(document.cards);
  // Cards that are as the type wrote them would only say again what its own rows say.
  const whole = withTaskAreas(scene, document.taskAreas);
  const written = cardsOf(type, whole.surfaces).map(textOf);
  const others = document.cards.filter((card) => !written.includes(textOf(card)));
  const ofType =
    type.numbers.least === undefined
      ? typeVerdicts(type, scene, shown)
      : emergencyVerdicts(type, whole, shown, document.taskAreas ?? []);
  return [...ofType, ...rows(others)];
}

/** EN 1838, of direct light: everywhere, along the middle of routes, and how much brighter the brightest point is. */
function emergencyVerdicts(
  type: RoomType,
  scene: SceneInfo,
  shown: Shown,
  areas: readonly TaskArea[],
): Verdict[] {
  const { least = 0, centreLine } = type.numbers;
  const { gridLeast, centreLine: onLine, diversity, atMostOf } = words.value.values;
  return placesOf(type, scene.surfaces).task.flatMap((name) => {
    const reading = gridLightOf(shown, name);
    const bound: Constraint = { statistic: 'minimum', surfaces: [name], on: 'grid', quantity: 'direct' };
    const rows = [atLeast(surfaceText(name), gridLeast, reading?.least ?? null, least, 'lx', bound)];
    const area = areas.find((each) => each.name === name);
    const darkest = area && darkestAlong(scene, area, shown.illuminance);
    if (centreLine !== undefined)
      rows.push(atLeast(surfaceText(name), onLine, darkest ?? null, centreLine, 'lx'));
    const ratio = reading && (reading.least > 0 ? reading.most / reading.least : Infinity);
    const margin = ratio === null ? null : 1 - ratio / largestDiversity;
    const met = margin === null ? null : margin >= -rounding;
    const what = atMostOf(diversity);
    return [
      ...rows,
      { where: surfaceText(name), what, target: largestDiversity, actual: ratio, unit: '', margin, met },
    ];
  });
}

/** The least light on the line through the middle of an area, along its longer side; null where no point lies on it. */
function darkestAlong(scene: SceneInfo, { outline, name }: TaskArea, light: Float32Array): number | null {
  const rows = scene.surfaces.find((each) => each.name === name)?.part?.rows ?? [];
  const extent = [0, 1].map((axis) => {
    const ends = outline.map((corner) => corner[axis]!);
    return [Math.min(...ends), Math.max(...ends)] as const;
  });
  const across = extent[0]![1] - extent[0]![0] >= extent[1]![1] - extent[1]![0] ? 1 : 0;
  const middle = (extent[across]![0] + extent[across]![1]) / 2;
  const onLine = [...rows].filter((row) => {
    const away = Math.abs(scene.patchCenter[3 * row + 2 * across]! - middle);
    return away <= Math.sqrt(scene.patchArea[row]!) / 2 + 1e-6;
  });
  return onLine.length > 0 ? Math.min(...onLine.map((row) => light[row]!)) : null;
}

export function typeVerdicts(type: RoomType, scene: SceneInfo, shown: Shown): Verdict[] {
  const { numbers, cylindrical, ugr } = type;
  const { task, walls, ceiling } = placesOf(type, scene.surfaces);
  const rows: Verdict[] = [];
  for (const name of task) {
    const reading = gridLightOf(shown, name);
    if (numbers.required !== undefined)
      rows.push(
        atLeast(
          surfaceText(name),
          words.value.values.gridMean,
          reading?.mean ?? null,
          numbers.required,
          'lx',
          {
            statistic: 'mean',
            surfaces: [name],
            on: 'grid',
          },
        ),
      );
    if (numbers.uniformity !== undefined)
      rows.push(
        atLeast(
          surfaceText(name),
          words.value.values.gridUniformity,
          reading?.uniformity ?? null,
          numbers.uniformity,
          '',
          {
            statistic: 'uniformity',
            surfaces: [name],
            on: 'grid',
          },
        ),
      );
  }
  for (const [where, names, target] of [
    [words.value.results.places.walls, walls, numbers.walls],
    [words.value.results.places.ceiling, ceiling, numbers.ceiling],
  ] as const) {
    const readings = shown.surfaces.filter(({ name }) => names.includes(name));
    const mean = readings.length > 0 ? unionOf(readings).mean : null;
    if (target !== undefined)
      rows.push(atLeast(where, 'Ēₘ', mean, target, 'lx', { statistic: 'mean', surfaces: names }));
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

/** Of the observers; null where nobody looks, or the room's file cannot tell. */
function meanCylindrical({ observers }: Shown): number | null {
  if (observers.length === 0) return null;
  return observers.reduce((sum, each) => sum + each.cylindrical, 0) / observers.length;
}

/** `alone`: what the row could be asked for by, without its bound. */
function atLeast(
  where: string,
  what: string,
  actual: number | null,
  target: number,
  unit: string,
  alone?: Constraint,
): Verdict {
  const margin = actual === null ? null : actual / target - 1;
  return {
    where,
    what: words.value.values.atLeastOf(what),
    target,
    actual,
    unit,
    margin,
    met: margin === null ? null : margin >= -rounding,
    ...(alone && { alone: { ...alone, min: target } }),
  };
}

/** "Maintained light, factor 0.80." */
export function maintenanceText(factor: number): string {
  return factor === 1 ? words.value.values.asNew : words.value.values.maintained(fixed(factor, 2));
}

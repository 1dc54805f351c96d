/**
 * What a standard asks of a whole room: one choice writes the cards that a layout can be searched for (what else is asked
 * is judged by type-verdicts.ts). Numbers are those of standards.ts.
 */
import type { Draft } from 'immer';
import { usualMaintenance } from '../../document/maintenance.ts';
import { mostLuminaires } from '../../document/schema.ts';
import { aroundTask, backgroundOf, evenness, surroundOf } from '../../document/task-areas.ts';
import type { Card, FiatLuxDocument, LuminaireType, SceneInfo } from '../../document/types.ts';
import type { OpeningType } from '../rooms/opening-wish.ts';
import { emergency, presets, type Preset } from './standards.ts';
import { words } from '../../language/language.ts';
import { fixed } from '../../language/numbers.ts';

export interface RoomType {
  readonly id: string;
  readonly title: () => string;
  readonly numbers: Preset;
  readonly onFloor: boolean; // the task is the floor, or what was drawn on it, though there be measuring planes
  readonly cylindrical?: number; // lx
  readonly ugr?: number; // at most
  readonly length?: number; // m, of that luminaire, where it is longer than places are apart
  readonly luminaire?: string; // a file of the site's that serves where luminaires are of no type: squares glare
}

const numbersOf = (id: string): Preset => {
  const preset = presets.find((each) => each.id === id);
  if (!preset) throw new Error(`there is no preset "${id}"`);
  return preset;
};

const emergencyFile = 'emergency.ies';

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
    length: 1.2,
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
    luminaire: emergencyFile,
  })),
];

const mostEmergency = 24;
const mostAfterwards = 60; // luminaires that are tried at first where nobody says how many; the help offers more

type Surfaces = SceneInfo['surfaces'];

const named = (surfaces: Surfaces, name: RegExp): string[] =>
  surfaces.filter((each) => !each.measuring && name.test(each.name)).map((each) => each.name);

/** Task areas themselves, without the bands around them and their backgrounds. */
function drawnOn(surfaces: Surfaces, leaves: readonly string[]): string[] {
  const isPart = ({ part }: Surfaces[number]) =>
    part !== undefined && leaves.includes(surfaces[part.leaf]?.name ?? '');
  const bands = new Set(surfaces.filter(isPart).map(({ name }) => surroundOf(name)));
  const rests = new Set(surfaces.map(({ name }) => backgroundOf(name)));
  return surfaces
    .filter((each) => isPart(each) && !bands.has(each.name) && !rests.has(each.name))
    .map(({ name }) => name);
}

/** Where the parts of a type are in a room; lists are empty where the room has no such surface. */
export function placesOf({ onFloor, numbers }: RoomType, surfaces: Surfaces) {
  const planes = surfaces.filter(({ measuring, part }) => measuring && !part).map(({ name }) => name);
  const floor = named(surfaces, /(^|\/)floor\b/i);
  const exhibits = named(surfaces, /picture (?!frames)|exhibit|sculpture/i);
  const lit = onFloor || planes.length === 0 ? floor : planes;
  const all = surfaces.map(({ name }) => name);
  const drawn = drawnOn(surfaces, numbers.centreLine === undefined ? lit : all);
  const isOfDrawn = numbers.centreLine !== undefined || (numbers.required !== undefined && drawn.length > 0);
  const task = isOfDrawn ? drawn : numbers.most !== undefined ? exhibits : lit;
  const around = (names: string[]) => (isOfDrawn ? names.filter((name) => all.includes(name)) : []);
  return {
    task,
    surround: around(task.map(surroundOf)),
    background: around(lit.map(backgroundOf)),
    walls: named(surfaces, /(^|\/| )walls?\b/i),
    ceiling: named(surfaces, /ceiling/i),
  };
}

interface AskedOfGrid {
  readonly id: string;
  readonly names: readonly string[];
  readonly mean: number | undefined; // lx
  readonly uniformity: number | undefined;
}

/** What is asked on grids: of planes together, of task areas that were drawn and of what is around them each by itself. */
export function askedOfGrids(type: RoomType, surfaces: Surfaces): AskedOfGrid[] {
  const { required, uniformity } = type.numbers;
  const { task, surround, background } = placesOf(type, surfaces);
  if (task.length === 0) return [];
  const around = aroundTask(required ?? 0);
  const each = (id: string, list: readonly string[], mean: number | undefined, even: number | undefined) =>
    list.map((name, i) => ({ id: i === 0 ? id : `${id}-${i + 1}`, names: [name], mean, uniformity: even }));
  if (background.length + surround.length === 0)
    return [{ id: 'task', names: task, mean: required, uniformity }];
  return [
    ...each('task', task, required, uniformity),
    ...each('surround', surround, around.surround, evenness.surround),
    ...each('background', background, around.background, evenness.background),
  ];
}

/** Those that are not there for an emergency. */
const usualTypes = ({ types = [] }: { readonly types?: readonly LuminaireType[] }): LuminaireType[] =>
  types.filter(({ file }) => file !== emergencyFile);

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
  if (numbers.least === undefined && usualTypes(luminaires).length > 0) return [];
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
  if (type.numbers.least === undefined) endEmergency(luminaires, sites);
  if (type.numbers.least !== undefined) askForEmergency(draft, fromSite, sites);
  else if (fromSite.length > 0) {
    luminaires.types = [...fromSite] as Draft<LuminaireType>[];
    luminaires.most ??= Math.min(2 * luminaires.count, sites.size.length, mostLuminaires);
    if (type.length !== undefined) keepApart(luminaires, type.length);
  }
  draft.cards = cardsOf(type, surfaces) as Draft<Card>[];
  draft.roomType = type.id;
  draft.quantity = type.numbers.least === undefined ? 'illuminance' : 'direct';
  const { max: _, ...looking } = draft.glare ?? {};
  if (type.ugr !== undefined) draft.glare = { ...looking, max: type.ugr };
  else delete draft.glare;
  luminaires.maintenance ??= [...usualMaintenance];
}

/** Luminaires of a length (m), whichever way they are turned, run neither into each other nor into walls. */
function keepApart(luminaires: Draft<FiatLuxDocument>['luminaires'], length: number): void {
  luminaires.minDistance = Math.max(luminaires.minDistance, length);
  luminaires.areas ??= { keepOut: [], keepIn: [], fromWalls: 0 };
  luminaires.areas.fromWalls = Math.max(luminaires.areas.fromWalls, length / 2);
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

/** The other luminaires are on again, as many as it takes. */
function endEmergency(luminaires: Draft<FiatLuxDocument>['luminaires'], sites: SceneInfo['sites']): void {
  const { types = [] } = luminaires;
  if (!types.some(({ file, isAllowed }) => file === emergencyFile && isAllowed)) return;
  luminaires.types = usualTypes({ types }).map((each) => ({ ...each, isAllowed: true })) as Draft<
    LuminaireType[]
  >;
  luminaires.most = Math.min(sites.size.length, mostAfterwards);
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
  const ofGrids = askedOfGrids(type, surfaces).map(({ id, names, mean, uniformity }): Card => ({
    id: `type-${id}`,
    surfaces: names,
    verb: names.some((name) => task.includes(name)) ? 'homogenize' : 'keep',
    weight: 1,
    ...(mean !== undefined && { mean: { min: mean } }),
    ...(uniformity !== undefined && { uniformity }),
    onGrid: true,
  }));
  return [...ofGrids, ...least('walls', walls, numbers.walls), ...least('ceiling', ceiling, numbers.ceiling)];
}

/** "Maintained light, factor 0.80." */
export function maintenanceText(factor: number): string {
  return factor === 1 ? words.value.values.asNew : words.value.values.maintained(fixed(factor, 2));
}

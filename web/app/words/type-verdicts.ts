/** Whether the light is as a room type asks: on the standard's own grid, at its observers, and on the room's surfaces. */
import { withTaskAreas } from '../../document/task-areas.ts';
import type { Card, Constraint, SceneInfo, TaskArea } from '../../document/types.ts';
import { surfaceText } from '../../language/surface-names.ts';
import { words } from '../../language/language.ts';
import type { Shown } from '../../solver/protocol.ts';
import { gridLightOf } from '../state/grid-light.ts';
import { unionOf } from '../state/statistics.ts';
import type { Store } from '../state/store.ts';
import { glareVerdict } from './glare.ts';
import { askedOfGrids, cardsOf, placesOf, roomTypes, type RoomType } from './room-types.ts';
import { largestDiversity } from './standards.ts';
import { rangeOf, verdicts, type Verdict } from './verdict.ts';

const rounding = 1e-6; // what is met exactly may be less by that

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
  const asked = roomAsked(type, whole, scene, document.cards);
  const written = cardsOf(type, asked.surfaces).map(textOf);
  const others = document.cards.filter((card) => !written.includes(textOf(card)));
  const ofType =
    type.numbers.least === undefined
      ? typeVerdicts(type, asked, shown)
      : emergencyVerdicts(type, whole, shown, document.taskAreas ?? []);
  return [...ofType, ...rows(others)];
}

/** With its task areas where cards speak of the type's: drawn after it was chosen, they are not what is asked. */
function roomAsked(type: RoomType, whole: SceneInfo, plain: SceneInfo, cards: readonly Card[]): SceneInfo {
  const { task } = placesOf(type, whole.surfaces);
  return cards.some(({ surfaces }) => task.some((name) => surfaces.includes(name))) ? whole : plain;
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
    const rows = [atLeast(surfaceText(name), gridLeast, reading?.min ?? null, least, 'lx', bound)];
    const area = areas.find((each) => each.name === name);
    const darkest = area && darkestAlong(scene, area, shown.illuminance);
    if (centreLine !== undefined)
      rows.push(atLeast(surfaceText(name), onLine, darkest ?? null, centreLine, 'lx'));
    const ratio = reading && (reading.min > 0 ? reading.max / reading.min : Infinity);
    const margin = ratio === null ? null : 1 - ratio / largestDiversity;
    const met = margin === null ? null : margin >= -rounding;
    const what = atMostOf(diversity);
    const asked = { where: surfaceText(name), what, target: largestDiversity, unit: '', isMost: true };
    return [...rows, { ...asked, actual: ratio, margin, met }];
  });
}

/**
 * The least light on the line through the middle of an area, along its longer side, of what of it lies on the floor; null
 * where no point lies on it.
 */
function darkestAlong(scene: SceneInfo, { outline, name }: TaskArea, light: Float32Array): number | null {
  const rows = [...(scene.surfaces.find((each) => each.name === name)?.part?.rows ?? [])];
  const patch = Math.max(...rows.map((row) => Math.sqrt(scene.patchArea[row]!)));
  const extent = [0, 1].map((axis) => {
    const ends = outline.map((corner) => corner[axis]!);
    const there = rows.map((row) => scene.patchCenter[3 * row + 2 * axis]!);
    const low = Math.max(Math.min(...ends), Math.min(...there) - patch);
    return [low, Math.min(Math.max(...ends), Math.max(...there) + patch)] as const;
  });
  const across = extent[0]![1] - extent[0]![0] >= extent[1]![1] - extent[1]![0] ? 1 : 0;
  const middle = (extent[across]![0] + extent[across]![1]) / 2;
  const onLine = rows.filter((row) => {
    const away = Math.abs(scene.patchCenter[3 * row + 2 * across]! - middle);
    return away <= Math.sqrt(scene.patchArea[row]!) / 2 + 1e-6;
  });
  return onLine.length > 0 ? Math.min(...onLine.map((row) => light[row]!)) : null;
}

export function typeVerdicts(type: RoomType, scene: SceneInfo, shown: Shown): Verdict[] {
  const { numbers, cylindrical, ugr } = type;
  const { walls, ceiling } = placesOf(type, scene.surfaces);
  const { gridMean, gridUniformity } = words.value.values;
  const rows = askedOfGrids(type, scene.surfaces).flatMap(({ names, mean, uniformity }) => {
    const asked = [
      ['mean', gridMean, mean, 'lx'],
      ['uniformity', gridUniformity, uniformity, ''],
    ] as const;
    return names.flatMap((name) => {
      const reading = gridLightOf(shown, name);
      return asked.flatMap(([statistic, what, target, unit]) =>
        target === undefined
          ? []
          : atLeast(surfaceText(name), what, reading?.[statistic] ?? null, target, unit, {
              statistic,
              surfaces: [name],
              on: 'grid',
            }),
      );
    });
  });
  for (const [where, names, target] of [
    [words.value.results.places.walls, walls, numbers.walls],
    [words.value.results.places.ceiling, ceiling, numbers.ceiling],
  ] as const) {
    const readings = shown.surfaces.filter(({ name }) => names.includes(name));
    const mean = readings.length > 0 ? unionOf(readings).mean : null;
    if (target !== undefined)
      rows.push({
        ...atLeast(where, 'Ēₘ', mean, target, 'lx', { statistic: 'mean', surfaces: names }),
        ...rangeOf(readings.map((reading) => reading.mean)),
      });
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

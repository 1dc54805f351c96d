/** The work beside what it is compared with: what was asked, what it costs, and the light surface by surface. */
import type { LuminaireType, SceneInfo } from '../../document/types.ts';
import type { Shown, SurfaceResult } from '../../solver/protocol.ts';
import { folded } from '../rooms/families.ts';
import { powerOf } from '../state/power.ts';
import { unionOf } from '../state/statistics.ts';
import type { Store } from '../state/store.ts';
import type { Against } from '../variants.ts';
import { compact, ratio, tabular } from './format.ts';
import { everyVerdict } from './type-verdicts.ts';
import { targetText, valueText } from './verdict.ts';
import { fixed, shortest } from '../../language/numbers.ts';
import { words } from '../../language/language.ts';

/** What the two sides are called: that which is compared with, and the work. */
export function sidesOf(against: Against): readonly [other: string, work: string] {
  const { opened, scattered, solver, now, you } = words.value.comparing.sides;
  const names = {
    kept: ['A', 'B'],
    opened: [opened, now],
    scattered: [scattered, now],
    best: [solver, you],
  } as const;
  return names[against];
}

/** One reading of one side. */
export interface Side {
  readonly text: string;
  readonly remark?: string; // evenness of a surface
  readonly met?: boolean | null; // null or absent: nothing is to be met
}

export interface Difference {
  readonly where: string;
  readonly what: string;
  readonly other: Side;
  readonly work: Side;
  readonly change: string; // from the other to the work; '' where there is none to speak of
}

export interface Differences {
  readonly asked: readonly Difference[];
  readonly cost: readonly Difference[];
  readonly light: readonly Difference[];
}

/** null while nothing is compared. `types`: of the other luminaires. */
export function differencesOf(store: Store, types: readonly LuminaireType[] | undefined): Differences | null {
  const [other, work, scene] = [store.other.value, store.shown.value, store.scene.value];
  if (!other || !work || !scene) return null;
  const surfaces = scene.surfaces;
  const efficacy = store.efficacy.value;
  return {
    asked: askedOf(store, other),
    cost: costOf(
      [other, powerOf(other.layout, scene, efficacy, types)],
      [work, powerOf(work.layout, scene, efficacy, store.document.value.luminaires.types)],
    ),
    light: lightOf(other.surfaces, work.surfaces, store.sceneWithAreas.value?.surfaces ?? surfaces),
  };
}

/** "+12 %", "−3 %"; '' for less than half a percent. */
export function changeText(from: number, to: number): string {
  const change = 100 * (to / from - 1);
  if (!Number.isFinite(change) || Math.abs(change) < 0.5) return '';
  return `${change > 0 ? '+' : '−'}${fixed(Math.abs(change), 0)} %`;
}

function askedOf(store: Store, other: Shown): Difference[] {
  const before = everyVerdict(store, other);
  return everyVerdict(store).flatMap((row, i) => {
    const { where, unit, actual, met } = row;
    const was = before[i];
    if (!was) return [];
    const what = row.target === null ? row.what : `${row.what} ${targetText(row)}`;
    return [
      {
        where,
        what,
        other: { text: valueText(was.actual, unit), met: was.met },
        work: { text: valueText(actual, unit), met },
        change: was.actual === null || actual === null ? '' : changeText(was.actual, actual),
      },
    ];
  });
}

type Lit = readonly [Shown, ReturnType<typeof powerOf>];

function costOf([other, before]: Lit, [work, now]: Lit): Difference[] {
  const row = (what: string, unit: string, from: number, to: number): Difference => {
    const side = (value: number) => ({ text: unit ? `${compact(value)} ${unit}` : shortest(value) });
    return { where: what, what: '', other: side(from), work: side(to), change: changeText(from, to) };
  };
  const count = ({ layout }: Shown) => layout.sites.length;
  return [
    row(words.value.comparing.luminaires, '', count(other), count(work)),
    row(words.value.comparing.flux, 'lm', before.flux, now.flux),
    row(words.value.comparing.power, 'W', before.watts, now.watts),
    ...(now.floor
      ? [row(words.value.comparing.perFloor, 'W/m²', before.watts / now.floor, now.watts / now.floor)]
      : []),
  ];
}

/** What is measured is what is looked for: planes come first. */
function lightOf(
  before: readonly SurfaceResult[],
  now: readonly SurfaceResult[],
  leaves: SceneInfo['surfaces'],
): Difference[] {
  const isPlane = (leaf: number) => Number(leaves[leaf]?.measuring ?? false);
  const pairs = now
    .flatMap((row, i) => {
      const was = before.find(({ name }) => name === row.name);
      return was ? [{ row, was, plane: isPlane(i) }] : [];
    })
    .sort((a, b) => b.plane - a.plane);
  return folded(pairs, ({ row }) => row.name).map(({ title, items }) => {
    const [from, to] = [unionOf(items.map(({ was }) => was)), unionOf(items.map(({ row }) => row))];
    const side = ({ mean, min }: typeof to): Side => ({ text: tabular(mean), remark: ratio(min / mean) });
    return {
      where: title === 'all' ? words.value.results.surfaces.wholeRoom : title,
      what: '',
      other: side(from),
      work: side(to),
      change: changeText(from.mean, to.mean),
    };
  });
}

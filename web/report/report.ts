/** What stands in the report: every figure is the app's own, in the app's own words. */
import {
  areasInPlan,
  drawn,
  hungInPlan,
  readSurface,
  tasksInPlan,
  type HungInPlan,
} from '../app/exports/plan-drawings.ts';
import type { App } from '../app/app.ts';
import { folded, type Fold } from '../app/rooms/families.ts';
import { powerOf, type Power } from '../app/state/power.ts';
import { maintenanceText } from '../app/words/room-types.ts';
import { patchSize, roomFacts, roomWarnings } from '../app/words/provenance.ts';
import type { BestFigure } from '../app/best-figures.ts';
import { compact, sentence } from '../app/words/format.ts';
import { everyVerdict } from '../app/words/type-verdicts.ts';
import { spareText, type Verdict } from '../app/words/verdict.ts';
import { leni } from '../document/energy.ts';
import { maintenanceOf } from '../document/maintenance.ts';
import { lightField, type LightField } from '../document/light-field.ts';
import { paintByLeaf } from '../document/paint.ts';
import type { RoomPlan } from '../document/plan-frame.ts';
import { pointingsOf, type Pointing } from '../document/pointing.ts';
import { scheduleOf, type ScheduleRow } from '../document/schedule.ts';
import type { Display, Energy, Luminaires, Paint, Quantity, SceneInfo } from '../document/types.ts';
import type { SurfaceResult } from '../solver/protocol.ts';
import { roundRange, type Scale } from '../viewer/light/false-color.ts';
import { words } from '../language/language.ts';
import { surfaceText } from '../language/surface-names.ts';
import { fixed, locale, shortest, typed } from '../language/numbers.ts';

/** A luminaire as it is installed. */
export interface Hung extends HungInPlan {
  readonly letter: string | null; // of its type, as the schedule has it
  readonly pointing: Pointing;
}

export interface Report {
  readonly title: string;
  readonly date: string;
  readonly quantity: Quantity;
  readonly verdicts: readonly Verdict[];
  readonly best: ReadonlyMap<string, BestFigure>; // of rows that are not met, as far as it is known
  readonly power: Power;
  readonly schedule: readonly ScheduleRow[];
  readonly luminaires: readonly Hung[];
  readonly areas: ReturnType<typeof tasksInPlan>;
  readonly kept: ReturnType<typeof areasInPlan>;
  readonly surfaces: readonly Fold<SurfaceResult>[]; // measuring planes first
  readonly plan: RoomPlan;
  /** The light in plan: of which surface, and how it is coloured. */
  readonly light: { readonly name: string; readonly field: LightField; readonly scale: Scale } | null;
  readonly assumptions: readonly string[];
  readonly record: readonly (readonly [string, string])[]; // how it was computed
  readonly link: string | null; // null where it does not fit one
}

/** Throws one readable line where nothing is shown yet. */
export function reportOf(app: App): Report {
  const { store } = app;
  const what = drawn(app);
  const { scene, plan, layout } = what;
  const shown = store.shown.peek();
  if (!shown) throw new Error(words.value.actions.exports.noLayout);
  const document = store.document.peek();
  const { types } = document.luminaires;
  const best = store.bestFigures.peek();
  const efficacy = store.efficacy.peek();
  const power = powerOf(layout, scene, efficacy, types);
  const pointings = pointingsOf(layout, scene.sites, plan.frame, types);
  const schedule = scheduleOf({ ...layout, pointings }, scene.sites, plan.frame, efficacy, types);
  const isPlane = ({ name }: SurfaceResult) =>
    store.sceneWithAreas.peek()?.surfaces.some((leaf) => leaf.name === name && leaf.measuring) ?? false;
  const rows = shown.surfaces
    .filter((row) => !(isPlane(row) && document.quantity === 'exitance'))
    .sort((a, b) => Number(isPlane(b)) - Number(isPlane(a)));
  return {
    title: store.roomTitle.peek(),
    date: new Date().toLocaleDateString(locale.value, { dateStyle: 'long' }),
    quantity: document.quantity,
    verdicts: everyVerdict(store),
    best: best?.of === store.traced.peek().intentions ? best.figures : new Map(),
    power,
    schedule,
    luminaires: hungInPlan(what).map((hung, i) => ({
      ...hung,
      letter: schedule.find(({ tags }) => tags.includes(hung.tag))?.letter ?? null,
      pointing: pointings[i]!,
    })),
    areas: tasksInPlan(what, document.taskAreas),
    kept: areasInPlan(what, document.luminaires.areas),
    surfaces: folded(rows, ({ name }) => name),
    plan,
    light: lightInPlan(scene, shown.illuminance, plan, store.display.peek()),
    assumptions: [
      maintenanceText(maintenanceOf(document.luminaires)),
      ...paintedText(document.paint, scene),
      ...rulesText(document.luminaires),
      ...energyText(power, store.energy.peek()),
      ...assumptionsOf(scene, types !== undefined && types.length > 0, efficacy),
    ],
    record: [...roomFacts(scene), [words.value.results.room.identity, scene.identity]],
    link: linkOf(app),
  };
}

function lightInPlan(
  scene: SceneInfo,
  light: Float32Array,
  plan: RoomPlan,
  display: Display,
): Report['light'] {
  const leaf = readSurface(scene, light, plan.frame);
  const field = leaf === null ? null : lightField(scene, leaf, light, plan.frame);
  if (leaf === null || !field) return null;
  const most = field.values.reduce((high, value) => (value > high ? value : high), 1);
  const { colorMap, steps, logarithmic, mode } = display;
  // The scale that is on the screen, so that both pictures can be laid side by side.
  const range =
    mode === 'falseColor' && display.quantity !== 'exitance'
      ? display.range
      : roundRange(most, logarithmic, steps);
  return {
    name: surfaceText(scene.surfaces[leaf]?.name ?? ''),
    field,
    scale: { colorMap, steps, logarithmic, range },
  };
}

/** "✓ met, 3.0 % to spare"; what is met exactly says so once. */
export function verdictText(row: Verdict): string {
  const { met, unmet, exactly, wish } = words.value.report.verdicts;
  if (row.met === null) return wish;
  const spare = spareText(row);
  if (row.met && spare === words.value.values.exactly) return exactly;
  return [row.met ? met : unmet, ...(spare === null ? [] : [spare])].join(', ');
}

/** Parts of a text in turn: what stands as it is, and the index of the sign before it, which is c in "F_c". */
export const splitAtIndices = (text: string): readonly string[] => text.split(/(?<=\b[FU])_([cDd])\b/);

function assumptionsOf(scene: SceneInfo, isOfTypes: boolean, efficacy: number): string[] {
  return [
    words.value.report.assumptions.scope,
    isOfTypes ? words.value.report.assumptions.files : words.value.report.assumptions.squares,
    words.value.report.assumptions.power(shortest(efficacy)),
    words.value.report.assumptions.patches(fixed(patchSize(scene), 2)),
    words.value.report.assumptions.ownCopy,
    ...roomWarnings(scene).map(sentence),
  ];
}

/** The energy of a year, and what it is reckoned by; none in a room that names no floor. */
export function energyText({ watts, floor }: Power, energy: Required<Energy>): string[] {
  if (floor === null) return [];
  const { day, night, occupancy, constant, daylight, standby } = energy;
  return [
    words.value.report.assumptions.leni(
      compact(leni(watts, floor, energy)),
      `${typed(day)} + ${typed(night)}`,
      [occupancy, constant, daylight].map((each) => fixed(each, 2)).join(', '),
      shortest(standby),
    ),
  ];
}

/** Under which rules the luminaires hang; none where they hang anywhere. */
export function rulesText({ arrangement, minDistance, areas }: Luminaires): string[] {
  const say = words.value.report.rules;
  const rule = arrangement?.rule ?? 'free';
  const { keepOut = [], keepIn = [], fromWalls = 0 } = areas ?? {};
  const parts = [
    ...(rule === 'free' ? [] : [say.as[rule]]),
    ...(minDistance > 0 ? [say.apart(shortest(minDistance))] : []),
    ...(fromWalls > 0 ? [say.fromWalls(shortest(fromWalls))] : []),
    ...(keepOut.length + keepIn.length > 0 ? [say.areas] : []),
  ];
  return parts.length === 0 ? [] : [say.all(parts.join(', '))];
}

/** Which surfaces are not as the room's file has them. */
function paintedText(paint: readonly Paint[] | undefined, scene: SceneInfo): string[] {
  const painted = [...paintByLeaf(paint, scene.surfaces).values()];
  if (painted.length === 0 || !scene.hasOperator) return [];
  const list = painted.map(({ surface, reflectance }) => `${surfaceText(surface)} ${fixed(reflectance, 2)}`);
  return [words.value.paint.report(list.join(', '))];
}

function linkOf({ keeping }: App): string | null {
  try {
    return keeping.link().address;
  } catch {
    return null;
  }
}

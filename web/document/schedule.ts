/** The luminaires of a layout as they are ordered: a row for each kind, and what each of them draws. */
import { inPlan, type PlanFrame } from './plan-frame.ts';
import { positionOf } from './sites.ts';
import type { Layout, LuminaireType, SceneInfo } from './types.ts';
import { words } from '../language/language.ts';
import { typeText } from '../language/type-names.ts';
import { fixed } from '../language/numbers.ts';

/** What luminaire i shines and draws, after dimming. */
export interface Drawn {
  readonly type: LuminaireType | undefined; // undefined = a Lambertian square
  readonly flux: number; // lm
  readonly watts: number; // of its type where that is known, else by the efficacy
}

export function drawnBy(
  { flux, dimming, mountings }: Layout,
  index: number,
  efficacy: number, // lm/W
  types: readonly LuminaireType[] = [],
): Drawn {
  const type = types.find(({ id }) => id === mountings?.[index]?.type);
  const lumens = (flux[index] ?? 0) * dimming;
  return { type, flux: lumens, watts: type?.watts ? type.watts * dimming : lumens / efficacy };
}

export interface ScheduleRow extends Drawn {
  readonly name: string;
  readonly tags: readonly string[];
  readonly mounting: string; // "facing down at 2.80 m"
}

export function scheduleOf(
  layout: Layout,
  sites: SceneInfo['sites'],
  frame: PlanFrame,
  efficacy: number,
  types: readonly LuminaireType[] = [],
): ScheduleRow[] {
  const rows = new Map<string, ScheduleRow & { tags: string[] }>();
  layout.sites.forEach((site, index) => {
    const drawn = drawnBy(layout, index, efficacy, types);
    const name = drawn.type
      ? typeText(drawn.type)
      : words.value.report.schedule.square(fixed(sites.size[site] ?? 0, 2));
    const height = inPlan(frame, positionOf(sites, site))[2];
    const mounting = words.value.report.schedule.at(
      facing(sites.normal[3 * site + 1] ?? 0),
      fixed(height, 2),
    );
    const key = [name, drawn.flux.toFixed(1), drawn.watts.toFixed(2), mounting].join('\n');
    const row = rows.get(key);
    if (row) row.tags.push(`L${index + 1}`);
    else rows.set(key, { ...drawn, name, mounting, tags: [`L${index + 1}`] });
  });
  return [...rows.values()];
}

function facing(up: number): string {
  if (up < -0.7) return words.value.report.schedule.down;
  return up > 0.7 ? words.value.report.schedule.up : words.value.report.schedule.wall;
}

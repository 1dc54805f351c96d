/** The luminaires of a layout as they are ordered: a row for each kind, and what each of them draws. */
import { inPlan, type PlanFrame } from './plan-frame.ts';
import type { Pointing } from './pointing.ts';
import { positionOf } from './sites.ts';
import type { Layout, LuminaireType, SceneInfo } from './types.ts';
import { words } from '../language/language.ts';
import { typeText } from '../language/type-names.ts';
import { fixed, shortest } from '../language/numbers.ts';

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
  readonly letter: string | null; // of its type: "A"; null where there is one type only
  readonly tags: readonly string[];
  readonly mounting: string; // "facing down at 2.80 m"
}

export function scheduleOf(
  layout: Layout & { readonly pointings: readonly Pointing[] },
  sites: SceneInfo['sites'],
  frame: PlanFrame,
  efficacy: number,
  types: readonly LuminaireType[] = [],
): ScheduleRow[] {
  const rows = new Map<string, Omit<ScheduleRow, 'letter'> & { product: string; tags: string[] }>();
  layout.sites.forEach((site, index) => {
    const drawn = drawnBy(layout, index, efficacy, types);
    const name = drawn.type
      ? typeText(drawn.type)
      : words.value.report.schedule.square(fixed(sites.size[site] ?? 0, 2));
    const height = inPlan(frame, positionOf(sites, site))[2];
    const mounting = words.value.report.schedule.at(
      mountedText(sites.normal[3 * site + 1] ?? 0, layout.pointings[index]!),
      fixed(height, 2),
    );
    const product = [name, drawn.flux.toFixed(1), drawn.watts.toFixed(2)].join('\n');
    const key = [product, mounting].join('\n');
    const row = rows.get(key);
    if (row) row.tags.push(`L${index + 1}`);
    else rows.set(key, { ...drawn, name, mounting, product, tags: [`L${index + 1}`] });
  });
  return lettered([...rows.values()]);
}

/** What is ordered alike has one letter, however it is mounted. */
function lettered<Row extends { product: string }>(
  rows: readonly Row[],
): (Omit<Row, 'product'> & { letter: string | null })[] {
  const products = [...new Set(rows.map(({ product }) => product))];
  return rows.map(({ product, ...row }) => ({
    ...row,
    letter: products.length > 1 ? letterOf(products.indexOf(product)) : null,
  }));
}

/** A to Z, then AA, AB ... */
function letterOf(index: number): string {
  const last = String.fromCharCode(65 + (index % 26));
  return index < 26 ? last : letterOf(Math.floor(index / 26) - 1) + last;
}

/** How a mount faces, and whether its luminaire points elsewhere. */
function mountedText(up: number, { aim, lean }: Pointing): string {
  const say = words.value.report.schedule;
  const isOnWall = Math.abs(up) <= 0.7;
  if (aim || lean > 0) {
    const how = aim ? say.aimed : say.tilted(shortest(lean));
    return isOnWall ? say.leaningOnWall(how) : say.leaning(how);
  }
  if (isOnWall) return say.wall;
  return up < 0 ? say.down : say.up;
}

/**
 * The room and its luminaires as an STF project. Its Rot carries how a luminaire is turned in plan; of how it is tilted
 * there is no certain way to write it (document/stf.ts), so that the file and the page say which luminaires point elsewhere
 * than straight down.
 */
import type { Point3 } from '../../document/plan-frame.ts';
import { isOffDown, pointingsOf, type Pointing } from '../../document/pointing.ts';
import { drawnBy } from '../../document/schedule.ts';
import type { StfProject, StfType } from '../../document/stf.ts';
import type { LuminaireType, SceneInfo } from '../../document/types.ts';
import type { App } from '../app.ts';
import { drawn, hungInPlan, type Drawn } from './plan-drawings.ts';
import { words } from '../../language/language.ts';

export function stfProject(app: App, today: Date): StfProject {
  const what = drawn(app);
  const { scene, plan } = what;
  const outline = plan.outlines[0];
  if (!outline) throw new Error(words.value.actions.exports.openOutline);
  const title = app.store.roomTitle.peek();
  const efficacy = app.store.efficacy.peek();
  const types: StfType[] = [];
  const known = app.store.document.peek().luminaires.types;
  const description = descriptionOf(pointingElsewhere(what, known));
  const luminaires = hungInPlan(what).map(({ place, axis, size }, i) => {
    const isAlike = (each: StfType) => each.size.every((side, k) => side === size[k]);
    const { flux, watts, type: made } = drawnBy(what.layout, i, efficacy, known);
    const name = made?.name ?? `Lambertian square ${size[0].toFixed(2)} m, ${Math.round(flux)} lm`;
    let type = types.findIndex((each) => each.name === name && isAlike(each) && each.flux === flux);
    if (type < 0) type = types.push({ name, size, flux, watts }) - 1;
    const turned = (Math.atan2(axis[1], axis[0]) * 180) / Math.PI;
    return { type, place, rotation: [0, 0, turned] as const };
  });
  const plane = scene.surfaces.findIndex(({ measuring }) => measuring);
  const row = scene.surfaceOfPatch.indexOf(plane);
  const height = row < 0 ? 0.75 : (scene.patchCenter[3 * row + 1] ?? 0) - plan.frame.floor;
  const reflectance = {
    ceiling: reflectanceOf(scene, /ceiling/i),
    walls: reflectanceOf(scene, /wall/i),
    floor: reflectanceOf(scene, /floor/i),
  };
  const room = {
    name: title,
    height: plan.frame.size[2],
    workingPlane: height,
    outline,
    reflectance,
    luminaires,
    ...(description && { description }),
  };
  return { name: title, date: today.toISOString().slice(0, 10), rooms: [room], types };
}

/** Of the surfaces of that name, by area; one half where none is called so. */
function reflectanceOf({ surfaces }: SceneInfo, name: RegExp): number {
  const named = surfaces.filter((surface) => !surface.measuring && name.test(surface.name));
  const area = named.reduce((sum, surface) => sum + surface.area, 0);
  return area > 0 ? named.reduce((sum, each) => sum + each.area * each.reflectance, 0) / area : 0.5;
}

/** Luminaires that a program which knows their turn alone would have shine elsewhere, by their index. */
function pointingElsewhere(
  { scene: { sites }, plan: { frame }, layout }: Drawn,
  types: readonly LuminaireType[] | undefined,
): Map<number, Pointing> {
  const pointings = pointingsOf(layout, sites, frame, types);
  return new Map([...pointings.entries()].filter(([, pointing]) => isOffDown(pointing)));
}

/** In one line; null where all point straight down. */
function descriptionOf(elsewhere: ReadonlyMap<number, Pointing>): string | null {
  if (elsewhere.size === 0) return null;
  const metres = (point: Point3) => point.map((value) => (value + 0).toFixed(3)).join(' ');
  const told = [...elsewhere].map(([index, { aim, tilt, azimuth }]) => {
    const angles = `tilt ${tilt.toFixed(1)}${azimuth === null ? '' : ` azimuth ${azimuth.toFixed(1)}`}`;
    return `Lum${index + 1} ${aim ? `aimed at ${metres(aim)}, ` : ''}${angles}`;
  });
  const signs = 'tilt in degrees from straight down, azimuth in degrees from +y clockwise';
  return `Rot does not say where these luminaires point (${signs}): ${told.join('; ')}`;
}

/** What the file cannot carry, for whoever saves it; null where it carries everything. */
export function stfLoss(app: App): string | null {
  const elsewhere = pointingElsewhere(drawn(app), app.store.document.peek().luminaires.types);
  return elsewhere.size === 0
    ? null
    : words.value.actions.exports.stfPointing(tagsText([...elsewhere.keys()]));
}

/** "L1–L3, L7": indices that follow one another are a range. */
export function tagsText(indices: readonly number[]): string {
  const ranges: [first: number, last: number][] = [];
  for (const index of indices) {
    const range = ranges.at(-1);
    if (range?.[1] === index - 1) range[1] = index;
    else ranges.push([index, index]);
  }
  return ranges
    .map(([first, last]) => (first === last ? `L${first + 1}` : `L${first + 1}–L${last + 1}`))
    .join(', ');
}

/** What the light costs: flux, power, and both per floor area. */
import { drawnBy } from '../../document/schedule.ts';
import type { Layout, LuminaireType, SceneInfo } from '../../document/types.ts';
import { floorsOf, type FloorTold } from '../words/provenance.ts';

export interface Power {
  readonly flux: number; // lm, after dimming
  readonly watts: number;
  readonly floor: number | null; // m2; null in a room that names no floor
}

/** What all luminaires draw: by their types where these tell it, else by the efficacy. */
export function wattsOf(layout: Layout, efficacy: number, types?: readonly LuminaireType[]): number {
  return layout.sites.reduce((sum, _, index) => sum + drawnBy(layout, index, efficacy, types).watts, 0);
}

/** Whether the efficacy is needed to tell what luminaires draw. */
export function needsEfficacy(layout: Layout, types?: readonly LuminaireType[]): boolean {
  return layout.sites.some(
    (_, index) => !types?.find(({ id }) => id === layout.mountings?.[index]?.type)?.watts,
  );
}

/** What tells how much floor there is. */
type Floors = FloorTold & Pick<SceneInfo, 'patchArea'>;

export function powerOf(
  layout: Layout,
  scene: Floors,
  efficacy: number, // lm/W
  types?: readonly LuminaireType[],
): Power {
  const flux = layout.sites.reduce((sum, _, index) => sum + (layout.flux[index] ?? 0) * layout.dimming, 0);
  return { flux, watts: wattsOf(layout, efficacy, types), floor: floorArea(scene) };
}

/** Area of the floor, under furniture too (statistics leave that out); null in a room whose file tells of none. */
export function floorArea(scene: Floors): number | null {
  const { surfaceOfPatch, patchArea } = scene;
  const floors = new Set(floorsOf(scene));
  let area = 0;
  for (let row = 0; row < patchArea.length; row++)
    if (floors.has(surfaceOfPatch[row]!)) area += patchArea[row]!;
  return area > 0 ? area : null;
}

const aRoom = 0.4; // of the floor: a plane that measures less of it, but for a rim, is no measure of the room

/** The measuring plane that speaks for the whole room, as its index among the surfaces; null where none does. */
export function roomPlane(scene: Floors): number | null {
  const areas = scene.surfaces.map(({ measuring, area }) => (measuring ? area : 0));
  const largest = areas.indexOf(Math.max(...areas));
  return (areas[largest] ?? 0) >= aRoom * (floorArea(scene) ?? Infinity) ? largest : null;
}

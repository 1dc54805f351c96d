/** What the light costs: flux, power, and both per floor area. */
import { drawnBy } from '../../document/schedule.ts';
import type { Layout, LuminaireType } from '../../document/types.ts';

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

export function powerOf(
  layout: Layout,
  surfaces: readonly { name: string; area: number }[],
  efficacy: number, // lm/W
  types?: readonly LuminaireType[],
): Power {
  const flux = layout.sites.reduce((sum, _, index) => sum + (layout.flux[index] ?? 0) * layout.dimming, 0);
  return { flux, watts: wattsOf(layout, efficacy, types), floor: floorArea(surfaces) };
}

/** Area of what is called floor; null in a room that names none. */
export function floorArea(surfaces: readonly { name: string; area: number }[]): number | null {
  const area = surfaces
    .filter(({ name }) => /(^|\/)floor\b/i.test(name))
    .reduce((sum, surface) => sum + surface.area, 0);
  return area > 0 ? area : null;
}

/** What the light costs: flux, power, and both per floor area. */
import type { Layout } from '../../document/types.ts';

export interface Power {
  readonly flux: number; // lm, after dimming
  readonly watts: number;
  readonly floor: number | null; // m2; null in a room that names no floor
}

export function powerOf(
  layout: Layout,
  surfaces: readonly { name: string; area: number }[],
  efficacy: number, // lm/W
): Power {
  const flux = layout.flux.reduce((sum, each) => sum + each, 0) * layout.dimming;
  return { flux, watts: flux / efficacy, floor: floorArea(surfaces) };
}

/** Area of what is called floor; null in a room that names none. */
export function floorArea(surfaces: readonly { name: string; area: number }[]): number | null {
  const area = surfaces
    .filter(({ name }) => /(^|\/)floor\b/i.test(name))
    .reduce((sum, surface) => sum + surface.area, 0);
  return area > 0 ? area : null;
}

/**
 * The luminaires as CSV: id, x, y, z, flux, watts. Metres in plan from the corner of the floor, lumens after dimming,
 * watts by the stated efficacy. Where they are of types: the watts of these, then type, turn (degrees) and the point
 * each is aimed at.
 */
import { csvText } from './csv.ts';
import { inPlan, type PlanFrame, type Point3 } from './plan-frame.ts';
import { drawnBy } from './schedule.ts';
import { positionOf } from './sites.ts';
import type { Layout, LuminaireType, Mounting, SceneInfo } from './types.ts';

export function luminairesCsv(
  layout: Layout,
  sites: SceneInfo['sites'],
  frame: PlanFrame,
  efficacy: number,
  types: readonly LuminaireType[] = [],
): string {
  const { sites: places, mountings } = layout;
  const metres = (point: Point3) => inPlan(frame, point).map((value) => (value + 0).toFixed(3));
  const mountingCells = ({ turn, aim }: Mounting, type: LuminaireType | undefined) => [
    type?.name ?? '',
    String(turn),
    ...(aim ? metres(aim) : ['', '', '']),
  ];
  const rows = places.map((site, index) => {
    const mounting = mountings?.[index];
    const { type, flux, watts } = drawnBy(layout, index, efficacy, types);
    const place = [`L${index + 1}`, ...metres(positionOf(sites, site)), flux.toFixed(1), watts.toFixed(2)];
    return mounting ? [...place, ...mountingCells(mounting, type)] : place;
  });
  const head = ['id', 'x', 'y', 'z', 'flux', 'watts'];
  const ofTypes = mountings ? ['type', 'turn', 'aim x', 'aim y', 'aim z'] : [];
  return csvText([[...head, ...ofTypes], ...rows]);
}

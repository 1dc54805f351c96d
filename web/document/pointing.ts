/**
 * How luminaires point, as whoever installs them reads it: the turn is that of the mount (mounting.ts); the tilt is from
 * straight down and the azimuth in plan, which can be measured on a ladder whatever the mount is.
 */
import { frameOn } from './mounting.ts';
import { inPlan, type PlanFrame, type Point3 } from './plan-frame.ts';
import type { Layout, LuminaireType, SceneInfo } from './types.ts';

export interface Pointing {
  readonly turn: number; // degrees about the mount's normal, from its axis
  readonly aim: Point3 | null; // that gamma 0 goes through, in plan; null: it is not aimed
  readonly lean: number; // degrees of gamma 0 off the mount's normal, as its type says; 0 where it is aimed
  readonly tilt: number; // degrees of gamma 0 from straight down
  readonly azimuth: number | null; // degrees of gamma 0 from north, clockwise; null where it points straight up or down
}

const degrees = 180 / Math.PI;
const upright = 0.05; // degrees that nobody can set more exactly
const asMounted = { turn: 0, aim: null };

/** One for each luminaire. */
export function pointingsOf(
  { sites: places, mountings }: Pick<Layout, 'sites' | 'mountings'>,
  sites: SceneInfo['sites'],
  frame: PlanFrame,
  types: readonly LuminaireType[] = [],
): Pointing[] {
  return places.map((site, i) => {
    const mounting = mountings?.[i];
    const { turn, aim } = mounting ?? asMounted;
    const lean = types.find(({ id }) => id === mounting?.type)?.tilt ?? 0;
    const { down } = frameOn(sites, site, { turn, aim }, lean);
    return { turn, aim: aim && inPlan(frame, aim), lean: aim ? 0 : lean, ...anglesOf(down) };
  });
}

function anglesOf([east, up, south]: Point3): Pick<Pointing, 'tilt' | 'azimuth'> {
  const level = Math.hypot(east, south);
  const tilt = degrees * Math.atan2(level, -up);
  if (degrees * Math.atan2(level, Math.abs(up)) < upright) return { tilt, azimuth: null };
  return { tilt, azimuth: (degrees * Math.atan2(east, -south) + 360) % 360 };
}

export const isAimed = ({ aim, lean }: Pointing): boolean => aim !== null || lean > 0;

/** Whether light that is taken to go straight down would go elsewhere than it does. */
export const isOffDown = ({ tilt }: Pointing): boolean => tilt >= upright;

/** A mean that is aimed at and not reached, and the one change of the luminaires that brings it within reach. */
import { metWithin } from './intentions.ts';
import { isRatio } from './statistics.ts';
import type { Constraint, Luminaires } from './types.ts';

const near = 0.01; // of the aim
const far = 0.1; // likewise
const dimmest = 0.1; // as dimming is when it is switched on
const furthest = 20; // times the flux: what is further is no matter of flux
const spare = 0.8; // of what is needed, so that layouts that give more can be dimmed to it, too

const isOff = (mean: number, aim: number | undefined, share: number): aim is number =>
  aim !== undefined && Math.abs(mean - aim) > share * aim;

export const missesAim = (mean: number, aim: number | undefined): aim is number => isOff(mean, aim, near);

/** So far that no tick belongs beside the two figures, though every bound is met. */
export const isFarFrom = (mean: number, aim: number | undefined): boolean => isOff(mean, aim, far);

export type AimWay = { readonly dimming: readonly [number, number] } | { readonly flux: number };

/** Null where the aim is reached, and where light would come to it by neither: types have fluxes of their own. */
export function wayToAim(
  { dimming: [low, high], flux, types }: Luminaires,
  mean: number,
  aim: number | undefined,
): AimWay | null {
  if (!missesAim(mean, aim) || !(mean > 0)) return null;
  const share = aim / mean;
  if (share < 1) {
    const least = Math.min(dimmest, Math.floor(100 * spare * share) / 100);
    return least > 0 && least < low && (low === high || low > share) ? { dimming: [least, high] } : null;
  }
  if (share > furthest || (types?.length ?? 0) > 0) return null;
  const unit = flux * share >= 1000 ? 100 : 10;
  return { flux: Math.ceil((flux * share) / unit) * unit };
}

/**
 * Whether a bound pulls the other way: it is missed, or would be, once there is `share` times the light everywhere.
 * Ratios stay as they are.
 */
export function pullsBack({ statistic, min, max }: Constraint, value: number, share: number): boolean {
  if (isRatio(statistic)) return false;
  const then = statistic === 'ugr' ? value + 8 * Math.log10(share) : share * value;
  if (share < 1) return min !== undefined && then < (1 - metWithin) * min;
  return max !== undefined && then > (1 + metWithin) * max;
}

/**
 * The statistics that may be asked of the light, in the order of the core's table (core/search/statistics.h), and what
 * each is of: light, which grows with the flux and ages with the lamps; power; a ratio, which has no unit; glare.
 */
const kinds = {
  mean: 'light',
  sigma: 'light',
  power: 'power', // total lm; no surface
  chebyshev: 'light', // mu - alpha sigma >= min, mu + alpha sigma <= max
  minimum: 'light',
  maximum: 'light',
  uniformity: 'ratio', // U_o = minimum / mean
  contrast: 'ratio', // mean of `surfaces` / mean of `over`
  ugr: 'glare', // unified glare rating of the worst observer; no surface
  // Of the points of measuring planes:
  cylindrical: 'light', // E_z
  modelling: 'ratio', // E_z / E_h
  vertical: 'light', // on vertical planes that face a direction
} as const;

export type Statistic = keyof typeof kinds;

export const statistics = Object.keys(kinds) as readonly Statistic[];

export const isOfLight = (statistic: Statistic): boolean => kinds[statistic] === 'light';
export const isRatio = (statistic: Statistic): boolean => kinds[statistic] === 'ratio';

/** What lighting draws in a year, as LENI of EN 15193-1: (W_L + W_P) / A. */
import { usualEfficacy } from './photometry.ts';
import type { Energy, FiatLuxDocument } from './types.ts';

/** An office where nobody switches or dims and no control waits. */
export const usualEnergy: Required<Energy> = {
  efficacy: usualEfficacy,
  day: 2250,
  night: 250,
  occupancy: 1,
  constant: 1,
  daylight: 1,
  standby: 0,
};

const hoursAYear = 8760;

/** The settings of LENI: what they are called in the standard, their unit, the largest, and a step of them. */
export const energySettings = [
  ['day', 't_D', 'h', hoursAYear, 50],
  ['night', 't_N', 'h', hoursAYear, 50],
  ['occupancy', 'F_o', '', 1, 0.05],
  ['constant', 'F_c', '', 1, 0.05],
  ['daylight', 'F_D', '', 1, 0.05],
  ['standby', 'W_P', 'kWh/(m² a)', 100, 0.1],
] as const satisfies readonly (readonly [keyof Energy, string, string, number, number])[];

export const energyOf = ({ energy }: Pick<FiatLuxDocument, 'energy'>): Required<Energy> => ({
  ...usualEnergy,
  ...energy,
});

/** kWh a year and m2 of floor, for so many watts. */
export function leni(watts: number, floor: number, energy: Required<Energy> = usualEnergy): number {
  const { day, night, occupancy, constant, daylight, standby } = energy;
  return (watts * constant * occupancy * (day * daylight + night)) / 1000 / floor + standby;
}

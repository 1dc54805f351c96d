/**
 * Maintained light: what is left of the light of a new installation when lamps have aged and dirt has settled (CIE 97).
 * Where a document has maintenance factors, every lux that is asked for and shown is maintained; the core knows nothing
 * of it and computes new installations: light is linear, so bounds go in divided and readings come back multiplied.
 */
import { isOfLight } from './statistics.ts';
import type { Constraint, Goal, Intentions, Luminaires } from './types.ts';
import { words } from '../language/language.ts';

/** The factors by their names in CIE 97, in the order in which a document keeps them. */
export const maintenanceFactors = [
  ['LLMF', () => words.value.luminaires.maintenance.names.llmf],
  ['LSF', () => words.value.luminaires.maintenance.names.lsf],
  ['LMF', () => words.value.luminaires.maintenance.names.lmf],
  ['RMF', () => words.value.luminaires.maintenance.names.rmf],
] as const;

export type Maintenance = NonNullable<Luminaires['maintenance']>;

/** 0.80: a clean room, LED, cleaned every other year. */
export const usualMaintenance: Maintenance = [0.9, 1, 0.95, 0.94];

/** The product; 1 where a document says nothing: then light is that of the new installation. */
export function maintenanceOf({ maintenance }: Pick<Luminaires, 'maintenance'>): number {
  return maintenance ? Math.round(maintenance.reduce((product, each) => product * each, 1) * 100) / 100 : 1;
}

/** What the new installation has to reach for maintained light to be as it is asked. */
export function asNew(intentions: Intentions, factor: number): Intentions {
  if (factor === 1) return intentions;
  const scaled = (constraint: Constraint): Constraint => {
    if (!isOfLight(constraint.statistic)) return constraint;
    const { min, max } = constraint;
    return {
      ...constraint,
      ...(min !== undefined && { min: min / factor }),
      ...(max !== undefined && { max: max / factor }),
    };
  };
  const aimed = (goal: Goal): Goal =>
    goal.target === undefined ? goal : { ...goal, target: goal.target / factor };
  return {
    ...intentions,
    constraints: intentions.constraints.map(scaled),
    goals: intentions.goals.map(aimed),
  };
}

interface MeanAndLeast {
  readonly mean: number;
  readonly least: number;
}

interface Readings {
  readonly illuminance: Float32Array;
  readonly direct?: Float32Array;
  readonly surfaces: readonly {
    readonly mean: number;
    readonly sigma: number;
    readonly min: number;
    readonly max: number;
  }[];
  readonly goals: readonly { readonly value: number }[];
  readonly constraints: readonly { readonly value: number }[];
  readonly grids: readonly { readonly mean: number; readonly min: number; readonly max: number }[];
  readonly observers: readonly { readonly cylindrical: number }[];
  readonly planes: readonly {
    readonly horizontal: MeanAndLeast;
    readonly cylindrical: MeanAndLeast;
    readonly verticals: readonly MeanAndLeast[];
  }[];
}

/**
 * The readings of a new installation as they will be; `intentions`: what was asked, for what ages and what does not. Glare
 * stays that of the new installation.
 */
export function maintained<Shown extends Readings>(
  shown: Shown,
  intentions: Intentions,
  factor: number,
): Shown {
  if (factor === 1) return shown;
  const results = <T extends { readonly value: number }>(
    list: readonly T[],
    asked: readonly (Constraint | Goal)[],
  ): T[] =>
    list.map((result, i) => {
      const what = asked[i];
      const isShare = what !== undefined && 'sense' in what && what.sense === 'near'; // a distance from its target
      return what && isOfLight(what.statistic) && !isShare
        ? { ...result, value: result.value * factor }
        : result;
    });
  const aged = <T extends MeanAndLeast>(of: T): T => ({
    ...of,
    mean: of.mean * factor,
    least: of.least * factor,
  });
  return {
    ...shown,
    illuminance: shown.illuminance.map((value) => value * factor),
    ...(shown.direct && { direct: shown.direct.map((value) => value * factor) }),
    surfaces: shown.surfaces.map((row) => ({
      ...row,
      mean: row.mean * factor,
      sigma: row.sigma * factor,
      min: row.min * factor,
      max: row.max * factor,
    })),
    grids: shown.grids.map((grid) => ({
      ...grid,
      mean: grid.mean * factor,
      min: grid.min * factor,
      max: grid.max * factor,
    })),
    observers: shown.observers.map((each) => ({ ...each, cylindrical: each.cylindrical * factor })),
    planes: shown.planes.map((plane) => ({
      ...plane,
      horizontal: aged(plane.horizontal),
      cylindrical: aged(plane.cylindrical),
      verticals: plane.verticals.map(aged),
    })),
    goals: results(shown.goals, intentions.goals),
    constraints: results(shown.constraints, intentions.constraints),
  };
}

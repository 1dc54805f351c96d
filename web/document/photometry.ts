/**
 * What a photometric file says of a luminaire, and what follows from its table; made by the core
 * (core/photometry/photometric_description.h), told in the type card.
 */

export const usualEfficacy = 120; // lm/W of a luminaire that states none, until a person says another

export interface PhotometricDescription {
  readonly name: string; // may be empty, as may be the maker
  readonly maker: string;
  readonly format: string; // "LM-63-2002", "EULUMDAT"
  readonly flux: number; // lm, as the file states it
  readonly integratedFlux: number; // lm that its table holds
  readonly disputed: boolean; // these two cannot both be right: a person has to choose
  readonly watts: number; // 0: not stated
  readonly efficacy: number | null; // lm/W
  readonly cct: number | null; // K
  readonly luminous: {
    readonly length: number; // m, along `longAxis`
    readonly width: number; // m
    readonly height: number; // m
    readonly round: boolean;
  };
  readonly longAxis: 'C0' | 'C90';
  readonly symmetry: string;
  readonly maxCandela: number; // cd
  readonly beamAngle: number; // degrees, full angle at 50 % of maxCandela
  readonly fieldAngle: number; // degrees, at 10 %
  readonly upwardShare: number; // 0..1
  readonly ugr4h8h: number | null; // null without a luminous area
  readonly warnings: readonly string[];
  /** cd at C = 0, 15, ..., 345 and gamma = 0, 1, ..., 180 degrees, plane by plane. */
  readonly candela: Float32Array;
}

/** Whether its glare can be told: it is no point. */
export const hasLuminousArea = ({
  luminous: { length, width, height },
}: Pick<PhotometricDescription, 'luminous'>): boolean =>
  Math.max(length * width, length * height, width * height) > 1e-9; // m2

export const sampledPlanes = 24;
export const sampledGammas = 181;

/** cd in one sampled plane from gamma 0 to 180; `c` is a multiple of 15 degrees. */
export function planeOf({ candela }: Pick<PhotometricDescription, 'candela'>, c: number): Float32Array {
  const plane = Math.round((c / 360) * sampledPlanes) % sampledPlanes;
  return candela.subarray(plane * sampledGammas, (plane + 1) * sampledGammas);
}

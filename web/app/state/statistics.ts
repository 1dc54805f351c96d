/**
 * Readings of a set of surfaces from the light of the patches: the histogram (paper, figure 4) and true shares of
 * the area. Everything is weighted by area; mu and sigma are population statistics.
 */
import type { SurfaceResult } from '../../solver/protocol.ts';
import { countedRows } from '../../document/counted-rows.ts';
import { joined } from '../../document/joined.ts';
import type { Quantity, SceneInfo } from '../../document/types.ts';

export interface AreaSample {
  readonly values: Float32Array; // in the quantity asked for
  readonly areas: Float32Array; // m2, in the same order
  readonly area: number;
  readonly mean: number;
  readonly sigma: number;
  readonly min: number;
  readonly max: number;
}

/** The patches of some leaves, without those that something covers. */
export function patchesOf(scene: SceneInfo, leaves: readonly number[]): Uint32Array {
  const parts = leaves.map((leaf) => scene.surfaces[leaf]?.part?.rows ?? countedRows(scene, leaf));
  return joined(parts, Uint32Array);
}

/** The light on some patches; null where there are none. */
export function sampleOf(
  scene: SceneInfo,
  illuminance: Float32Array,
  patches: Uint32Array,
  quantity: Quantity,
): AreaSample | null {
  if (patches.length === 0) return null;
  const values = new Float32Array(patches.length);
  const areas = new Float32Array(patches.length);
  let [area, sum, squares, min, max] = [0, 0, 0, Infinity, 0];
  patches.forEach((patch, index) => {
    const value =
      (illuminance[patch] ?? 0) * (quantity === 'exitance' ? (scene.patchReflectance[patch] ?? 0) : 1);
    const patchArea = scene.patchArea[patch] ?? 0;
    values[index] = value;
    areas[index] = patchArea;
    area += patchArea;
    sum += value * patchArea;
    squares += value * value * patchArea;
    if (value < min) min = value;
    if (value > max) max = value;
  });
  const mean = sum / area;
  return {
    values,
    areas,
    area,
    mean,
    sigma: Math.sqrt(Math.max(0, squares / area - mean * mean)),
    min,
    max,
  };
}

/** The readings of several surfaces together; sigma by the law of total variance. */
export function unionOf(
  rows: readonly SurfaceResult[],
): Pick<SurfaceResult, 'mean' | 'sigma' | 'min' | 'max'> {
  const area = rows.reduce((sum, row) => sum + row.area, 0);
  const averaged = (of: (row: SurfaceResult) => number) =>
    rows.reduce((sum, row) => sum + row.area * of(row), 0) / area;
  const mean = averaged((row) => row.mean);
  return {
    mean,
    sigma: Math.sqrt(averaged(({ mean: own, sigma }) => sigma ** 2 + (own - mean) ** 2)),
    min: Math.min(...rows.map((row) => row.min)),
    max: Math.max(...rows.map((row) => row.max)),
  };
}

/** Share of the area (0..1) whose light is below `bound`. */
export function shareBelow({ values, areas, area }: AreaSample, bound: number): number {
  let below = 0;
  values.forEach((value, index) => (below += value < bound ? (areas[index] ?? 0) : 0));
  return below / area;
}

/** Share of the area in each of `bins` equal intervals of [0, high]; what is brighter counts in the last. */
export function histogram(sample: AreaSample, high: number, bins: number): number[] {
  const shares = Array.from({ length: bins }, () => 0);
  sample.values.forEach((value, index) => {
    const bin = Math.min(bins - 1, Math.max(0, Math.floor((value / high) * bins)));
    shares[bin] = (shares[bin] ?? 0) + (sample.areas[index] ?? 0) / sample.area;
  });
  return shares;
}

const outliers = 0.005; // of the area
const fineBins = 400;

/** What an axis has to hold: the most light there is, or what all but a two-hundredth of the area keeps well below it. */
export function mostShown(sample: AreaSample): number {
  const shares = histogram(sample, sample.max, fineBins);
  let above = 0;
  let bin = fineBins;
  while (bin > 0 && above + shares[bin - 1]! <= outliers) above += shares[--bin]!;
  const usual = (bin / fineBins) * sample.max;
  return sample.max < 1.5 * usual ? sample.max : usual;
}

/** What the inequalities promise of the share below mu - alpha sigma: two-sided Chebyshev, one-sided Cantelli. */
export function promises(alpha: number): { chebyshev: number; cantelli: number } {
  if (!(alpha > 0)) return { chebyshev: 1, cantelli: 1 };
  return { chebyshev: Math.min(1, 1 / alpha ** 2), cantelli: 1 / (1 + alpha ** 2) };
}

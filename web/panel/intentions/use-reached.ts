/** What a set of surfaces reaches now: one row of the solver where it is one leaf (or all), else read off the patches. */
import { useMemo } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { patchesOf, sampleOf, type AreaSample } from '../../app/state/statistics.ts';
import { leavesOf } from '../../document/surface-names.ts';
import type { SurfaceNames } from '../../document/types.ts';

export interface Reached {
  readonly mean: number;
  readonly sigma: number;
  readonly min: number;
  readonly max: number;
}

export function useReached(names: SurfaceNames): Reached | null {
  const { store } = useApp();
  const shown = store.shown.value;
  const row = names.length === 1 ? shown?.surfaces.find((each) => each.name === names[0]) : undefined;
  const sample = useSample(row ? [] : names);
  if (row) return row;
  return sample && { mean: sample.mean, sigma: sample.sigma, min: sample.least, max: sample.most };
}

/** The light of the patches of some surfaces. */
export function useSample(names: SurfaceNames): AreaSample | null {
  const { store } = useApp();
  const scene = store.painted.value;
  const shown = store.shown.value;
  const { quantity } = store.document.value;
  const key = names.join('\n');
  const patches = useMemo(
    () => (scene && key !== '' ? patchesOf(scene, leavesOf(names, scene.surfaces)) : new Uint32Array()),
    [scene, key],
  );
  return useMemo(
    () => (scene && shown ? sampleOf(scene, shown.illuminance, patches, quantity) : null),
    [shown, patches, quantity],
  );
}

/**
 * What the surfaces of a card reach now: one row of the solver where it is one leaf (or all), else read off the patches, as
 * is the direct light of a card that speaks of it alone; at the points of the EN grid where the card is about those.
 */
import { useMemo } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { gridLightOf } from '../../app/state/grid-light.ts';
import { patchesOf, sampleOf, type AreaSample } from '../../app/state/statistics.ts';
import { leavesOf } from '../../document/surface-names.ts';
import type { SurfaceNames } from '../../document/types.ts';

export interface Reached {
  readonly mean: number;
  readonly sigma: number;
  readonly min: number;
  readonly max: number;
}

interface About {
  readonly surfaces: SurfaceNames;
  readonly direct?: boolean | undefined;
  readonly onGrid?: boolean;
}

export function useReached({ surfaces: names, direct = false, onGrid }: About): Reached | null {
  const { store } = useApp();
  const shown = store.shown.value;
  const isRead = names.length === 1 && (!direct || store.document.value.quantity === 'direct');
  const row = isRead ? shown?.surfaces.find((each) => each.name === names[0]) : undefined;
  const sample = useSample(row ? [] : names, direct);
  const grid = onGrid && !direct && row && shown ? gridLightOf(shown, row.name) : null;
  if (row) return grid ? { ...grid, sigma: row.sigma } : row;
  return sample;
}

/** The light of the patches of some surfaces. */
export function useSample(names: SurfaceNames, direct = false): AreaSample | null {
  const { store } = useApp();
  const scene = store.sceneWithAreas.value;
  const shown = store.shown.value;
  const { quantity } = store.document.value;
  const light = direct ? (shown?.direct ?? null) : (shown?.illuminance ?? null);
  const key = names.join('\n');
  const patches = useMemo(
    () => (scene && key !== '' ? patchesOf(scene, leavesOf(names, scene.surfaces)) : new Uint32Array()),
    [scene, key],
  );
  return useMemo(
    () => (scene && light ? sampleOf(scene, light, patches, direct ? 'direct' : quantity) : null),
    [light, patches, quantity, direct],
  );
}

/** Where the legend ends: at round values with round steps, and no sooner elsewhere than the light needs. */
import { expect, test } from '@jest/globals';
import { fitLegend } from '../../../../web/app/state/legend-range.ts';
import { Store } from '../../../../web/app/state/store.ts';
import type { SceneInfo } from '../../../../web/document/types.ts';
import type { Shown } from '../../../../web/solver/protocol.ts';

const lit = (mean: number) => ({ surfaces: [{ name: 'floor', mean, area: 1 }] }) as unknown as Shown;

/** The ends for some light, after others were there. */
function ends(mean: number, { steps = 0, logarithmic = false, range = [0, 0] as [number, number] }) {
  const store = new Store();
  store.display.value = { ...store.display.value, steps, logarithmic, range };
  fitLegend(store, lit(mean));
  return store.display.value.range;
}

test('steps are round, whatever the ends were without them', () => {
  for (const steps of [5, 8, 10, 12, 16]) {
    const [low, high] = ends(300, { steps, range: [0, 800] });
    const step = (high - low) / steps;
    expect([low, [50, 100, 200].includes(step)]).toEqual([0, true]);
  }
});

test('round ends that hold the light stay', () => {
  expect(ends(300, { range: [0, 1000] })).toEqual([0, 1000]);
  expect(ends(300, { range: [0, 800] })).toEqual([0, 800]);
  expect(ends(300, { range: [0, 300] })).toEqual([0, 800]);
  expect(ends(300, { logarithmic: true, range: [0, 800] })).toEqual([10, 800]);
});

test('what an intention names lies within the ends, however dark the room around it is', () => {
  const store = new Store();
  const [wall, work] = [
    { name: 'wall', mean: 10, area: 50 },
    { name: 'work', mean: 42, area: 1 },
  ];
  const shown = { surfaces: [wall, work, { name: 'all', mean: 11, area: 51 }] } as unknown as Shown;
  store.scene.value = { surfaces: [wall, work] } as unknown as SceneInfo;
  store.display.value = { ...store.display.value, range: [0, 0] };
  fitLegend(store, shown);
  expect(store.display.value.range).toEqual([0, 30]);
  store.edit('a card', (draft) => void (draft.cards = [{ surfaces: ['work'] }] as never));
  fitLegend(store, shown);
  expect(store.display.value.range).toEqual([0, 60]);
});

test('locked ends stay, whatever the light', () => {
  const store = new Store();
  const locked = { ...store.display.value, range: [5, 77] as const, rangeFollows: false };
  store.display.value = locked;
  fitLegend(store, lit(300));
  expect(store.display.value).toBe(locked);
});

// Which sites bear a cross: what areas leave out where they are drawn, what was excluded by hand everywhere.
import { expect, test } from '@jest/globals';
import { noAreas } from '../../../../web/document/areas.ts';
import { Store } from '../../../../web/app/state/store.ts';
import { fakeScene } from '../../fake-solver.ts';
import { fakePlan } from '../../fake-viewer.ts';

test('what areas leave out is crossed in the plan alone', () => {
  const store = new Store();
  store.scene.value = fakeScene();
  store.planSource.value = () => fakePlan;
  store.edit('areas', ({ luminaires }) => {
    luminaires.excluded = [9];
    luminaires.areas = { ...structuredClone(noAreas), keepOut: [[-1, -1, 2, 2]] } as never;
  });
  expect(store.barred.value.length).toBeGreaterThan(1);
  store.tab.value = 'luminaires';
  const eye = { position: [0, 9, 0], target: [0, 0, 0] } as const;
  store.camera.value = { ...eye, plan: false };
  expect(store.crossed.value).toEqual([9]); // all round the room they said nothing
  store.camera.value = { ...eye, plan: true };
  expect(store.crossed.value).toEqual(store.barred.value);
  store.tab.value = 'results';
  expect(store.crossed.value).toEqual([9]);
  store.drawing.value = 'keepOut';
  expect(store.crossed.value).toEqual(store.barred.value);
});

/** Light that is asked for a task area: on the grid of the standard, as room types ask, where the area has points of one. */
import { expect, test } from '@jest/globals';
import { Store } from '../../../web/app/state/store.ts';
import { TaskAreas } from '../../../web/app/task-areas.ts';
import { outlineOf } from '../../../web/document/areas.ts';
import type { Shown } from '../../../web/solver/protocol.ts';
import { appInRoom } from '../app-in-room.ts';
import { fakeScene } from '../fake-solver.ts';

const gridOf = (name: string) => ({ name, points: 9, mean: 520, min: 400, max: 600, uniformity: 0.77 });

test('the cards of a task ask on its grid; what is too small for one, of patches', () => {
  const store = new Store();
  const scene = fakeScene();
  store.scene.value = scene;
  const tasks = new TaskAreas(store);
  const rows = [...scene.surfaceOfPatch.keys()].filter(
    (row) => scene.surfaces[scene.surfaceOfPatch[row]!]!.name === 'floor',
  );
  const [x, z] = [0, 2].map((axis) => rows.map((row) => scene.patchCenter[3 * row + axis]!)) as [
    number[],
    number[],
  ];
  const half = (Math.min(...x) + Math.max(...x)) / 2;
  tasks.add(outlineOf([Math.min(...x) - 1, Math.min(...z) - 1, half, Math.max(...z) + 1]), 0);
  const name = tasks.list[0]!.name;
  store.shown.value = { grids: [gridOf(name)] } as unknown as Shown;
  tasks.ask(0, 500);
  const cards = store.document.peek().cards.filter(({ surfaces }) => surfaces[0]?.startsWith(name));
  expect(cards[0]).toMatchObject({ surfaces: [name], mean: { min: 500 }, uniformity: 0.6, onGrid: true });
  expect(cards.length).toBeGreaterThan(1);
  for (const card of cards.slice(1)) expect(card.onGrid).toBeUndefined();
});

test('a room that is started afresh has no areas of the wish before, until that is undone', async () => {
  const { app, settle } = await appInRoom();
  app.tasks.add(outlineOf([-99, -99, 99, 99]), 0);
  expect(app.tasks.list).toHaveLength(1);
  const restarted = app.opening.restart();
  await settle();
  await restarted;
  expect(app.store.document.peek().taskAreas).toBeUndefined();
  app.store.undo();
  expect(app.tasks.list).toHaveLength(1);
});

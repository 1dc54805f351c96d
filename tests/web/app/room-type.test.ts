/** A room type where the room lacks what it is about: nothing changes, and the way is one press away. Covers app/room-type. */
import { expect, test } from '@jest/globals';
import { signal } from '@preact/signals';
import { lightAs } from '../../../web/app/room-type.ts';
import { roomTypes } from '../../../web/app/words/room-types.ts';
import { withTaskAreas } from '../../../web/document/task-areas.ts';
import { everyVerdict } from '../../../web/app/words/type-verdicts.ts';
import { appInRoom } from '../app-in-room.ts';

test('an escape route that is not drawn is offered to be drawn', async () => {
  const { app } = await appInRoom();
  const { store } = app;
  const before = store.document.value;
  await lightAs(
    app,
    roomTypes.find(({ numbers }) => numbers.centreLine !== undefined)!,
  );
  expect(store.document.value).toBe(before);
  const message = store.messages.value.at(-1);
  expect(message?.text).toMatch(/^Draw the escape route/);
  message?.action?.run();
  expect([store.tab.value, store.drawing.value]).toEqual(['intentions', 'task']);
});

test('a corridor is asked of the way that the list of rooms draws, and of what is around it', async () => {
  const { app } = await appInRoom();
  const { store } = app;
  const corridor = roomTypes.find(({ id }) => id === 'corridor')!;
  const scene = store.scene.peek()!;
  const floor = scene.surfaces.findIndex(({ name }) => name === 'floor');
  const rows = [...scene.surfaceOfPatch.keys()].filter((row) => scene.surfaceOfPatch[row] === floor);
  const x = rows.map((row) => scene.patchCenter[3 * row]!);
  const middle = (Math.min(...x) + Math.max(...x)) / 2;
  const outline = [[-99, -99], [middle, -99], [middle, 99], [-99, 99]] as const; // prettier-ignore
  const way = { name: 'way', surface: 'floor', outline };
  const { room } = store.document.peek();
  const catalog = { rooms: [{ room, roomType: 'corridor', taskAreas: [way] }], experiments: [] };
  Object.defineProperty(app.rooms, 'catalog', { value: signal(catalog) });
  await lightAs(app, corridor);
  expect(store.document.peek().taskAreas).toEqual([way]);
  const around = withTaskAreas(scene, [way]).surfaces.slice(scene.surfaces.length + 1);
  const asked = store.document.peek().cards.filter(({ onGrid }) => onGrid);
  expect(asked.map(({ surfaces }) => surfaces)).toEqual([['way'], ...around.map(({ name }) => [name])]);
  expect(around.length).toBeGreaterThan(0);
  const told = everyVerdict(store).map(({ where }) => where);
  for (const name of ['way', ...around.map((each) => each.name)])
    expect(told.filter((where) => where === name)).toHaveLength(2);
  expect(told).not.toContain('floor');
  store.undo();
  expect(store.document.peek().taskAreas).toBeUndefined();
});

/** What is held together goes together or stays, and then it is said: a drop that nothing follows looks like a fault. */
import { afterAll, beforeAll, expect, jest, test } from '@jest/globals';
import { appInRoom, type AppInRoom } from '../app-in-room.ts';

let room: AppInRoom;

beforeAll(async () => void (room = await appInRoom()));
afterAll(() => {
  jest.useRealTimers();
});

test('a field that finds no room where one of it is dropped stays where it was, and that is said', async () => {
  const { app, settle } = room;
  const { store } = app;
  store.edit('field', ({ luminaires }) => {
    luminaires.count = 4;
    luminaires.arrangement = { rule: 'field' };
  });
  await settle();
  const layout = store.shown.value!.layout;
  jest.spyOn(app.solving, 'layout').mockReturnValue({ ...layout, sites: [0, 1, 4, 5], ties: [0, 0, 0, 0] });
  store.messages.value = [];
  const before = store.document.value;
  app.hand.moveTo(0, 15, true); // in the last corner: three of four would hang outside
  expect(store.messages.value).toHaveLength(0);
  app.hand.moveTo(0, 15, false);
  expect(store.document.value).toBe(before);
  expect(store.messages.value.map(({ text }) => text)).toEqual(['There is no place for all of them there.']);
});

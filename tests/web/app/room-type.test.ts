/** A room type where the room lacks what it is about: nothing changes, and the way is one press away. Covers app/room-type. */
import { expect, test } from '@jest/globals';
import { lightAs } from '../../../web/app/room-type.ts';
import { roomTypes } from '../../../web/app/words/room-types.ts';
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

/** Names of rooms that were computed here: no room takes another one's. */
import { expect, test } from '@jest/globals';
import { unusedName } from '../../../../web/app/rooms/own-rooms.ts';

const kept = (room: string, source?: string) => ({
  room,
  title: room,
  bytes: 1,
  at: 0,
  ...(source && { source }),
});

test('another model of the same name is numbered, the same model is the same room', () => {
  const taken = [kept('studio.flux', 'aa'), kept('studio (2).flux', 'bb'), kept('old.flux')];
  expect(unusedName('box', 'aa', taken)).toBe('box.flux');
  expect(unusedName('studio', 'aa', taken)).toBe('studio.flux');
  expect(unusedName('studio', 'bb', taken)).toBe('studio (2).flux');
  expect(unusedName('studio', 'cc', taken)).toBe('studio (3).flux');
  expect(unusedName('old', 'aa', taken)).toBe('old (2).flux');
});

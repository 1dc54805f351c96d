/** The list of rooms as the page gets it: early, in vain, again, and until every room is ready. */
import { afterEach, beforeEach, describe, expect, jest, test } from '@jest/globals';
import { catalogFile } from '../../../../rooms/catalog-file.mjs';
import { expectCatalog } from '../../../../web/app/rooms/catalog-request.ts';
import { progressText, Rooms } from '../../../../web/app/rooms/rooms.ts';
import { fakeHost } from '../../fake-host.ts';
import { sampleCatalog } from '../../sample-rooms.ts';

beforeEach(() => void jest.useFakeTimers());
afterEach(() => void jest.useRealTimers());

const computing = (progress: number) => ({ office: { state: 'computing', progress } }) as const;

test('what the first script asked for is used once', async () => {
  const host = fakeHost();
  expectCatalog();
  const rooms = new Rooms();
  expect(await rooms.load()).toBe(true);
  expect(await rooms.load()).toBe(true);
  expect(host.asked).toEqual(['catalog.json']);
  expect(rooms.first()?.id).toBe('office');
  expect(rooms.entryOf('5.1-even')?.room).toBe('e-corridor');
  expect([rooms.has('box'), rooms.has('5.1-even'), rooms.has('attic')]).toEqual([true, false, false]);
  expect([rooms.titleOf('box'), rooms.titleOf('mine.flux')]).toEqual(['Box', 'mine.flux']);
});

describe('a list that cannot be had', () => {
  test.each([
    ['a missing one', null, /catalog\.json is not on this server/],
    ['one that is no JSON', '{ "rooms": [', /catalog\.json is not JSON/],
    ['one with a fault', { rooms: [{ id: 'a', title: 'A' }] }, /cannot be read: rooms\.0\.file/],
    ['no connection', 'offline', /no connection/],
  ])('%s is one sentence, and another try may do', async (_, catalog, fault) => {
    const host = fakeHost();
    host.catalog = catalog;
    const rooms = new Rooms();
    expect(await rooms.load()).toBe(false);
    expect(rooms.fault.value).toMatch(fault);
    expect(rooms.fault.value).toMatch(/^The list of rooms .*\.$/);
    host.catalog = catalogFile();
    expect(await rooms.load()).toBe(true);
    expect(rooms.fault.value).toBeNull();
  });
});

test('while the server computes a room the list is asked for again, until all are ready', async () => {
  const host = fakeHost(computing(0.404));
  const rooms = new Rooms();
  await rooms.load();
  expect(progressText(rooms.entryOf('office')!)).toBe('being computed, 40 %');
  expect(rooms.first()?.id).toBe(sampleCatalog().rooms[1]?.id); // the first one that can be opened

  host.catalog = 'offline'; // for a moment: what is known stays
  await jest.advanceTimersByTimeAsync(4000);
  expect(rooms.entryOf('office')?.progress).toBe(0.404);
  expect(rooms.fault.value).toBeNull();

  host.catalog = catalogFile();
  await jest.advanceTimersByTimeAsync(4000);
  expect(progressText(rooms.entryOf('office')!)).toBeNull();
  expect(rooms.first()?.id).toBe('office');
  const asked = host.asked.length;
  await jest.advanceTimersByTimeAsync(60_000);
  expect(host.asked).toHaveLength(asked);
});

test('a room that could not be computed says so, and is not waited for', async () => {
  const host = fakeHost({ 'e-corridor': { state: 'failed' } });
  const rooms = new Rooms();
  await rooms.load();
  expect(progressText(rooms.entryOf('e-corridor')!)).toBe('it could not be computed');
  expect(progressText(rooms.entryOf('5.1-even')!)).toBe('it could not be computed'); // it is in that room
  expect(progressText(rooms.entryOf('office')!)).toBeNull();
  const asked = host.asked.length;
  await jest.advanceTimersByTimeAsync(60_000);
  expect(host.asked).toHaveLength(asked);
});

// The scene that is asked for before the app has arrived.
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import {
  fetchEarly,
  firstRoom,
  likelyRoom,
  rememberRoom,
  requestScene,
} from '../../../web/app/first-scene.ts';

let asked: { room: string; signal: AbortSignal | null | undefined }[] = [];
const before = {
  fetch: globalThis.fetch,
  document: globalThis.document,
  localStorage: globalThis.localStorage,
};
const put = (name: string, value: unknown) =>
  Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });

beforeEach(() => {
  asked = [];
  const kept = new Map<string, string>();
  put('document', { baseURI: 'https://example.test/sub/' });
  put('localStorage', {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => kept.set(key, value),
  });
  put('fetch', (address: URL, init?: RequestInit) => {
    asked.push({ room: address.pathname, signal: init?.signal });
    return Promise.resolve(new Response(address.pathname));
  });
});
afterEach(() => Object.entries(before).forEach(([name, value]) => put(name, value)));

test('is the one of the last work, else the first one, and none for a link', () => {
  expect(likelyRoom('')).toBe(firstRoom);
  rememberRoom('gallery');
  expect(likelyRoom('#')).toBe('gallery');
  expect(likelyRoom('#f1.abc')).toBeNull();
  rememberRoom('../../etc');
  expect(likelyRoom('')).toBe(firstRoom);
});

test('is used once', async () => {
  fetchEarly('');
  expect(asked.map(({ room }) => room)).toEqual([`/sub/scenes/${firstRoom}.flux`]);
  expect(await (await requestScene(firstRoom))?.text()).toContain(firstRoom);
  expect(asked).toHaveLength(1);
  await requestScene(firstRoom);
  expect(asked).toHaveLength(2);
});

test('is given up where another room is opened', async () => {
  fetchEarly('');
  expect(await (await requestScene('box'))?.text()).toContain('box');
  expect(asked[0]?.signal?.aborted).toBe(true);
});

test('is expected to be the first room where the browser keeps nothing', () => {
  put('localStorage', undefined);
  expect(() => rememberRoom('box')).not.toThrow();
  expect(likelyRoom('')).toBe(firstRoom);
});

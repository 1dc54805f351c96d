// The scene that is asked for before the app has arrived.
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import {
  expectScene,
  firstRoom,
  likelyRoom,
  rememberRoom,
  requestScene,
} from '../../../../web/app/opening/first-scene.ts';

let asked: string[] = [];
let abandoned = 0;
const before = {
  fetch: globalThis.fetch,
  document: globalThis.document,
  localStorage: globalThis.localStorage,
};
const put = (name: string, value: unknown) =>
  Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
const text = (bytes: ArrayBuffer) => new TextDecoder().decode(bytes);
const early = (bytes: Promise<ArrayBuffer>) => ({ bytes, abandon: () => void abandoned++ });

beforeEach(() => {
  asked = [];
  abandoned = 0;
  const kept = new Map<string, string>();
  put('document', { baseURI: 'https://example.test/sub/' });
  put('localStorage', {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => kept.set(key, value),
  });
  put('fetch', (address: string) => {
    const { pathname } = new URL(address);
    asked.push(pathname);
    return Promise.resolve(
      pathname.includes('attic')
        ? new Response('<html>', { headers: { 'content-type': 'text/html' } })
        : new Response(pathname),
    );
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
  const bytes = new ArrayBuffer(4);
  expectScene(firstRoom, early(Promise.resolve(bytes)));
  expect(await requestScene(firstRoom)).toBe(bytes);
  expect(asked).toEqual([]);
  expect(text(await requestScene(firstRoom))).toContain(firstRoom);
  expect(asked).toEqual([`/sub/scenes/${firstRoom}.flux`]);
  expect(abandoned).toBe(0);
});

test('is asked for again where it did not come', async () => {
  expectScene(firstRoom, early(Promise.reject(new Error('no connection'))));
  expect(text(await requestScene(firstRoom))).toContain(firstRoom);
});

test('is given up where another room is opened', async () => {
  expectScene(firstRoom, early(new Promise(() => {})));
  expect(text(await requestScene('box'))).toContain('box');
  expect(abandoned).toBe(1);
});

test('that a host does not have is told with the cure', async () => {
  await expect(requestScene('attic')).rejects.toThrow(/"attic" is not on this server.*npm run build/);
});

test('is expected to be the first room where the browser keeps nothing', () => {
  put('localStorage', undefined);
  expect(() => rememberRoom('box')).not.toThrow();
  expect(likelyRoom('')).toBe(firstRoom);
});

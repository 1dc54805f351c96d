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
const early = (begun: Promise<void>, bytes: Promise<ArrayBuffer>) => ({
  begun,
  bytes,
  abandon: () => void abandoned++,
});
const never = new Promise<never>(() => {});
const textOf = async (room: string) => text(await (await requestScene(room)).bytes);

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

test('is the one that the address names; an embedded page knows nothing of the last work', () => {
  rememberRoom('gallery');
  try {
    put('location', { search: '?room=box' });
    expect(likelyRoom('')).toBe('box');
    put('location', { search: '?room=../../etc' });
    expect(likelyRoom('')).toBe(firstRoom);
    put('location', { search: '?embed' });
    expect(likelyRoom('')).toBe(firstRoom);
    rememberRoom('box');
  } finally {
    put('location', undefined);
  }
  expect(likelyRoom('')).toBe('gallery');
});

test('is used once', async () => {
  // Whoever asks gets it as soon as it begins to arrive.
  expectScene(firstRoom, early(Promise.resolve(), never));
  expect((await requestScene(firstRoom)).bytes).toBe(never);
  expect(asked).toEqual([]);
  expect(await textOf(firstRoom)).toContain(firstRoom);
  expect(asked).toEqual([`/sub/scenes/${firstRoom}.flux`]);
  expect(abandoned).toBe(0);
});

test('is asked for again where it did not come', async () => {
  expectScene(firstRoom, early(Promise.reject(new Error('no connection')), never));
  expect(await textOf(firstRoom)).toContain(firstRoom);
});

test('is given up where another room is opened', async () => {
  expectScene(firstRoom, early(never, never));
  expect(await textOf('box')).toContain('box');
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

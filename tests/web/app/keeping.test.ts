/** What the browser keeps and when: rooms of the site, once it is quiet, never what a link shows; a refusal is told once. */
import { afterEach, beforeEach, expect, jest, test } from '@jest/globals';
import { signal } from '@preact/signals';
import { Keeping } from '../../../web/app/keeping.ts';
import type { LuminaireTypes } from '../../../web/app/luminaires/luminaire-types.ts';
import type { Solving } from '../../../web/app/solving.ts';
import { Store } from '../../../web/app/state/store.ts';
import { takeFromReload } from '../../../web/document/reload.ts';
import type { Viewer } from '../../../web/viewer/types.ts';
import { fakeScene, fakeShown } from '../fake-solver.ts';
import { sampleDocument } from '../sample-rooms.ts';

const layout = { sites: [1, 2], flux: [5, 5], dimming: 1 };
const page = new EventTarget();
let kept: Map<string, string>;
const types = { files: signal({}) } as unknown as LuminaireTypes;
let store: Store;
let keeping: Keeping;
let stop: () => void;
const put = (name: string, value: unknown) =>
  Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });

beforeEach(() => {
  jest.useFakeTimers({ doNotFake: ['setImmediate'] });
  kept = new Map();
  put('sessionStorage', {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => kept.set(key, value),
    removeItem: (key: string) => kept.delete(key),
  });
  put('location', { hash: '', href: 'https://example.test/' });
  put('indexedDB', undefined); // as in a browser that stores nothing
  put('addEventListener', page.addEventListener.bind(page));
  put('removeEventListener', page.removeEventListener.bind(page));
  store = new Store();
  keeping = new Keeping(store, { layout: () => layout } as unknown as Solving, {} as Viewer, types);
  stop = keeping.keepSaved((room) => room === 'office');
  show('office');
});

afterEach(() => {
  stop();
  jest.useRealTimers();
});

/** A room with its light, settled. */
function show(room: string): void {
  const scene = fakeScene();
  const document = sampleDocument(scene.identity, room);
  store.scene.value = scene;
  store.reset(document);
  const intentions = { ...store.traced.value.intentions, constraints: [] };
  store.scene.value = scene;
  store.shown.value = fakeShown(scene, layout, intentions);
  store.progress.value = { state: 'settled', evaluations: 1, milliseconds: 1 };
}

/** Longer than the pause after a change; what storing needs comes by promises. */
async function quiet(): Promise<void> {
  jest.advanceTimersByTime(5000);
  for (let i = 0; i < 50 && store.saving.value.state === 'unsaved'; i++)
    await new Promise((resolve) => setImmediate(resolve));
}

test('a browser that refuses is told of once, and tried again after each change', async () => {
  await quiet();
  expect(store.saving.value.state).toBe('refused');
  store.saving.value = { state: 'unsaved' };
  store.edit('flux', (draft) => void (draft.luminaires.flux = 1234));
  await quiet();
  expect(store.saving.value.state).toBe('refused');
  expect(store.messages.value.map(({ text }) => text)).toEqual([expect.stringMatching(/refuses to store/)]);
});

test.each([
  ['a room of one’s own', () => show('mine.flux')],
  ['what a link shows', () => void (location.hash = '#f1.x')],
  ['an embedded view', () => void (location.search = '?embed')],
  ['a search that runs', () => void (store.progress.value = { ...store.progress.value, state: 'improving' })],
])('%s is not stored', async (_, change) => {
  change();
  await quiet();
  expect(store.saving.value.state).toBe('unsaved');
});

test('a page that is left keeps its work for a reload, with the layout only where it answers', () => {
  page.dispatchEvent(new Event('pagehide'));
  expect(takeFromReload()?.project.document.layout).toEqual(layout);
  store.progress.value = { ...store.progress.value, state: 'improving' };
  page.dispatchEvent(new Event('pagehide'));
  expect(takeFromReload()?.project.document.layout).toBeNull();
  show('mine.flux');
  page.dispatchEvent(new Event('pagehide'));
  expect(takeFromReload()).toBeNull();
});

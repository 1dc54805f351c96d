/** Luminaire types from files, projects and links. Covers generic-luminaires. */
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { strToU8, zipSync } from 'fflate';
import { LuminaireTypes } from '../../../../web/app/luminaires/luminaire-types.ts';
import type { Solving } from '../../../../web/app/solving.ts';
import { Store } from '../../../../web/app/state/store.ts';
import { bytesOfText } from '../../../../web/document/photometric-files.ts';
import type { PhotometricDescription } from '../../../../web/document/photometry.ts';
import { described } from '../../described.ts';
import { luminaireType, photometricText } from '../../document/luminaire-type.ts';
import { fakeScene } from '../../fake-solver.ts';
import { sampleDocument } from '../../sample-rooms.ts';

let store: Store;
let types: LuminaireTypes;
let again: number; // times that the document was answered once more
let says: PhotometricDescription | Error;
const text = photometricText();
const bytes = bytesOfText(text);
const realFetch = globalThis.fetch;
const last = () => store.messages.value.at(-1);

beforeEach(() => {
  says = described(100, { name: 'Spot', maker: 'Maker', integratedFlux: 1234.5678, watts: 12 });
  const solving = {
    bring: () => undefined,
    answerAgain: () => void again++,
    describe: () => (says instanceof Error ? Promise.reject(says) : Promise.resolve(says)),
  } as unknown as Solving;
  again = 0;
  store = new Store();
  store.scene.value = fakeScene();
  store.reset(sampleDocument('0'.repeat(16), 'box'));
  types = new LuminaireTypes(store, solving);
  Object.defineProperty(globalThis, 'document', { value: { baseURI: 'http://host/' }, configurable: true });
});
afterEach(() => void (globalThis.fetch = realFetch));

test('types that a room opens with are had from the site, and are as it says', async () => {
  globalThis.fetch = async () => new Response(bytes);
  const asked = { photometry: 'spot-12.ies', count: [2, 2], turns: [0], aims: ['picture 1'] } as const;
  const [plain, brighter] = await types.fromSite([asked, { ...asked, name: 'Pendant', flux: 270, watts: 3 }]);
  expect(plain).toMatchObject({ id: 't1', name: 'Spot', file: 'spot-12.ies', flux: 1234.57, count: [2, 2] });
  expect(plain).not.toHaveProperty('isOverridden');
  expect(brighter).toMatchObject({ id: 't2', name: 'Pendant', flux: 270, watts: 3, isOverridden: true });
  expect(types.files.value).toEqual({ [plain!.hash]: text });
  expect(types.all).toEqual([]); // until the room is there
  globalThis.fetch = async () => new Response('', { status: 404 });
  await expect(types.fromSite([asked])).rejects.toThrow('not on this server');
});

describe('a photometric file that is opened', () => {
  test('becomes a type with what it says, as a step that can be undone', async () => {
    await types.open('spot.ies', bytes);
    const [type] = types.all;
    expect(type).toMatchObject({
      id: 't1',
      name: 'Spot',
      maker: 'Maker',
      flux: 1234.57,
      watts: 12,
      turns: [0],
    });
    expect(types.files.value).toEqual({ [type!.hash]: text });
    expect(types.descriptions.value[type!.hash]).toBe(says);
    expect(types.opened.value).toBe('t1');
    expect(store.tab.value).toBe('luminaires');
    expect(store.undo()).toBe('Add Spot');
    expect(types.all).toEqual([]);
  });

  test('is there once, however often it comes; another is another type', async () => {
    await types.open('spot.ies', bytes);
    await types.open('again.ies', bytes);
    await types.open('other.ies', bytesOfText(photometricText(3)));
    expect(types.all.map(({ id, file }) => [id, file])).toEqual([
      ['t1', 'spot.ies'],
      ['t2', 'other.ies'],
    ]);
  });

  test('without a name has that of the file', async () => {
    says = described(1, { name: '' });
    await types.open('lamp-12.ldt', bytes);
    expect(types.all[0]?.name).toBe('lamp-12');
  });

  test('that cannot be read changes nothing and is told in one sentence', async () => {
    says = new Error('line 7: only 3 of 19 angles');
    await types.open('bad\u202E.ies', bytes);
    expect(types.all).toEqual([]);
    expect(last()).toMatchObject({ kind: 'error', text: '“bad.ies”: line 7: only 3 of 19 angles.' });
  });

  test('before there is a room asks for one', async () => {
    store.scene.value = null;
    await types.open('spot.ies', bytes);
    expect(last()?.text).toMatch(/^Open a room first/);
  });

  test('of several in a container is chosen by the person', async () => {
    const zip = zipSync({ 'product.xml': strToU8(''), 'a.ldt': bytes, 'b.ldt': strToU8('b') });
    await types.open('lamp.gldf', new Uint8Array(zip));
    expect(types.all).toEqual([]);
    expect(store.dialog.value).toBe('luminaires');
    await types.take(types.offer.value!.parts[1]!);
    expect(types.all.map(({ file }) => file)).toEqual(['b.ldt']);
  });
});

describe('types of a project or link', () => {
  const type = luminaireType('t1', text);
  const show = () => {
    const asked = sampleDocument('0'.repeat(16), 'box');
    store.reset({ ...asked, luminaires: { ...asked.luminaires, types: [type] } });
  };

  test('are described when their files are there', async () => {
    types.provide({ [type.hash]: text });
    show();
    await Promise.resolve();
    expect(types.descriptions.value[type.hash]).toBe(says);
    await types.findMissing();
    expect(last()).toBeUndefined();
  });

  test('are found among the generic ones of the site', async () => {
    const list = [{ title: 'Spot', description: 'A spot.', file: type.file }];
    globalThis.fetch = async (address) =>
      String(address).endsWith('catalog.json') ? Response.json(list) : new Response(bytes);
    show();
    await types.findMissing();
    expect(types.files.value[type.hash]).toBe(text);
    expect(again).toBe(1);
    expect(last()).toBeUndefined();
    expect(await types.notOnSite([type.file])).toEqual([]);
    globalThis.fetch = async (address) =>
      String(address).endsWith('catalog.json') ? Response.json(list) : new Response('another spot');
    expect(await types.notOnSite([type.file])).toEqual([type.file]);
    globalThis.fetch = async () => Promise.reject(new Error('no connection'));
    expect(await types.notOnSite([type.file])).toEqual([type.file]);
  });

  test.each([
    [
      'of the same name and other bytes',
      async () => Response.json([{ title: 'x', description: 'x', file: type.file }]),
    ],
    ['of no site', async () => Promise.reject(new Error('no connection'))],
  ])('are asked for, once: a file %s', async (_, answer) => {
    globalThis.fetch = answer;
    show();
    await types.findMissing();
    expect(last()).toMatchObject({ kind: 'warning', text: expect.stringContaining('“spot-t1.ies”') });
    store.messages.value = [];
    await types.findMissing();
    expect(last()).toBeUndefined();
    await types.open('whatever.ies', bytes);
    expect(types.all).toHaveLength(1);
    expect(again).toBe(1);
    expect(types.files.value[type.hash]).toBe(text);
  });
});

test('a change of a type and its removal are steps', async () => {
  await types.open('spot.ies', bytes);
  types.change('t1', 'Aims', (type) => ({ ...type, aims: ['wall'], isAllowed: false }));
  expect(types.all[0]).toMatchObject({ aims: ['wall'], isAllowed: false });
  types.remove('t1');
  expect(store.document.value.luminaires).not.toHaveProperty('types');
  expect([store.undo(), store.undo(), store.undo()]).toEqual(['Remove a luminaire type', 'Aims', 'Add Spot']);
});

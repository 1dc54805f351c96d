/** What the work is saved as: every format of the table, under the room's name, and what is said where it fails. Covers formats. */
import { beforeEach, expect, test } from '@jest/globals';
import { signal } from '@preact/signals';
import type { App } from '../../../../web/app/app.ts';
import { exportFormats, wordsOf } from '../../../../web/app/exports/formats.ts';
import { language } from '../../../../web/language/language.ts';
import { fileStem, saveAs } from '../../../../web/app/exports/save-as.ts';
import { tagsText } from '../../../../web/app/exports/stf-project.ts';
import { Store } from '../../../../web/app/state/store.ts';
import { readProject } from '../../../../web/document/project-file.ts';
import { intentionsOf } from '../../../../web/document/intentions.ts';
import { fakeScene, fakeShown } from '../../fake-solver.ts';
import { fakePlan } from '../../fake-viewer.ts';
import { sampleDocument } from '../../sample-rooms.ts';

const layout = { sites: [0, 5], flux: [1200, 600], dimming: 0.5 };
let saved: { name: string; blob: Blob }[];
let app: App;

beforeEach(() => {
  saved = [];
  const blobs: Blob[] = [];
  URL.createObjectURL = (blob) => `blob:${blobs.push(blob as Blob) - 1}`;
  URL.revokeObjectURL = () => undefined;
  const anchor = () => ({
    href: '',
    download: '',
    click() {
      saved.push({ name: this.download, blob: blobs[Number(this.href.slice('blob:'.length))]! });
    },
  });
  Object.defineProperty(globalThis, 'document', { value: { createElement: anchor }, configurable: true });
  const store = new Store();
  store.roomTitle.value = 'Büro 2 (Süd)';
  store.scene.value = fakeScene();
  store.reset({ ...sampleDocument('0', 'office'), layout });
  store.shown.value = fakeShown(fakeScene(), layout, intentionsOf(store.document.peek()).intentions);
  const project = () => ({ document: store.document.peek(), camera: null, display: null });
  const keeping = { layout: () => store.document.peek().layout, project };
  const viewer = {
    png: async () => new Blob(['picture'], { type: 'image/png' }),
    frame: () => fakePlan.frame,
    plan: () => fakePlan,
  };
  const types = { all: [], bodies: signal([]), descriptions: signal({}), files: signal({}) };
  app = { store, keeping, viewer, types } as unknown as App;
});

test('each format is a file of its kind', async () => {
  for (const format of exportFormats) await saveAs(format, app);
  expect(saved.map(({ name, blob }) => [name, blob.type])).toEqual(
    exportFormats.map(({ suffix, type }) => [`b-ro-2-s-d${suffix}`, type]),
  );
  const textOf = (id: string) => saved[exportFormats.findIndex((format) => format.id === id)]!.blob.text();
  expect(readProject(await textOf('save'))).toMatchObject({ document: { room: 'office', layout } });
  expect(await textOf('csv')).toContain('L2,1.500,2.500,3.000,300.0');
  expect(JSON.parse(await textOf('gltf')).nodes).toHaveLength(2);
});

const stf = () => exportFormats.find(({ id }) => id === 'stf')!;

test('STF of luminaires that point straight down says nothing more', async () => {
  await saveAs(stf(), app);
  expect(await saved[0]!.blob.text()).not.toContain('Description=');
  expect(app.store.messages.value).toEqual([]);
});

test('what STF cannot say of aimed luminaires is said in the file and on the page', async () => {
  const aimed = (aim: readonly [number, number, number] | null) => ({ type: 'a', turn: 0, aim });
  const document = app.store.document.peek();
  // Site 5 hangs at (1, 3, 1) of the room: aimed east and down, right below, and along its mount.
  const mountings = [aimed([4, 0, 1]), aimed([1, 0, 1]), aimed(null)];
  app.store.reset({ ...document, layout: { sites: [5, 5, 5], flux: [1, 1, 1], dimming: 1, mountings } });
  await saveAs(stf(), app);
  expect((await saved[0]!.blob.text()).split('\r\n')).toContain(
    'Description=Rot does not say where these luminaires point (tilt in degrees from straight down, azimuth in ' +
      'degrees from +y clockwise): Lum1 aimed at 4.500 2.500 0.000, tilt 45.0 azimuth 90.0',
  );
  expect(app.store.messages.value).toMatchObject([
    { kind: 'warning', text: expect.stringMatching(/straight down: L1\./) },
  ]);
});

test('tags that follow one another are a range', () => {
  expect(tagsText([0, 1, 2, 6])).toBe('L1–L3, L7');
  expect(tagsText([3])).toBe('L4');
});

test('one that cannot be made is told by its name, and nothing is saved', async () => {
  app.store.scene.value = null;
  const ofTheLayout = exportFormats.filter(({ id }) => id !== 'save' && id !== 'png');
  for (const format of ofTheLayout) {
    await saveAs(format, app);
    const text = `The ${wordsOf(format).noun} could not be made: no layout is shown yet`;
    expect(app.store.messages.value.at(-1)?.text).toBe(text);
  }
  expect(saved).toEqual([]);
});

test('a format is told in the language of the page', () => {
  const save = exportFormats[0]!;
  expect(wordsOf(save).noun).toBe('project file');
  language.value = 'de';
  expect(wordsOf(save).noun).toBe('Die Projektdatei');
  language.value = 'en';
});

test('a title without a letter still gives a name', () => {
  expect(['Open office', '  ', '部屋'].map(fileStem)).toEqual(['open-office', 'room', 'room']);
});

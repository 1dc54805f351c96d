/** What the work is saved as: every format of the table, under the room's name, and what is said where it fails. Covers formats. */
import { beforeEach, expect, test } from '@jest/globals';
import { signal } from '@preact/signals';
import type { App } from '../../../../web/app/app.ts';
import { exportFormats, wordsOf } from '../../../../web/app/exports/formats.ts';
import { language } from '../../../../web/language/language.ts';
import { fileStem, saveAs } from '../../../../web/app/exports/save-as.ts';
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

/** A made room is opened as it was typed, or not at all. */
import { afterEach, expect, test } from '@jest/globals';
import type { App } from '../../../web/app/app.ts';
import { Making } from '../../../web/app/making.ts';

const opened: string[] = [];
const app = {
  opening: {
    showMaking: async () => undefined,
    files: async (files: readonly File[]) => void opened.push(...files.map(({ name }) => name)),
  },
} as unknown as App;

const making = new Making(app, null);
afterEach(() => {
  making.dispose();
  opened.length = 0;
});

test('a room whose typed size is not understood is neither opened nor saved, and says so', async () => {
  making.sizeFault.value = 'unread';
  await making.light();
  expect([await making.file(), opened, making.refusals.value]).toEqual([null, [], 2]);
  making.sizeFault.value = null;
  await making.light();
  expect([(await making.file())?.name, opened]).toEqual(['6 x 4 x 2.8 m.glb', ['6 × 4 × 2.8 m.glb']]);
});

test('a room is opened under its name as it was typed; a file is called what any system takes', async () => {
  making.edit((plan) => ({ ...plan, name: 'Meier & Söhne <3> / A' }));
  await making.light();
  expect(opened).toEqual(['Meier & Söhne <3> / A.glb']);
  expect((await making.file())?.name).toBe('Meier Söhne 3 A.glb');
});

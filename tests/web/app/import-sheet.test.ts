// The sheet on which a model is understood: looked at anew after each change, lit as it was chosen.
import { afterEach, expect, jest, test } from '@jest/globals';
import { facings, uses, type BuildOptions, type Survey } from '../../../web/builder/builder.ts';
import type { BuilderPool } from '../../../web/builder/pool.ts';
import type { Model } from '../../../web/builder/protocol.ts';
import { writeGlb } from '../../../web/document/gltf-container.ts';
import { usualChoices, type ModelChoices } from '../../../web/app/importing/model-choices.ts';
import { ImportSheet } from '../../../web/app/lighting/import-sheet.ts';
import type { Lighting } from '../../../web/app/lighting/lighting.ts';
import { Store } from '../../../web/app/state/store.ts';

jest.useFakeTimers();
afterEach(() => jest.clearAllTimers());

const survey: Survey = {
  size: [4, 3, 5],
  scale: 0.01,
  patch: 0.1,
  rows: 9400,
  sites: 20,
  up: 'y',
  work: 3,
  lost: 0,
  surfaces: [{ name: 'ceiling', area: 20, high: 3, facing: facings.down, use: uses.mount }],
  warnings: [],
};
const model: Model = { name: 'box.glb', bytes: writeGlb({ materials: [{}] }, null), siblings: new Map() };

function opened(answer: () => Promise<Survey>) {
  const store = new Store();
  const asked: BuildOptions[] = [];
  const lit: ModelChoices[] = [];
  const pool = { survey: (_: Model, options: BuildOptions) => (asked.push(options), answer()) };
  const lighting = { light: async (_: Model, choices: ModelChoices) => void lit.push(choices) };
  const createPool = async () => pool as unknown as BuilderPool;
  const sheet = new ImportSheet(store, lighting as unknown as Lighting, createPool, {
    model,
    choices: usualChoices,
    remarks: ['it is dark'],
    isAtRemarks: false,
  });
  return { store, asked, lit, sheet };
}

const settled = () => jest.advanceTimersByTimeAsync(1000);

test('what was proposed is shown, and counts as chosen once something is added', async () => {
  const { store, asked, lit, sheet } = opened(async () => survey);
  expect(store.sheet.value?.survey).toBeNull();
  await settled();
  expect(store.sheet.value?.survey).toBe(survey);
  sheet.hang('soffit');
  expect(store.sheet.value?.choices.mounts).toEqual(['ceiling', 'soffit']);
  sheet.hang('ceiling');
  sheet.choose({ unit: 1 });
  await settled();
  expect(asked).toHaveLength(2); // changes in one go are looked at once
  expect(asked[1]).toMatchObject({ mounts: ['soffit'], scale: 1 });
  sheet.light();
  expect(store.sheet.value).toBeNull();
  expect(lit).toEqual([{ ...usualChoices, mounts: ['soffit'], unit: 1 }]);
});

test('a plane that is proposed stays until a surface is chosen', async () => {
  const { store, sheet } = opened(async () => survey);
  await settled();
  sheet.hangInPlane(0);
  expect(store.sheet.value?.choices).toEqual(usualChoices);
  expect(store.messages.value.at(-1)?.text).toMatch(/instead of the plane/);
  sheet.hangInPlane(2.5);
  expect(store.sheet.value?.choices.ceiling).toBe(2.5);
  sheet.hangInPlane(0);
  expect(store.sheet.value?.choices).toEqual(usualChoices);
});

test('remarks on the room as it is lit hold until something else is chosen', async () => {
  const { store, sheet } = opened(async () => survey);
  await settled();
  sheet.choose({ reflectances: { wall: 0.5 } });
  expect(store.sheet.value?.remarks).toEqual(['it is dark']);
  sheet.choose({ unit: 1 });
  expect(store.sheet.value?.remarks).toBeNull();
});

test('a surface that is clicked in the picture is added, and taken away by the next click', async () => {
  const { store, sheet } = opened(async () => survey);
  await settled();
  store.scene.value = { surfaces: [{ name: 'ceiling' }, { name: 'beam' }] } as never;
  store.surface.value = 1;
  expect(store.sheet.value?.choices.mounts).toEqual(['ceiling', 'beam']);
  store.surface.value = null;
  store.surface.value = 1;
  expect(store.sheet.value?.choices.mounts).toEqual(['ceiling']);
  store.surface.value = 0; // the last one stays, and it is said why
  expect(store.sheet.value?.choices.mounts).toEqual(['ceiling']);
  expect(store.messages.value.at(-1)?.text).toMatch(
    /somewhere: add another surface before taking ceiling away/,
  );
  sheet.close();
  store.surface.value = null;
  store.surface.value = 0;
  expect(store.sheet.value).toBeNull();
});

test('a model that cannot be read so says why; a late answer to an older question is none', async () => {
  let fail = true;
  const { store, sheet } = opened(async () => {
    if (fail) throw new Error('no surfaces: it holds no triangles');
    return survey;
  });
  await settled();
  expect(store.sheet.value?.fault).toBe('No surfaces: it holds no triangles.');
  fail = false;
  sheet.choose({ up: 'y' });
  await settled();
  expect(store.sheet.value?.fault).toBeNull();
  sheet.choose({ unit: 0.001 });
  sheet.close();
  await settled();
  expect(store.sheet.value).toBeNull();
});

test('a place is where it was clicked, in a model that is taken to lie on its back, too', async () => {
  const { store, sheet } = opened(async () => ({ ...survey, scale: 0.01, up: 'z' }));
  await settled();
  store.preview.value = 'box.glb';
  sheet.standAt([100, 200, 300]);
  expect(store.sheet.value?.choices.inside).toEqual([1, 3, -2]);
  expect(store.sheet.value?.choices.up).toBe('');
});

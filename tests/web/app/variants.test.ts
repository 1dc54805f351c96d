/** The work beside a variant: what is read, what is shown, and how it ends. Covers variants, comparing-actions, differences. */
import { beforeEach, describe, expect, test } from '@jest/globals';
import { actions, isEnabled } from '../../../web/app/actions.ts';
import type { App } from '../../../web/app/app.ts';
import { changeText, differencesOf } from '../../../web/app/words/differences.ts';
import { scatteredLayout } from '../../../web/app/variants.ts';
import { appInRoom, type AppInRoom } from '../app-in-room.ts';
import { fakeScene } from '../fake-solver.ts';
import type { FakeViewer } from '../fake-viewer.ts';

let viewer: FakeViewer;
let app: App;
let settle: AppInRoom['settle'];

const action = (id: string) => actions.find((each) => each.id === id)!;

beforeEach(async () => {
  ({ app, viewer, settle } = await appInRoom());
});

const sitesShown = () => app.store.shown.value!.layout.sites;
const fewer = () => app.store.edit('two', ({ luminaires }) => void (luminaires.count = 2));

describe('a kept variant', () => {
  test('stands beside the work, judged by what is asked now, with one exposure', async () => {
    app.addCard('illuminate', ['floor']);
    await settle();
    const before = sitesShown();
    action('keep-a').run(app);
    fewer();
    await settle();
    expect(app.store.other.value?.layout.sites).toEqual(before);
    expect(viewer.other?.layout.sites).toEqual(before);
    expect(app.store.other.value?.goals).toHaveLength(app.store.shown.value!.goals.length);
    expect(app.store.display.value.exposureLevel).toBe(250);
    const differences = differencesOf(app.store, app.variants.types)!;
    const [count] = differences.cost;
    expect([count?.other.text, count?.work.text]).toEqual([String(before.length), '2']);
    expect(differences.light.map(({ where }) => where)).toEqual(['floor', 'wall', 'whole room']);
    app.variants.close();
    expect(viewer.other).toBeNull();
    expect(app.store.display.value.exposureLevel).toBeUndefined();
  });

  test('is switched with the work, and that is undone', async () => {
    const before = sitesShown();
    app.variants.keep();
    fewer();
    await settle();
    action('switch').run(app);
    await settle();
    expect([sitesShown(), app.store.other.value?.layout.sites.length]).toEqual([before, 2]);
    app.undo();
    await settle();
    expect([sitesShown().length, app.store.other.value?.layout.sites]).toEqual([2, before]);
  });

  test('that is forgotten ends the comparison', async () => {
    app.variants.keep();
    await settle();
    app.variants.forget();
    await settle();
    expect([app.variants.against.value, viewer.other]).toEqual([null, null]);
    expect(isEnabled(action('compare-kept'), app)).toBe(false);
  });
});

test('the room as it was opened is what was shown first, whatever was done since', async () => {
  const first = sitesShown();
  fewer();
  await settle();
  action('compare-opened').run(app);
  await settle();
  expect(viewer.other?.layout.sites).toEqual(first);
  action('compare-opened').run(app);
  expect(viewer.other).toBeNull();
});

test('scattered luminaires are as many, on places of their own where they may hang', () => {
  const layout = { sites: [0, 1, 2], flux: [5, 6, 7], dimming: 0.5, ties: [0, 0, 1] };
  const luminaires = { ...app.store.document.value.luminaires, excluded: [4, 5] };
  const { sites, ...rest } = scatteredLayout(layout, { luminaires, seed: 7 }, fakeScene());
  expect(rest).toEqual({ flux: [5, 6, 7], dimming: 0.5 });
  expect(new Set(sites).size).toBe(3);
  expect(sites.filter((site) => site > 15 || luminaires.excluded.includes(site))).toEqual([]);
  expect(scatteredLayout(layout, { luminaires, seed: 8 }, fakeScene()).sites).not.toEqual(sites);
});

test.each([
  [100, 112, '+12 %'],
  [100, 97, '−3 %'],
  [100, 100.2, ''],
  [0, 5, ''],
])('from %d to %d reads “%s”', (from, to, text) => expect(changeText(from, to)).toBe(text));

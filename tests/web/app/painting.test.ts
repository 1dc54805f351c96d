/** Paint: what the solver, the picture and undo get of it, and which paint helps. Covers document/paint, paint-gains, painted-meshes. */
import { beforeEach, expect, test } from '@jest/globals';
import type { App } from '../../../web/app/app.ts';
import { appInRoom, type AppInRoom } from '../app-in-room.ts';
import { fakeScene, type FakeSolver } from '../fake-solver.ts';
import type { FakeViewer } from '../fake-viewer.ts';

let solver: FakeSolver;
let viewer: FakeViewer;
let app: App;
let settle: AppInRoom['settle'];

async function opened(hasOperator: boolean): Promise<void> {
  ({ app, solver, viewer, settle } = await appInRoom({ ...fakeScene(), hasOperator }));
}

beforeEach(() => opened(true));

const wall = 1; // reflects 0.25
const asked = () => solver.last('solve')!.intentions.paint;

test('a gesture is one step, and what is shown follows it with the exposure held', async () => {
  app.painting.set(wall, 0.3, null, true);
  app.painting.set(wall, 0.5, null, true);
  expect(viewer.held).toBe(true);
  expect(asked()).toEqual([{ surface: 'wall', reflectance: 0.5 }]);
  expect(viewer.paint).toEqual([{ surface: wall, reflectance: 0.5, albedo: null, factor: 2 }]);
  expect(app.store.painted.value?.surfaces[wall]?.reflectance).toBe(0.5);
  expect(app.store.painted.value?.patchReflectance[15]).toBe(0.5);
  app.store.endGesture();
  expect(viewer.held).toBe(false);
  app.undo();
  expect(app.store.document.value.paint).toBeUndefined();
  expect(viewer.paint).toEqual([]);
  expect(app.store.painted.value).toBe(app.store.scene.value);
});

test('a named paint has its colour; it goes surface by surface, or all at once', async () => {
  app.painting.set(wall, 0.2, '#bf6c4a');
  app.painting.set(0, 2, null);
  const [clay, floor] = [viewer.paint.find(({ surface }) => surface === wall), viewer.paint[0]];
  const [r, g, b] = clay!.albedo!;
  expect(0.2126 * r + 0.7152 * g + 0.0722 * b).toBeCloseTo(0.2, 6);
  expect(r).toBeGreaterThan(2 * b);
  expect(floor).toMatchObject({ reflectance: expect.any(Number) });
  expect(app.painting.on(0)?.reflectance).toBe(0.9); // the most that there is
  app.painting.reset(wall);
  expect(asked()).toEqual([{ surface: 'floor', reflectance: 0.9 }]);
  app.painting.reset(null);
  expect(asked()).toBeUndefined();
});

test('which paint helps is told of what is asked, and the first glows while it is looked at', async () => {
  app.addCard('illuminate', ['floor']);
  await settle();
  expect(solver.last('gains')).toBeUndefined();
  app.painting.isWatched.value = true;
  await settle();
  expect(app.painting.wish.value?.text).toBe('more light on floor');
  expect(app.painting.lines.value).toEqual([
    { surface: wall, name: 'wall', isLighter: true, text: '+12.0 lx', share: 1 },
    { surface: 0, name: 'floor', isLighter: false, text: '+2.00 lx', share: 2 / 12 },
  ]);
  expect(viewer.glow).toEqual([]); // not on the screen
  app.painting.isSeen.value = true;
  expect(viewer.glow).toEqual([wall]);
  // A bound that is missed comes first.
  const card = app.store.document.value.cards.at(-1)!;
  app.changeCard(card.id, 'at most', (each) => ({ ...each, mean: { max: 1 } }));
  await settle();
  expect(app.painting.lines.value.map(({ name, isLighter }) => [name, isLighter])).toEqual([
    ['floor', false],
    ['wall', false],
  ]);
  app.painting.isSeen.value = false;
  expect(viewer.glow).toEqual([]);
});

test('a room whose file cannot tell is neither painted nor asked', async () => {
  await opened(false);
  app.painting.set(wall, 0.5, null);
  app.painting.isWatched.value = true;
  await settle();
  expect(app.painting.canPaint.value).toBe(false);
  expect(viewer.paint).toEqual([]);
  expect(app.store.painted.value).toBe(app.store.scene.value);
  expect(solver.last('gains')).toBeUndefined();
});

test('what paint does to glare and to light on faces is told in their units', async () => {
  app.painting.isWatched.value = true;
  app.store.edit('No glare', (draft) => {
    draft.glare = { max: 19 };
  });
  await settle();
  expect(app.painting.wish.value?.text).toBe('less glare');
  expect(app.painting.lines.value.map(({ name, isLighter, text }) => [name, isLighter, text])).toEqual([
    ['floor', false, '−30.00 UGR'],
    ['wall', false, '−3.00 UGR'],
  ]);
  app.undo();
  app.addCard('illuminate', ['floor']);
  const card = app.store.document.value.cards.at(-1)!;
  app.changeCard(card.id, 'faces', (each) => ({ ...each, cylindrical: { min: 1e5 } }));
  await settle();
  expect(app.painting.wish.value?.text).toBe('more light on faces on floor');
  expect(app.painting.lines.value[0]?.text).toBe('+30.0 lx');
  expect(app.painting.leavesOut.value).toBe(false);
});

test('that no paint changes direct light is said where it is asked', async () => {
  app.painting.isWatched.value = true;
  app.addCard('illuminate', ['floor']);
  const card = app.store.document.value.cards.at(-1)!;
  app.changeCard(card.id, 'at least', (each) => ({ ...each, mean: { min: 1e5 } }));
  await settle();
  expect(app.painting.wish.value).toMatchObject({ of: 'constraints', text: 'more light on floor' });
  expect(app.painting.leavesOut.value).toBe(false);
  app.changeCard(card.id, 'direct', (each) => ({ ...each, direct: true }));
  await settle();
  expect(app.painting.wish.value).toMatchObject({ of: 'goals' }); // what its reflections could help
  expect(app.painting.leavesOut.value).toBe(true);
});

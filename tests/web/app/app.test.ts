// The app with a pretended worker and view: what is asked, what is shown, and in which order.
// Covers app, actions, hand, showing, solving, store, opening, opening-files, placing.
import { afterEach, beforeEach, describe, expect, jest, test } from '@jest/globals';
import { actions, isEnabled } from '../../../web/app/actions.ts';
import { App } from '../../../web/app/app.ts';
import { usualChoices } from '../../../web/app/importing/model-choices.ts';
import { keyOf } from '../../../web/app/keyboard.ts';
import { Store, type SheetState } from '../../../web/app/state/store.ts';
import { expectScene } from '../../../web/app/opening/first-scene.ts';
import { outlineOf } from '../../../web/document/areas.ts';
import { keepRange } from '../../../web/document/intentions.ts';
import { surfaceText } from '../../../web/language/surface-names.ts';
import type { ToWorker } from '../../../web/solver/protocol.ts';
import { WorkerEnded } from '../../../web/solver/worker-ended.ts';
import { matching } from '../../../web/panel/dialogs/palette.tsx';
import { FakeSolver, fakeShown } from '../fake-solver.ts';
import { fakeHost, type FakeHost } from '../fake-host.ts';
import { packedPlan } from '../../../web/room-maker/plan-code.mjs';
import { outlines } from '../../../web/room-maker/plan-shapes.mjs';
import { planOf } from '../../../web/room-maker/room-plan.mjs';
import { fakeViewer, type FakeViewer } from '../fake-viewer.ts';

let frames: (() => void)[] = [];
let host: FakeHost;
let solver: FakeSolver;
let viewer: FakeViewer;
let app: App;

type Solve = Extract<ToWorker, { readonly type: 'solve' }>;

const turn = () => new Promise((resolve) => setImmediate(resolve));
const frame = () => frames.splice(0).forEach((action) => action());
const settle = () => {
  solver.flush();
  frame();
};
const file = (name: string) => new File([new Uint8Array(4)], name);

/** A .flux of one's own: floor and wall, sixteen sites. */
async function openRoom(): Promise<void> {
  const opening = app.opening.files([file('room.flux')]);
  await turn();
  solver.flush();
  await opening;
  settle();
}

function newApp(): App {
  const fake = fakeViewer();
  const made = new App(new Store(), {
    canvas: null as unknown as HTMLCanvasElement,
    labels: null as unknown as HTMLElement,
    createViewer: fake.create,
    createWorker: () => (solver = new FakeSolver()),
  });
  viewer = fake.viewer();
  return made;
}

beforeEach(async () => {
  frames = [];
  host = fakeHost();
  globalThis.requestAnimationFrame = (action) => frames.push(() => action(0));
  app = newApp();
  await openRoom();
});

test('while a model without light is shown, the room before it can be neither shared nor changed', () => {
  app.addCard('illuminate', ['floor']);
  const enabled = (id: string) =>
    isEnabled(
      actions.find((each) => each.id === id)!,
      app,
    );
  const ofRoom = ['undo', 'share', 'add-intention', 'resolve'];
  expect(ofRoom.map(enabled)).toEqual([true, true, true, true]);
  app.store.preview.value = 'model.glb';
  expect(ofRoom.map(enabled)).toEqual([false, false, false, false]);
  expect(enabled('view-plan')).toBe(true);
});

test('a count that its arrangement has no middle for is asked for with less of an axis by one click', async () => {
  app.addCard('illuminate', ['floor']);
  settle();
  solver.hasRoom = ({ arrangement }) => arrangement?.axis !== 'both';
  app.comparing.arrange({ rule: 'field', axis: 'both' });
  settle();
  const { revision } = solver.last('solve')!;
  expect(app.store.announcement.value).toMatch(/^Settled/);
  solver.say({ type: 'failed', revision, message: 'found no regular field of 9', fatal: false });
  expect(app.store.announcement.value).toBe(''); // it told of what was asked before
  const refusals = () => app.store.messages.value.filter(({ kind }) => kind === 'error');
  const offered = () => refusals().map(({ action }) => action?.label);
  expect(offered()).toEqual([undefined]);
  solver.flush();
  await turn();
  expect(offered()).toEqual(['Ease the axis']);
  refusals()[0]!.action!.run();
  expect(app.store.document.value.luminaires.arrangement).toEqual({ rule: 'field', axis: 'x' });
  settle();
  expect(offered()).toEqual([]);
});

test('what is shown while a wish is refused is told to be of the wish before', () => {
  app.addCard('illuminate', ['floor']);
  settle();
  expect(app.store.isOfBefore.value).toBe(false);
  app.comparing.arrange({ rule: 'field', axis: 'both' });
  expect(app.store.isOfBefore.value).toBe(false); // it is being searched for
  const { revision } = solver.last('solve')!;
  solver.say({ type: 'failed', revision, message: 'found no regular field of 9', fatal: false });
  expect(app.store.isOfBefore.value).toBe(true);
  app.store.undo();
  settle();
  expect(app.store.isOfBefore.value).toBe(false);
});

test('a search from nowhere is tagged as a plan is read; one that goes on, or that holds a place, is not', () => {
  const tags = () => app.store.shown.value!.layout.sites;
  const answer = () => {
    const { revision, intentions } = solver.last('solve')!;
    const layout = { sites: [9, 2, 5], flux: [1, 2, 3], dimming: 1 }; // x + 4 z, z to the south
    const shown = fakeShown(solver.scene, layout, intentions);
    solver.say({
      type: 'settled',
      revision,
      shown,
      evaluations: 9,
      milliseconds: 1,
      askedAt: 0,
      postedAt: 1,
    });
    frame();
  };
  app.solving.solve(null);
  answer();
  expect(tags()).toEqual([2, 5, 9]);
  expect(app.store.shown.value!.layout.flux).toEqual([2, 3, 1]);
  app.solving.solve();
  expect(solver.last('solve')!.start!.sites).toEqual([2, 5, 9]);
  answer();
  expect(tags()).toEqual([9, 2, 5]);
  app.store.edit('Pin', ({ luminaires }) => void (luminaires.pinned = [9]), null, {
    by: 'search',
    from: null,
  });
  answer();
  expect(tags()).toEqual([9, 2, 5]);
});

test('a luminaire that is removed leaves the others where they are, and the last one stays', () => {
  const { sites } = app.store.shown.value!.layout;
  app.hand.remove([1]);
  expect(app.store.document.value.luminaires.count).toBe(sites.length - 1);
  expect(solver.last('solve')?.start?.sites).toEqual(sites.filter((_, i) => i !== 1));
  settle();
  for (let i = sites.length; i > 0; i--) {
    app.hand.remove([0]);
    settle();
  }
  expect(app.store.document.value.luminaires.count).toBe(1);
  expect(app.store.messages.value.at(-1)?.text).toContain('The last luminaire stays');
});

test('a luminaire may have to be of a type, and keeps that when another one goes', () => {
  app.hand.setType(2, 't1');
  expect(solver.last('solve')?.intentions.luminaires.ofType).toEqual([null, null, 't1']);
  settle();
  app.hand.remove([0]);
  expect(app.store.document.value.luminaires.ofType).toEqual([null, 't1']);
  settle();
  app.hand.setType(1, null);
  expect(app.store.document.value.luminaires).not.toHaveProperty('ofType');
});

test('a measuring plane that is drawn is seen in plan until it is lit, and no longer once the sheet is closed', () => {
  const outline = [[1, 1], [3, 1], [3, 2]] as const; // prettier-ignore
  const drawn = [{ name: 'plane 1', outline, height: 0.75, border: 0.1 }];
  app.store.sheet.value = { choices: { ...usualChoices, drawn } } as unknown as SheetState;
  expect(app.markedAreas()).toEqual([{ kind: 'plane', outline, height: 0.75 }]);
  app.store.sheet.value = null;
  expect(app.markedAreas()).toEqual([]);
});

test('the floor that the pipeline has found is called so, whatever its mesh is called; what it measures is not', async () => {
  const { ask, ...scene } = { ask: { mean: 300, count: 4 }, ...solver.scene };
  const open = (surface: string, measuring = false) =>
    void (app.store.scene.value = {
      ...scene,
      surfaces: [{ ...scene.surfaces[0]!, name: surface, measuring }, scene.surfaces[1]!],
      provenance: { ask: { ...ask, surface } },
    });
  open('Plane.003');
  expect(surfaceText('Plane.003')).toBe('floor (Plane.003)');
  open('grid', true);
  expect(['grid', 'Plane.003'].map(surfaceText)).toEqual(['grid', 'Plane.003']);
  open('Ground floor');
  expect(surfaceText('Ground floor')).toBe('Ground floor');
});

test('a kept view is part of the document and asks nothing of the solver', () => {
  const asked = solver.asked.length;
  app.keepView('Door');
  app.keepView('Door');
  expect(app.store.document.value.views).toEqual([{ name: 'Door', camera: viewer.camera() }]);
  app.forgetView('Door');
  expect(app.store.document.value.views).toEqual([]);
  expect(solver.asked).toHaveLength(asked);
});

test('a room that is opened is asked about once, from nowhere', () => {
  const asked = solver.asked.filter(({ type }) => type === 'solve' || type === 'show');
  expect(asked).toMatchObject([{ type: 'solve', start: null }]);
});

describe('a room that begins with its light', () => {
  const lit = (count: number) => ({
    layout: {
      sites: Array.from({ length: count }, (_, i) => 2 * i),
      flux: Array(count).fill(3e3),
      dimming: 1,
    },
    illuminance: new Float32Array(16).fill(count),
  });

  async function openLit(count: number): Promise<void> {
    solver.light = lit(count);
    viewer.light = null;
    const opening = app.opening.files([file('lit.flux')]);
    await turn();
    solver.flush();
    await opening;
  }

  test('is seen in it before anything is answered, and the search goes on from it', async () => {
    await openLit(6);
    expect(viewer.light).toEqual(lit(6).illuminance);
    expect(app.store.shown.value).toBeNull();
    expect(solver.last('solve')).toMatchObject({ start: lit(6).layout });
    settle();
    expect(app.store.shown.value).not.toBeNull();
  });

  test('that is of another number of luminaires than is asked for is not shown', async () => {
    await openLit(5);
    expect(viewer.light).toBeNull();
    expect(solver.last('solve')).toMatchObject({ start: null });
  });

  test('says so where the rest of it does not come', async () => {
    await openLit(6);
    const { revision } = solver.last('open')!;
    solver.say({ type: 'failed', revision, message: 'the connection was lost', fatal: false });
    const failed = { type: 'failed', message: 'the connection was lost', fatal: false } as const;
    const isTold = () =>
      expect(app.store.messages.value.filter(({ kind }) => kind === 'error')).toMatchObject([
        { text: 'The connection was lost.', action: { label: 'Try again' } },
      ]);
    isTold();
    // Neither what its first part can answer nor what it cannot takes the button away.
    settle();
    isTold();
    app.solving.solve();
    solver.say({ ...failed, revision: solver.last('solve')!.revision });
    isTold();
  });
});

describe('an edit', () => {
  test('asks the solver at once, from the layout that is shown', () => {
    const before = solver.asked.length;
    app.addCard('illuminate', ['floor']);
    expect(solver.asked).toHaveLength(before + 1);
    const request = solver.last('solve')!;
    expect(request.start?.sites).toEqual(app.store.shown.value?.layout.sites);
    expect(request.intentions.goals.at(-1)).toMatchObject({
      statistic: 'mean',
      sense: 'max',
      surfaces: ['floor'],
    });
  });

  test('lights the view before the numbers of the panel', () => {
    const shown = app.store.shown.value;
    viewer.light = null;
    app.addCard('illuminate', ['floor']);
    solver.flush();
    expect(viewer.light).not.toBeNull();
    expect(app.store.shown.value).toBe(shown);
    frame();
    expect(app.store.shown.value).not.toBe(shown);
    expect(app.store.progress.value.state).toBe('settled');
  });

  test('of a settled, met problem asks for a bound', () => {
    app.addCard('illuminate', ['floor']);
    settle();
    expect(solver.last('bound')).toMatchObject({ isBrief: false });
  });

  test('of a settled, met problem asks for a brief bound while other light is computed', () => {
    const lighting = { name: 'a.glb', pass: 'full', stage: 'casting', share: 0.5, secondsLeft: 9 } as const;
    app.store.lighting.value = { ...lighting, fault: null };
    app.addCard('illuminate', ['floor']);
    settle();
    expect(solver.last('bound')).toMatchObject({ isBrief: true });
    app.store.lighting.value = { ...lighting, fault: 'The computation was stopped.' };
    app.addCard('homogenize', ['floor']);
    settle();
    expect(solver.last('bound')).toMatchObject({ isBrief: false });
  });

  test('what is proved of it ends for a model that is on its way; what is still searched does not', () => {
    app.addCard('illuminate', ['floor']);
    app.store.progress.value = { ...app.store.progress.value, state: 'improving' };
    app.opening.lighting.expect();
    expect(solver.last('stop')).toBeUndefined();
    settle();
    app.opening.lighting.expect();
    expect(solver.asked.at(-1)).toEqual({ type: 'stop' });
  });

  test('exitance is refused while an intention is aimed at a measuring plane', () => {
    const scene = app.store.scene.value!;
    const surfaces = scene.surfaces.map((surface) => ({ ...surface, measuring: surface.name === 'wall' }));
    app.store.scene.value = { ...scene, surfaces };
    app.addCard('illuminate', ['wall']);
    app.setQuantity('exitance');
    expect(app.store.document.value.quantity).toBe('illuminance');
    expect(app.store.messages.value.at(-1)?.text).toContain('measuring plane');
    app.removeCard(app.store.card.value!);
    app.setQuantity('exitance');
    expect(app.store.document.value.quantity).toBe('exitance');
  });

  test('undo shows the very layout that was there', () => {
    const before = app.store.shown.value!.layout;
    app.store.edit('count', (draft) => void (draft.luminaires.count = 3));
    settle();
    expect(app.store.shown.value?.layout.sites).toHaveLength(3);
    app.undo();
    expect(solver.last('show')?.layout).toEqual(before);
  });

  test('keep holds the mean that is there', () => {
    const mean = app.store.shown.value!.surfaces[0]!.mean;
    app.addCard('keep', ['floor']);
    expect(app.store.document.value.cards.at(-1)?.mean).toEqual(keepRange(mean));
  });
});

describe('a luminaire under the hand', () => {
  test('is pinned, keeps its tag, and the whole drag is one step', () => {
    const steps = app.store.history.value.past.length;
    for (const site of [12, 13, 14]) viewer.events.luminaireDragged(2, site);
    viewer.events.luminaireDropped(2, 14);
    expect(app.store.document.value.luminaires.pinned).toEqual([14]);
    expect(app.store.history.value.past).toHaveLength(steps + 1);
    expect(solver.last('solve')?.start?.sites[2]).toBe(14);
    settle();
    expect(viewer.layout?.sites[2]).toBe(14); // it is still L3
    expect(viewer.pinned).toEqual([14]);
    app.undo();
    expect(app.store.document.value.luminaires.pinned).toEqual([]);
  });

  test('does not go where another one hangs', () => {
    const taken = app.store.shown.value!.layout.sites[0]!;
    const asked = solver.asked.length;
    viewer.events.luminaireDragged(1, taken);
    expect(solver.asked).toHaveLength(asked);
  });

  test('goes to the free place nearest to a typed one, and says where that is not there', () => {
    app.hand.moveNear(2, [3, 3, 3]);
    expect(solver.last('solve')?.start?.sites[2]).toBe(15);
    expect(app.store.messages.value.filter(({ text }) => text.includes('nearest'))).toEqual([]);
    settle();
    const asked = solver.asked.length;
    app.hand.moveNear(2, [3.3, 3, 3]);
    expect(solver.asked).toHaveLength(asked); // it hangs there already
    expect(app.store.messages.value.at(-1)?.text).toBe(
      'L3 hangs at the nearest free place, 0.30 m from there.',
    );
  });

  test('can be told that a place stays free', () => {
    const site = app.store.shown.value!.layout.sites[0]!;
    app.hand.exclude(site);
    settle();
    expect(app.store.shown.value?.layout.sites).not.toContain(site);
  });
});

describe('a luminaire that does not hang alone', () => {
  test('goes where all that go with it find a place, and says so', () => {
    app.hand.pick(0, 'alone');
    app.hand.pick(1, 'also');
    app.hand.moveNear(0, [3, 3, 3]); // L2 would hang beside the room
    expect(solver.last('solve')?.start?.sites.slice(0, 3)).toEqual([14, 15, 2]);
    expect(app.store.messages.value.at(-1)?.text).toBe(
      'L1 hangs at the nearest free place, 1.00 m from there.',
    );
  });

  test('takes a field along, which then need not be in the middle any more, and says so once', () => {
    app.store.edit('a field in the middle', ({ luminaires }) => {
      luminaires.arrangement = { rule: 'field', axis: 'both' };
    });
    const said = () => app.store.messages.value.filter(({ text }) => text.includes('no longer kept'));
    for (const site of [12, 13]) viewer.events.luminaireDragged(2, site); // along z, then along x
    expect(app.store.document.value.luminaires.arrangement).toEqual({ rule: 'field' });
    viewer.events.luminaireDropped(2, 13);
    expect(said()).toHaveLength(1);
    app.undo();
    expect(app.store.document.value.luminaires.arrangement).toEqual({ rule: 'field', axis: 'both' });
  });

  test('takes along all that are selected, in one step, and shows where they go', () => {
    const { sites } = app.store.shown.value!.layout;
    expect(sites.slice(0, 3)).toEqual([0, 1, 2]);
    viewer.events.luminairePicked(0, 'alone');
    viewer.events.luminairePicked(1, 'also');
    const steps = app.store.history.value.past.length;
    viewer.events.luminairePicked(0, 'held');
    expect(app.store.luminaires.value).toEqual([1, 0]);
    viewer.events.luminaireDragged(0, 12);
    expect(viewer.ghosts).toEqual([13]);
    viewer.events.luminaireDropped(0, 12);
    expect(viewer.ghosts).toEqual([]);
    expect(solver.last('solve')?.start?.sites.slice(0, 3)).toEqual([12, 13, 2]);
    expect(app.store.document.value.luminaires.pinned).toEqual([13, 12]);
    expect(app.store.history.value.past).toHaveLength(steps + 1);
    settle();
    const asked = solver.asked.length;
    viewer.events.luminaireDropped(0, 15); // L2 would hang beside the room
    expect(solver.asked).toHaveLength(asked);
    app.hand.togglePin(app.store.luminaires.value);
    expect(app.store.document.value.luminaires.pinned).toEqual([]);
    viewer.events.luminairePicked(1, 'also');
    expect(app.store.luminaires.value).toEqual([0]);
  });

  test('is removed with all that are selected', () => {
    const { sites } = app.store.shown.value!.layout;
    const count = sites.length;
    app.hand.pickIn([-0.5, -0.5, 1.5, 0.5]);
    expect(app.store.luminaires.value).toEqual([0, 1]);
    app.hand.remove(app.store.luminaires.value);
    expect(app.store.document.value.luminaires.count).toBe(count - 2);
    expect(solver.last('solve')?.start?.sites).toEqual(sites.slice(2));
    app.undo();
    app.hand.pickIn(null);
    expect(app.store.luminaires.value).toHaveLength(count);
  });
});

describe('a task area', () => {
  test('is drawn, asked for light, and taken back with its cards', () => {
    app.tasks.add(outlineOf([-0.5, -0.5, 1.5, 0.5]));
    expect(app.store.document.value.taskAreas).toMatchObject([{ name: 'task 1', surface: 'floor' }]);
    expect(solver.last('solve')?.intentions.taskAreas).toHaveLength(1);
    const names = app.store.sceneWithAreas.value?.surfaces.map(({ name }) => name);
    expect(names).toEqual(['floor', 'wall', 'task 1', 'task 1 surround', 'floor background']);
    app.tasks.ask(0, 500);
    const asked = app.store.document.value.cards.map(({ surfaces, mean }) => [surfaces[0], mean?.min]);
    expect(asked.slice(-3)).toEqual([
      ['task 1', 500],
      ['task 1 surround', 300],
      ['floor background', 100],
    ]);
    settle();
    const { length } = app.store.document.value.cards;
    app.tasks.remove(0);
    expect(app.store.document.value.cards).toHaveLength(length - 3);
    expect(app.store.document.value).not.toHaveProperty('taskAreas');
    app.undo();
    expect(app.store.document.value.cards).toHaveLength(length);
  });

  test('that lies on nothing is told', () => {
    app.tasks.add(outlineOf([20, 20, 21, 21]));
    expect(app.store.document.value).not.toHaveProperty('taskAreas');
    expect(app.store.messages.value.at(-1)?.text).toContain('no measuring plane');
  });
});

describe('links', () => {
  test('show exactly the layout, nothing is searched', async () => {
    globalThis.location = { href: 'https://example.test/sub/', hash: '' } as Location;
    const wish = app.store.shown.value!.layout;
    const hash = app.keeping.link().address.slice('https://example.test/sub/'.length);
    await app.opening.link(hash); // about a file that is not part of the site: it waits for that file
    expect(app.store.messages.value.at(-1)?.text).toMatch(/room\.flux/);
    const solves = solver.asked.filter((message) => message.type === 'solve').length;
    await openRoom();
    expect(solver.last('show')?.layout.sites).toEqual(wish.sites);
    expect(solver.asked.filter((message) => message.type === 'solve')).toHaveLength(solves);
    expect(app.store.progress.value.state).toBe('shown');
  });

  test('of a made room hold it: it is made anew, and what is asked of it waits for its light', async () => {
    globalThis.location = { href: 'https://example.test/sub/', hash: '' } as Location;
    const wish = app.store.shown.value!.layout;
    app.store.plan.value = packedPlan(planOf(outlines.rectangle(6, 4), 2.8, 'Studio'));
    const hash = app.keeping.link().address.slice('https://example.test/sub/'.length);
    app.store.plan.value = null;
    expect(await app.opening.link(hash)).toBe(true);
    expect(app.store.preview.value).toBe('room.glb');
    expect(app.store.plan.value?.[1]).toBe('Studio');
    await openRoom();
    expect(solver.last('show')?.layout.sites).toEqual(wish.sites);
  });

  test('with a room that cannot be made say so', async () => {
    globalThis.location = { href: 'https://example.test/sub/', hash: '' } as Location;
    app.store.plan.value = [1, 'Studio', 2800, [0, 0, 1000, 1000, 1000, 0, 0, 1000], [], [], [], [], [], []];
    const hash = app.keeping.link().address.slice('https://example.test/sub/'.length);
    expect(await app.opening.link(hash)).toBe(false);
    expect(app.store.messages.value.at(-1)?.text).toMatch(/room in this link cannot be made/);
  });

  test('that are damaged leave what is there and say one line', async () => {
    const before = app.store.document.value;
    expect(await app.opening.link('#f1.AAAA.00000000')).toBe(false);
    expect(app.store.document.value).toBe(before);
    expect(app.store.messages.value.at(-1)).toMatchObject({ kind: 'error' });
  });
});

/** Opens a room of the site: its file comes, the solver answers. */
async function opened(opening: Promise<unknown>): Promise<void> {
  for (let i = 0; i < 20; i++) {
    await turn();
    solver.flush();
  }
  await opening;
  settle();
}

/** For the tests of a describe: the list of rooms is looked at again from time to time. */
function fakeTimers(): void {
  beforeEach(() => void jest.useFakeTimers({ doNotFake: ['setImmediate', 'performance'] }));
  afterEach(() => void jest.useRealTimers());
}

/** The hash of a link to a room of the site, which has no other. */
async function hashOf(id: string, title: string, file: string): Promise<string> {
  host.catalog = { rooms: [{ id, title, file }] };
  globalThis.location = { href: 'https://example.test/sub/', hash: '' } as Location;
  await app.rooms.load();
  await opened(app.opening.entry(id));
  return app.keeping.link().address.split('/').at(-1)!;
}

describe('the first room of a visit', () => {
  fakeTimers();

  test('opens with what the list asks of it', async () => {
    app.store.scene.value = null; // as on the first screen
    await opened(app.opening.start('', async () => null, 'e-corridor'));
    expect(host.asked).toEqual(['catalog.json', 'e-corridor.flux']);
    expect(app.store.roomTitle.value).toBe('E corridor');
    expect(app.store.document.value).toMatchObject({ room: 'e-corridor', luminaires: { count: 6 } });
    expect(solver.last('solve')?.intentions.goals[0]).toMatchObject({ surfaces: ['yellow wall'] });
  });

  test('opens with the luminaires that it names, asked for on the site', async () => {
    app.store.scene.value = null;
    await opened(app.opening.start('', async () => null));
    expect(host.asked).toEqual(['catalog.json', 'office.flux', '/sub/luminaires/panel.ldt']);
  });

  test('does not come where a person began a room of their own before, until that is closed', async () => {
    app = newApp();
    let answer: (work: null) => void = () => {};
    const starting = app.opening.start('', () => new Promise((resolve) => (answer = resolve)));
    await turn();
    app.opening.make(null);
    answer(null);
    await opened(starting);
    expect(app.store.making.value).not.toBeNull();
    expect(host.asked).toEqual([]);
    await opened(app.opening.endMaking());
    expect(app.store.roomTitle.value).toBe('Open office');
  });

  test('is that of the last work, too, where a room maker was opened and closed before the list of rooms came', async () => {
    await app.rooms.load();
    await opened(app.opening.entry('box'));
    app.addCard('illuminate', ['wall']);
    const work = { project: app.keeping.project(), past: [], future: [] };
    app = newApp();
    const starting = app.opening.start('', async () => work);
    await turn();
    app.opening.make(null);
    await app.opening.showMaking('6 × 4 m', new ArrayBuffer(4), true);
    await opened(starting);
    await opened(app.opening.endMaking());
    expect(app.store.roomTitle.value).toBe('Box');
    expect(app.store.document.value.cards.at(-1)).toMatchObject({ surfaces: ['wall'] });
    expect(app.store.preview.value).toBeNull();
  });

  test('a link that waits for the list of rooms does not close what a person opened meanwhile', async () => {
    const hash = await hashOf('box', 'Box', 'box.flux');
    app = newApp();
    const starting = app.opening.start(hash, async () => null);
    app.opening.make(null);
    await opened(starting);
    expect(app.store.making.value).not.toBeNull();
    expect(app.store.scene.value).toBeNull();
    await opened(app.opening.endMaking());
    expect(app.store.roomTitle.value).toBe('Box');
  });

  test('without the list of rooms one sentence offers to try again', async () => {
    host.catalog = 'offline';
    app.store.scene.value = null; // as on the first screen
    await opened(app.opening.start('', async () => null));
    const message = app.store.messages.value.at(-1)!;
    expect(message.text).toBe('The list of rooms could not be loaded: no connection.');
    host = fakeHost();
    message.action?.run();
    await opened(Promise.resolve());
    expect(app.store.roomTitle.value).toBe('Open office');
  });
});

const faults = () => app.store.messages.value.filter(({ kind }) => kind === 'error');

/** The worker dies, and those that take its place, until there is no other try. */
async function die(): Promise<void> {
  for (let deaths = 0; deaths < 3; deaths++) {
    solver.onerror?.({ message: 'gone' } as ErrorEvent);
    await turn();
  }
}

describe('rooms of the site', () => {
  fakeTimers();

  test('an experiment finds out first what its bounds are shares of', async () => {
    const bound = { min: { illuminate: 0.5 } };
    const cards = [{ verb: 'vary', surfaces: ['wall'], mean: bound }];
    const experiment = { id: 'half', title: 'Half', file: 'box.flux', opening: { cards } };
    host.catalog = { rooms: [{ id: 'box', title: 'Box', file: 'box.flux' }], experiments: [experiment] };
    await app.rooms.load();
    await opened(app.opening.entry('half'));
    const [first, probe, last] = solver.asked.filter(({ type }) => type === 'solve').slice(-3) as Solve[];
    expect(first?.intentions.constraints).toEqual([]);
    expect(probe?.intentions.goals).toMatchObject([{ statistic: 'mean', sense: 'max', surfaces: ['wall'] }]);
    expect(last?.start).toBeNull();
    const best = app.store.shown.value!.surfaces.find(({ name }) => name === 'wall')!.mean; // of the same layout
    expect(last?.intentions.constraints).toMatchObject([
      { statistic: 'mean', min: Number((best / 2).toPrecision(3)) },
    ]);
  });

  test('one that is being computed says so, and what is shown stays', async () => {
    host = fakeHost({ box: { state: 'computing', progress: 0.4 } });
    const { document } = app.store;
    const before = document.value;
    await app.rooms.load();
    await opened(app.opening.entry('box'));
    expect(app.store.messages.value.at(-1)?.text).toBe('“Box” is not ready yet: being computed, 40 %.');
    expect(document.value).toBe(before);
    expect(host.asked).not.toContain('box.flux');
    host.catalog = { rooms: [{ id: 'box', title: 'Box', file: 'box.flux' }] };
    await jest.advanceTimersByTimeAsync(3300); // the list is looked at again
    await opened(app.opening.entry('box'));
    expect(document.value.room).toBe('box');
  });

  test('one that is on the screen already stays as it is', async () => {
    host.catalog = { rooms: [{ id: 'box', title: 'Box', file: 'box.flux' }] };
    await app.rooms.load();
    await opened(app.opening.entry('box'));
    const again = app.opening.entry('box');
    app.addCard('illuminate', ['floor']); // while it would be opened
    await opened(again);
    expect(host.asked.filter((name) => name === 'box.flux')).toHaveLength(1);
    expect(app.store.document.value.cards.at(-1)).toMatchObject({ surfaces: ['floor'] });
  });

  test('one that was not all there when the solver died says so once, with what helps', async () => {
    let lose: (error: Error) => void = () => {};
    const bytes = new Promise<ArrayBuffer>((_, reject) => (lose = reject));
    const opens = (revision: number) => {
      solver.say({ type: 'room', revision, room: new ArrayBuffer(8) });
      solver.say({ type: 'opened', revision, scene: solver.scene, light: null });
      return true;
    };
    await app.rooms.load();
    expectScene('box', { begun: Promise.resolve(), bytes, abandon: () => {} });
    Object.assign(solver, { adopt: (_: unknown, revision: number) => opens(revision) });
    await opened(app.opening.entry('box'));
    lose(new WorkerEnded('gone'));
    await die();
    expect(faults().map(({ text, action }) => [text, action?.label])).toEqual([
      ['The room could not be loaded: the solver stopped (gone); try again.', 'Try again'],
    ]);
  });

  test("a room of the site's owner opens by a link, too", async () => {
    const hash = await hashOf('attic', 'Attic', 'My_attic.v2.flux');
    await opened(app.opening.link(hash));
    expect(app.store.roomTitle.value).toBe('Attic');
    expect(app.store.document.value.room).toBe('My_attic.v2');
    expect(host.asked.filter((name) => name === 'My_attic.v2.flux')).toHaveLength(2);
  });
});

describe('when things go wrong', () => {
  test('a failure keeps the layout and offers to resume; one click resumes', async () => {
    const shown = app.store.shown.value;
    solver.say({ type: 'failed', revision: 99, message: 'out of memory', fatal: true });
    app.solving.solve();
    const { revision } = solver.last('solve')!;
    const dead = solver;
    solver.say({ type: 'failed', revision, message: 'out of memory', fatal: true });
    expect(app.store.shown.value).toBe(shown);
    const message = app.store.messages.value.at(-1)!;
    expect(message.action?.label).toBe('Resume');
    message.action?.run();
    expect(dead.terminated).toBe(true);
    expect(solver).not.toBe(dead);
    solver.flush();
    await turn();
    expect(solver.last('solve')?.start?.sites).toEqual(shown?.layout.sites);
  });

  test('a solver that dies again when it is resumed is told once, and may be resumed once more', async () => {
    await die();
    faults()[0]!.action!.run();
    await turn();
    await die();
    expect(faults().map(({ text, action }) => [text, action?.label])).toEqual([
      ['The solver stopped (gone); reload the page to go on.', 'Resume'],
    ]);
    faults()[0]!.action!.run();
    for (let i = 0; i < 3; i++) {
      await turn();
      settle();
    }
    expect(faults()).toEqual([]);
  });

  test('files that are nothing are named', async () => {
    await app.opening.files([file('notes.txt')]);
    expect(app.store.messages.value.at(-1)?.text).toMatch(/notes\.txt.*not a file/);
    await app.opening.files([file('broken.fiatlux.json')]);
    expect(app.store.messages.value.at(-1)?.text).toMatch(/not JSON/);
  });

  test('a scene that does not open leaves the room as it is', async () => {
    const scene = app.store.scene.value;
    const opening = app.opening.files([file('bad.flux')]);
    await turn();
    const request = solver.last('open')!;
    const message = 'section "sites": checksum differs';
    solver.say({ type: 'failed', revision: request.revision, message, fatal: false });
    await opening;
    expect(app.store.scene.value).toBe(scene);
    expect(app.store.messages.value.at(-1)?.text).toMatch(/checksum/);
  });
});

/** Of the page: it can read no model. */
class BrokenWorker {
  onerror: (event: { message: string }) => void = () => {};
  postMessage(): void {
    setImmediate(() => this.onerror({ message: 'gone' }));
  }
  terminate(): void {}
}

test('a model that cannot be shown is refused over the lit room, not under the name of a preview before it', async () => {
  const { Worker } = globalThis;
  globalThis.Worker = BrokenWorker as unknown as typeof Worker;
  app.store.preview.value = 'nan.glb';
  const gltf = JSON.stringify({
    asset: { version: '2.0' },
    buffers: [{ uri: 'missing.bin', byteLength: 4 }],
  });
  await app.opening.files([new File([gltf], 'siblings.gltf')]);
  globalThis.Worker = Worker;
  expect(app.store.preview.value).toBeNull();
  expect(app.store.roomTitle.value).toBe('room');
  expect(app.store.messages.value.at(-1)).toMatchObject({ kind: 'error', text: /siblings/ });
});

test('alpha that is found becomes the alpha of the card, without another search', () => {
  app.addCard('overshadow', ['wall']);
  const id = app.store.card.value!;
  app.changeCard(id, 'g', (card) => ({ ...card, guarantee: { by: 'chebyshev', alpha: 2, min: 1 } }));
  settle();
  app.solving.findAlpha(id, app.store.traced.value.intentions);
  const { revision } = solver.last('alpha')!;
  const shown = { ...app.store.shown.value!, goal: 0.5 };
  const step = {
    iteration: 1,
    alpha: 1,
    region: 'II',
    interval: [0, 1],
    mean: 1,
    sigma: 1,
    minimum: 1,
    goal: 1,
  } as const;
  solver.say({ type: 'alphaStep', revision, step });
  const solves = solver.asked.filter((message) => message.type === 'solve').length;
  solver.say({ type: 'alphaDone', revision, alpha: 1.25, verdict: 'Found.', shown, feasibleBound: null });
  frame();
  expect(app.store.alphaRun.value).toMatchObject({ steps: [step], done: { alpha: 1.25 } });
  expect(app.store.document.value.cards.at(-1)?.guarantee?.alpha).toBe(1.25);
  expect(app.store.alphaRun.value!.done!.verdict).toMatch(/^With alpha = 1\.25, [^\d]*$/); // figures are the card's
  expect(solver.asked.filter((message) => message.type === 'solve')).toHaveLength(solves);
});

test('what a search for alpha has found, or not, stands until another bound is asked for; so does its running', () => {
  app.addCard('overshadow', ['wall']);
  const id = app.store.card.value!;
  const ask = (min: number) =>
    app.changeCard(id, 'g', (card) => ({ ...card, guarantee: { by: 'patches', alpha: 2, min } }));
  const run = () => app.store.alphaRun.value;
  const find = () => app.solving.findAlpha(id, app.store.traced.value.intentions);
  const answer = (alpha: number | null) => {
    const shown = alpha === null ? null : { ...app.store.shown.value!, goal: 0.5 };
    const { revision } = solver.last('alpha')!;
    solver.say({ type: 'alphaDone', revision, alpha, verdict: 'No layout.', shown, feasibleBound: 3 });
    settle();
  };
  ask(1);
  settle();
  find();
  ask(5);
  expect(run()).toBeNull();
  settle();
  for (const alpha of [null, 1.25]) {
    find();
    answer(alpha);
    expect(run()).toMatchObject({ done: { alpha } });
    app.setDisplay({ isolux: true }); // asks nothing
    expect(run()).not.toBeNull();
    ask(alpha ?? 2);
    expect(run()).toBeNull();
    settle();
  }
});

test('a check is of the layout shown, and no longer stands when another one is shown', () => {
  app.solving.check();
  const { revision, layout } = solver.last('check')!;
  expect(layout).toEqual(app.store.shown.value!.layout);
  solver.say({ type: 'checked', revision, largestDifference: 1e-5, surface: 'floor', margins: [] });
  expect(app.store.check.value).toMatchObject({ largestDifference: 1e-5, surface: 'floor' });
  expect(app.store.check.value?.layout).toBe(app.store.shown.value?.layout);
  app.reseed();
  expect(app.store.check.value).toBeNull();
});

describe('the registry of actions', () => {
  test('no two actions share a key or an id', () => {
    const keys = actions.flatMap((action) => action.keys ?? []);
    expect(new Set(keys).size).toBe(keys.length);
    expect(new Set(actions.map((action) => action.id)).size).toBe(actions.length);
  });

  test('is found by words', () => {
    expect(matching(actions, 'plan view')[0]?.id).toBe('view-plan');
    expect(matching(actions, 'zzz')).toEqual([]);
    const surface = {
      ...actions[0]!,
      id: 'surface-0',
      title: () => 'wall south',
      group: 'Surfaces' as const,
    };
    expect(matching([...actions, surface], 'wall south').length).toBeGreaterThan(1); // a view, too
    expect(matching([...actions, surface], 'wall south')[0]).toBe(surface);
  });

  test('keys read as written', () => {
    const event = { key: 'z', ctrlKey: true, metaKey: false, shiftKey: true, altKey: false };
    expect(keyOf(event)).toBe('Mod+Shift+Z');
    expect(keyOf({ ...event, key: '?', ctrlKey: false })).toBe('?');
  });
});

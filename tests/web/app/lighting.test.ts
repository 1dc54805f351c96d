/** What is carried over from a draft to the full room, how its end is told, and how the time left is. */
import { describe, expect, test } from '@jest/globals';
import { outlineOf } from '../../../web/document/areas.ts';
import { readContainer, writeGlb } from '../../../web/document/gltf-container.ts';
import { startHistory, edit } from '../../../web/document/history.ts';
import type { Card, FiatLuxDocument, SceneInfo } from '../../../web/document/types.ts';
import type { BuildOptions, RoomCounts } from '../../../web/builder/builder.ts';
import { TooLarge, type BuilderPool, type BuildWish } from '../../../web/builder/pool.ts';
import type { Model } from '../../../web/builder/protocol.ts';
import { Lighting, type Shelf } from '../../../web/app/lighting/lighting.ts';
import type { Placement, Placing } from '../../../web/app/opening/placing.ts';
import type { Solving } from '../../../web/app/solving.ts';
import { firstDisplay, Store } from '../../../web/app/state/store.ts';
import { areSameSites, carriedOver, fitting } from '../../../web/app/lighting/carried-over.ts';
import { isBeyondMemory, long, secondsForeseen } from '../../../web/app/lighting/foreseen.ts';
import { usualChoices } from '../../../web/app/importing/model-choices.ts';
import { TimeLeft } from '../../../web/app/lighting/time-left.ts';
import { askedOfUnknown, documentFrom } from '../../../web/app/rooms/opening-wish.ts';
import { timeLeft } from '../../../web/panel/preview-note.tsx';

function sceneWith(identity: string, xs: readonly number[]): SceneInfo {
  const position = new Float32Array(xs.flatMap((x) => [x, 2.5, 0]));
  const size = new Float32Array(xs.map(() => 0.4));
  return { identity, surfaces: [], sites: { position, size, normal: position, axis: position } } as never;
}

const draft = sceneWith('d'.repeat(16), [0, 1, 2, 3]);
const asked = askedOfUnknown([], 4);
const document: FiatLuxDocument = {
  ...documentFrom(asked, draft.identity, 'a.flux'),
  luminaires: { ...asked.luminaires, count: 2, pinned: [1] },
};
const history = edit(startHistory(document), 'Change', (each) => void (each.saving = true), null);
const layout = { sites: [1, 3], flux: [3000, 3000], dimming: 1 };

describe('from the draft to the full room', () => {
  test('where the places are the same, everything stays: layout, pins and history', () => {
    const full = sceneWith('f'.repeat(16), [0, 1, 2, 3]);
    const carried = carriedOver(history, layout, firstDisplay, draft, full);
    expect(carried.document).toEqual({ ...history.document, scene: full.identity, layout });
    expect(carried.history.past).toBe(history.past);
  });

  test('where they are not, luminaires go to the nearest places', () => {
    const full = sceneWith('f'.repeat(16), [0.1, 2.9, 1.2]);
    expect(areSameSites(draft.sites, full.sites)).toBe(false);
    const carried = carriedOver(history, layout, firstDisplay, draft, full);
    expect(carried.document.layout?.sites).toEqual([2, 1]);
    expect(carried.document.luminaires.pinned).toEqual([2]);
    expect(carried.document.scene).toBe(full.identity);
    expect(carried.history.past).toEqual([]);
  });
});

/** Keeps how models were understood, and nothing else. */
function rememberingShelf(): Shelf {
  const kept = new Map<string, unknown>();
  return {
    nameFor: async () => 'a.flux',
    keep: async (_, __, ___, understood) =>
      void (understood && kept.set(understood.digest, structuredClone(understood.choices))),
    understood: async (digest) => kept.get(digest) ?? null,
    titleOf: () => 'a',
  };
}

/** Lights rooms on a store of its own; `next` is what is placed from then on. */
function lightingOf(first: SceneInfo) {
  const store = new Store();
  const placed: FiatLuxDocument[] = [];
  const room = {
    next: first,
    isFullTooLarge: false,
    counts: {} as Pick<RoomCounts, 'rows' | 'patchSize'>, // of its draft
    warnings: [] as string[],
    told: [] as string[],
    work: 3,
    why: '',
    times: undefined as number | undefined, // of the memory there is, that what is too large would need
    resumed: 0, // searches of the room before
    foreseen: [] as (number | undefined)[],
    seen: [] as (string | undefined)[],
  };
  type Make = (scene: SceneInfo) => Promise<Placement>;
  const place = async (_: unknown, title: string, __: unknown, make: Make) => {
    const { document: made } = await make(room.next);
    placed.push(made);
    store.scene.value = room.next;
    store.reset(made);
  };
  const placing = {
    turn: 0,
    attempt: (_: string, action: (isCurrent: () => boolean) => Promise<void>) => action(() => true),
    place,
    replace: async () => false,
  };
  const built: BuildOptions[] = [];
  const models: Model[] = [];
  const pool = {
    survey: async () => ({ scale: 0.5, patch: 0.1 }),
    open: async (_: Model, { patch }: BuildOptions) => {
      if (patch < 0.4) throw new TooLarge('this would need 2 GB', room.times);
    },
    build: async ({ options, model, opened, tell }: BuildWish) => {
      built.push(options);
      if (room.why) throw new Error(room.why);
      await opened?.({ ...room.counts, warnings: room.warnings, work: room.work } as never);
      tell({ stage: 'casting', share: 0 });
      room.foreseen.push(store.lighting.peek()?.secondsForeseen);
      tell({ stage: 'casting', share: 0.1 });
      room.seen.push(`${store.lighting.peek()?.stage} ${store.lighting.peek()?.share}`);
      tell({ stage: 'writing', share: 0.9 });
      room.seen.push(`${store.lighting.peek()?.stage} ${store.lighting.peek()?.share}`);
      room.told = store.messages.peek().map(({ text }) => text);
      if (!options.draft && room.isFullTooLarge && options.patch < 0.2)
        throw new TooLarge('not enough memory');
      models.push(model);
      return { file: new ArrayBuffer(0), room: { source: '', warnings: [] } };
    },
  };
  const lighting = new Lighting(
    store,
    { layout: () => null, goOn: () => (room.resumed += 1) } as unknown as Solving,
    placing as unknown as Placing,
    rememberingShelf(),
    async () => pool as unknown as BuilderPool,
  );
  return { store, placed, room, built, models, lighting };
}

const card = (id: string, ...surfaces: string[]): Card => ({ id, surfaces, verb: 'illuminate', weight: 1 });
const named = (identity: string, xs: readonly number[], ...names: string[]): SceneInfo => ({
  ...sceneWith(identity, xs),
  surfaces: names.map((name) => ({ name, measuring: false })) as never,
});
const before = named('b'.repeat(16), [0, 1, 2], 'room/floor', 'room/ceiling', 'desk');
const after = named('a'.repeat(16), [0], 'room/floor', 'slab');

describe('a model that is understood in another way', () => {
  test('is still asked what it was asked, of surfaces that are left', () => {
    const cards = [
      card('c1', 'room/floor', 'desk'),
      card('c2', 'desk'),
      card('c3', 'room'),
      card('c4', 'all'),
    ];
    const fitted = fitting({ ...document, cards }, after, [card('new', 'slab')]);
    expect(fitted.cards).toEqual([card('c1', 'room/floor'), card('c3', 'room'), card('c4', 'all')]);
    expect(fitting({ ...document, cards: [card('c2', 'desk')] }, after, [card('new', 'slab')]).cards).toEqual(
      [card('new', 'slab')],
    );
    expect(fitting({ ...document, cards: [] }, after, [card('new', 'slab')]).cards).toEqual([]);
  });

  test('has no more luminaires than places', () => {
    const asking = startHistory({ ...document, luminaires: { ...document.luminaires, count: 2 } });
    const carried = carriedOver(asking, null, firstDisplay, before, after);
    expect(carried.document.luminaires).toMatchObject({ count: 1, pinned: [] });
  });

  test('keeps what was asked of the room that is on the screen, and no other', async () => {
    const { store, placed, room, built, lighting } = lightingOf(before);
    const model: Model = { name: 'a.glb', bytes: new Uint8Array(4), siblings: new Map() };
    await lighting.light(model);
    const wish = [card('mine', 'room/floor')];
    store.edit('Change', (each) => void (each.cards = structuredClone(wish) as never));
    room.next = after;
    await lighting.light(model, { ...usualChoices, ceiling: 2.5 });
    expect(placed[1]!.cards).toEqual(wish);
    expect(placed[1]!.scene).toBe(after.identity);
    await lighting.light({ ...model });
    expect(placed[2]!.cards).not.toEqual(wish);

    // The same bytes are understood as last time, which is said; others are not.
    expect(built.at(-1)).toMatchObject({ ceiling: 2.5, draft: false });
    expect(store.messages.value.map(({ text }) => text)).toEqual(['“a” is understood as it was last time.']);
    await lighting.light({ ...model, bytes: new Uint8Array(5) });
    expect(built.at(-1)?.ceiling).toBe(0);
  });

  test('a made room that is edited keeps what was asked of it, once', async () => {
    const { store, placed, room, lighting } = lightingOf(before);
    const made = (size: number): Model => ({
      name: 'a.glb',
      bytes: new Uint8Array(size),
      siblings: new Map(),
    });
    await lighting.light(made(4));
    const wish = [card('mine', 'room/floor')];
    store.edit('Change', (each) => void (each.cards = structuredClone(wish) as never));
    store.plan.value = {} as never;
    room.next = after;
    await lighting.light(made(5), undefined, { isEdited: true });
    expect(placed[1]).toMatchObject({ scene: after.identity, cards: wish });
    store.plan.value = null;
    await lighting.light(made(6));
    expect(placed[2]!.cards).not.toEqual(wish);
  });

  test('with a plane that was drawn is lit anew, and keeps its name and what was asked', async () => {
    const { store, placed, room, models, lighting } = lightingOf(before);
    const bytes = writeGlb({ asset: { version: '2.0' }, scenes: [{ nodes: [] }] }, null);
    const model: Model = { name: 'a.glb', bytes, siblings: new Map() };
    await lighting.light(model);
    expect(await lighting.hasModel()).toBe(true);
    const wish = [card('mine', 'room/floor')];
    store.edit('Change', (each) => void (each.cards = structuredClone(wish) as never));
    room.next = { ...before, identity: 'c'.repeat(16) };
    const outline = outlineOf([0, 0, 2, 1]);
    await lighting.light(model, {
      ...usualChoices,
      drawn: [{ name: 'plane 1', outline, height: 0.75, border: 0 }],
    });
    expect(models.slice(0, 2)).toEqual([model, model]); // a draft, and in full
    const { nodes } = JSON.parse(readContainer(models.at(-1)!.bytes).text);
    expect(nodes).toEqual([{ name: 'plane 1', mesh: 0, extras: { fiatlux: { measure: true, border: 0 } } }]);
    expect(placed[1]).toMatchObject({ room: 'a.flux', scene: 'c'.repeat(16), cards: wish });
  });
});

test('where memory runs out the preview stays, and larger patches are offered until they fit', async () => {
  const { store, placed, room, built, lighting } = lightingOf(draft);
  room.isFullTooLarge = true;
  const model: Model = { name: 'a.glb', bytes: new Uint8Array(4), siblings: new Map() };
  const lit = lighting.light(model);
  expect(store.lighting.value).toMatchObject({ stage: 'reading', fault: null }); // at once: no note of a stop
  await lit;
  expect(placed).toHaveLength(1);
  expect(store.lighting.value).toMatchObject({
    pass: 'full',
    fault: 'Not enough memory.',
    isTooLarge: true,
  });
  await lighting.coarser();
  expect(built.at(-1)?.patch).toBe(0.16);
  expect(store.lighting.value?.isTooLarge).toBe(true);
  await lighting.coarser();
  expect(built.at(-1)?.patch).toBe(0.26);
  expect(store.lighting.value).toBeNull();
});

test('a model that is too large for memory is refused before its draft is computed, until its patches are', async () => {
  const { store, placed, room, built, models, lighting } = lightingOf(draft);
  room.counts = { rows: 20_000, patchSize: 1 };
  const model: Model = { name: 'a.glb', bytes: new Uint8Array(4), siblings: new Map() };
  store.preview.value = 'a.glb';
  await lighting.light(model, { ...usualChoices, patch: 0.3 });
  expect([built.length, models, placed]).toEqual([1, [], []]);
  const fault = 'This would need 2 GB.';
  expect(store.lighting.value).toMatchObject({ pass: 'draft', fault, isTooLarge: true });
  await lighting.coarser();
  expect(models).toHaveLength(2);
  expect(store.lighting.value).toBeNull();
});

test('of patches that need many times the memory those are asked for at once that fit', async () => {
  const { store, room, built, models, lighting } = lightingOf(draft);
  room.counts = { rows: 20_000, patchSize: 1 };
  room.times = 16;
  const model: Model = { name: 'a.glb', bytes: new Uint8Array(4), siblings: new Map() };
  store.preview.value = 'a.glb';
  await lighting.light(model, { ...usualChoices, patch: 0.1 });
  await lighting.coarser();
  expect(built.at(-1)?.patch).toBe(0.46);
  expect(models).toHaveLength(2);
});

test('a room that is on the screen stays where it is too large in another way, and larger patches are offered', async () => {
  const { store, room, models, lighting } = lightingOf(draft);
  const model: Model = { name: 'a.glb', bytes: new Uint8Array(4), siblings: new Map() };
  await lighting.light(model, usualChoices);
  room.counts = { rows: 20_000, patchSize: 1 };
  await lighting.light(model, { ...usualChoices, patch: 0.3 });
  const message = store.messages.value.at(-1)!;
  expect(message).toMatchObject({ text: '“a.glb”: This would need 2 GB.' });
  message.action!.run();
  const end = Date.now() + 2000;
  while (models.length < 4 && Date.now() < end) await new Promise((resolve) => setTimeout(resolve));
  expect(models).toHaveLength(4);
});

test('what a draft foresees is beyond memory where the command says so, and no sample room is', () => {
  // By the builder: an office in patches of 5 cm needs 4.4 GB, a home 8.7; as they are 0.8.
  expect(isBeyondMemory({ rows: 9810, patchSize: 0.3 }, 0.05)).toBe(true);
  expect(isBeyondMemory({ rows: 12_049, patchSize: 0.3 }, 0.05)).toBe(true);
  expect(isBeyondMemory({ rows: 2243, patchSize: 0.73 }, 0)).toBe(false);
  expect(isBeyondMemory({ rows: 3021, patchSize: 0.62 }, 0)).toBe(false);
});

test('steps that follow closely are not each drawn, but stages are', async () => {
  const { room, lighting } = lightingOf(draft);
  await lighting.light({ name: 'a.glb', bytes: new Uint8Array(4), siblings: new Map() });
  expect(room.seen.slice(0, 2)).toEqual(['casting 0', 'writing 0.9']);
});

test('a draft whose full light was stopped goes on saying that it is one, until that is put away', async () => {
  const { store, lighting } = lightingOf(sceneWith('a'.repeat(16), [0, 1]));
  lighting.stop();
  expect(store.lighting.value).toBeNull();
  store.lighting.value = {
    name: 'a.glb',
    pass: 'draft',
    stage: 'casting',
    share: 0.2,
    secondsLeft: 3,
    fault: null,
  };
  lighting.stop();
  expect(store.lighting.value).toBeNull(); // nothing is there yet
  store.lighting.value = {
    name: 'a.glb',
    pass: 'full',
    stage: 'casting',
    share: 0.2,
    secondsLeft: 3,
    fault: null,
  };
  lighting.stop();
  expect(store.lighting.value).toMatchObject({ pass: 'full', fault: 'It was stopped.', secondsLeft: null });
  lighting.cancel();
  expect(store.lighting.value).toBeNull();
});

test('the work is foreseen about as long as sample rooms took', () => {
  const box = secondsForeseen({ work: 14 }, 4); // as the command's tests have it
  const office = secondsForeseen({ work: 167 }, 4);
  expect(box).toBeGreaterThan(4);
  expect(box).toBeLessThan(16);
  expect(office).toBeGreaterThan(45);
  expect(office).toBeLessThan(180);
});

test('the time left is told once something is known, and comes down', () => {
  const left = new TimeLeft(0);
  expect(left.at(0.01, 500)).toBeNull();
  const early = left.at(0.1, 2000);
  expect(early).toBeCloseTo(18);
  const later = left.at(0.9, 18_000);
  expect(later).toBeLessThan(early!);
  expect([0.3, 8, 23, 200].map(timeLeft)).toEqual(['1 s', '8 s', '25 s', '3 min']);
});

test('what is wrong with a model is known before anything is computed', async () => {
  const model: Model = { name: 'cut.glb', bytes: new Uint8Array(4), siblings: new Map() };
  const lightingOf = (survey: () => Promise<unknown>) =>
    new Lighting(
      new Store(),
      null as unknown as Solving,
      null as unknown as Placing,
      null as unknown as Shelf,
      async () => ({ survey }) as unknown as BuilderPool,
    );
  const broken = lightingOf(async () => {
    throw new Error('cut.glb: the GLB is cut off; export it again');
  });
  expect(await broken.faultOf(model)).toBe('cut.glb: the GLB is cut off; export it again');
  expect(await lightingOf(async () => ({})).faultOf(model)).toBeNull();
});

test('what is wrong with a room is told before it is computed, once', async () => {
  const { store, room, lighting } = lightingOf(draft);
  room.warnings = [
    'the ceiling is 9.2 m above the floor: is that so? --scale says how many metres a unit of the file has',
  ];
  await lighting.light({ name: 'a.glb', bytes: new Uint8Array(4), siblings: new Map() });
  expect(room.told).toEqual(['“a”: The ceiling is 9.2 m above the floor: is that so?']);
  expect(store.messages.peek()).toHaveLength(1);
});

test('what the sheet has told is not told once more', async () => {
  const { store, room, lighting } = lightingOf(draft);
  room.warnings = ['the room is open'];
  const model = { name: 'a.glb', bytes: new Uint8Array(4), siblings: new Map() };
  await lighting.light(model, usualChoices, { isTold: true });
  expect(store.messages.peek()).toEqual([]);
  await lighting.light(model, usualChoices);
  expect(store.messages.peek()).toHaveLength(1);
});

test('of several remarks one is said, and the sheet opens at all that were counted', async () => {
  const { store, room, lighting } = lightingOf(draft);
  room.warnings = ['the room is open', 'no mount is marked; choose with --mount', 'it is dark'];
  await lighting.light({ name: 'a.glb', bytes: new Uint8Array(4), siblings: new Map() });
  const [message, ...more] = store.messages.peek();
  expect(more).toEqual([]);
  expect(message).toMatchObject({ text: '“a”: The room is open.', action: { label: '2 more remarks' } });
  message!.action!.run();
  await new Promise((resolve) => setTimeout(resolve));
  expect(store.sheet.peek()).toMatchObject({ remarks: room.warnings, isAtRemarks: true });
  expect(store.messages.peek()).toEqual([]);
});

test('what was wrong with a room is not said of the next one', async () => {
  const { store, room, lighting } = lightingOf(draft);
  room.warnings = ['the room is open'];
  await lighting.light({ name: 'a.glb', bytes: new Uint8Array(4), siblings: new Map() });
  room.warnings = ['it has no floor'];
  await lighting.light({ name: 'b.glb', bytes: new Uint8Array(4), siblings: new Map() });
  expect(store.messages.peek().map(({ text }) => text)).toEqual(['“b”: It has no floor.']);
});

test('how long a room takes is told as it begins, of either pass', async () => {
  const { room, lighting } = lightingOf(draft);
  room.work = 900;
  await lighting.light({ name: 'a.glb', bytes: new Uint8Array(4), siblings: new Map() });
  expect(room.foreseen).toEqual([secondsForeseen({ work: 900 }), secondsForeseen({ work: 900 })]);
  expect(room.foreseen[0]).toBeGreaterThan(long);
});

test('a model that can be neither shown nor lit is refused in a message that names it', async () => {
  const { store, room, lighting } = lightingOf(draft);
  const model: Model = { name: 'alone.gltf', bytes: new Uint8Array(4), siblings: new Map() };
  for (const why of ["alone.gltf: buffer 0 names 'room.bin', which is not beside it", 'not enough memory']) {
    room.why = why;
    await lighting.light(model);
    expect(store.lighting.value).toBeNull();
  }
  expect(store.messages.peek().map(({ text }) => text)).toEqual([
    "alone.gltf: buffer 0 names 'room.bin', which is not beside it",
    '“alone.gltf”: Not enough memory.',
  ]);
  expect(room.resumed).toBe(2);
  store.preview.value = 'alone.gltf'; // what is shown has its own note
  await lighting.light(model);
  expect(store.lighting.value?.fault).toBe('Not enough memory.');
});

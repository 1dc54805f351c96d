// All of a room or nothing of it, and the latest wish wins. Covers placing.
import { expect, test } from '@jest/globals';
import { Placing } from '../../../../web/app/opening/placing.ts';
import { firstDisplay, Store } from '../../../../web/app/state/store.ts';
import type { Display, SceneInfo } from '../../../../web/document/types.ts';

type Parts = ConstructorParameters<typeof Placing>;

test('a room whose document is still being made does not come over a model that was dropped meanwhile', async () => {
  const told: string[] = [];
  const scene = { surfaces: [] } as unknown as SceneInfo;
  const viewer = {
    setAims: () => void told.push('aims'),
    open: async () => void told.push('room'),
    preview: async () => void told.push('preview'),
  } as unknown as Parts[3];
  const solving = {
    layout: () => null,
    open: async () => ({ scene, room: new ArrayBuffer(0) }),
  } as unknown as Parts[2];
  const keeping = { remember: () => {} } as unknown as Parts[4];
  const rooms = { has: () => false } as unknown as Parts[1];
  const placing = new Placing(new Store(), rooms, solving, viewer, keeping, {} as Parts[5]);
  let [begin, finish] = [() => {}, () => {}];
  const isBegun = new Promise<void>((resolve) => (begin = resolve));
  const isMade = new Promise<void>((resolve) => (finish = resolve));
  const opening = placing.attempt('room', (isCurrent) =>
    placing.place(new ArrayBuffer(0), 'room', isCurrent, async () => {
      begin();
      await isMade; // luminaire files on a slow line
      return { document: { cards: [] } } as never;
    }),
  );
  await isBegun;
  await placing.attempt('model', async () => viewer.preview(new ArrayBuffer(0)));
  finish();
  await opening;
  expect(told).toEqual(['preview']);
});

test('a building opens at the storey that is asked about, unless somebody cut it otherwise', async () => {
  const scene = { surfaces: [] } as unknown as SceneInfo;
  const document = { cards: [], scene: 'building', room: 'building', quantity: 'illuminance' };
  const opened = async (view?: { display: Display }, meanwhile?: number) => {
    const store = new Store();
    const viewer = {
      setAims: () => {},
      open: async () => {},
      colors: async () => null,
      home: () => {},
      openingCut: async () => {
        if (meanwhile !== undefined) store.display.value = { ...store.display.peek(), section: meanwhile };
        return 1.5;
      },
    } as unknown as Parts[3];
    const solving = { layout: () => null, open: async () => ({ scene, room: new ArrayBuffer(0) }) };
    const types = { provide: () => {}, findMissing: async () => {} };
    const placing = new Placing(
      store,
      { has: () => false } as unknown as Parts[1],
      solving as unknown as Parts[2],
      viewer,
      { remember: () => {} } as unknown as Parts[4],
      types as unknown as Parts[5],
    );
    const placement = { document, ...(view && { view: { camera: null, ...view } }) };
    await placing.place(
      new ArrayBuffer(0),
      'building',
      () => true,
      () => placement as never,
    );
    await Promise.resolve();
    return store.display.peek().section;
  };
  expect(await opened()).toBe(1.5);
  expect(await opened({ display: firstDisplay })).toBeUndefined(); // a link shows what its sender saw
  expect(await opened(undefined, 4.5)).toBe(4.5);
});

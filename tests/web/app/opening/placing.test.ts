// All of a room or nothing of it, and the latest wish wins. Covers placing.
import { expect, test } from '@jest/globals';
import { Placing } from '../../../../web/app/opening/placing.ts';
import { Store } from '../../../../web/app/state/store.ts';
import type { SceneInfo } from '../../../../web/document/types.ts';

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

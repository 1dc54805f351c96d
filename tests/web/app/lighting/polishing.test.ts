/** Exact light takes the place of what is shown by groups of patches, and of nothing else. */
import { expect, test } from '@jest/globals';
import type { HungLuminaires } from '../../../../web/builder/builder.ts';
import type { Owner } from '../../../../web/builder/pool.ts';
import type { FiatLuxDocument, Layout, LuminaireType, SceneInfo } from '../../../../web/document/types.ts';
import { hungOf, Polishing } from '../../../../web/app/lighting/polishing.ts';
import { askedOfUnknown, documentFrom } from '../../../../web/app/rooms/opening-wish.ts';
import { Store, type Progress } from '../../../../web/app/state/store.ts';
import type { Shown } from '../../../../web/solver/protocol.ts';

const spot = { id: 't1', hash: 'h', flux: 900, tilt: 0, turns: [0], aims: [] } as unknown as LuminaireType;
const position = new Float32Array([0, 2.5, 0, 1, 2.5, 0]);
const sites = { position, size: new Float32Array([0.4, 0.4]), normal: position, axis: position };
const scene = { identity: 'a', surfaces: [], sites } as unknown as SceneInfo;
const layoutOf = (type: string): Layout => ({
  sites: [1],
  flux: [900],
  dimming: 1,
  mountings: [{ type, turn: 90, aim: null }],
});
const shownOf = (layout: Layout) => ({ layout }) as Shown;
const state = (name: Progress['state']): Progress => ({ state: name, evaluations: 1, milliseconds: 1 });
const pause = () => new Promise((resolve) => setTimeout(resolve));

/** A room with one type, whose builder answers when it is told to. */
function polished(bytes = 1e6) {
  const store = new Store();
  const asked = askedOfUnknown([], 2);
  const luminaires = { ...asked.luminaires, types: [spot] };
  const document: FiatLuxDocument = { ...documentFrom({ ...asked, luminaires }, 'a', 'a.flux') };
  store.scene.value = scene;
  store.reset(document);
  const lit: HungLuminaires[] = [];
  const log = { isEnded: false, polished: [] as Shown[], answer: () => {} };
  const owner: Owner = {
    bytes,
    light: (luminaires) => {
      lit.push(luminaires);
      return new Promise((resolve) => (log.answer = () => resolve(new Float32Array(4))));
    },
    end: () => void (log.isEnded = true),
  };
  const solving = {
    fileOf: (hash: string) => (hash === 'h' ? new Uint8Array(1) : undefined),
    polish: async (shown: Shown, _: Float32Array, held: number) => {
      if (store.shown.peek() !== shown) return false;
      log.polished.push(shown);
      const exact = { ...shown };
      store.exact.value = { shown: exact, bytes: held };
      store.shown.value = exact;
      return true;
    },
  };
  const polishing = new Polishing(store, solving);
  polishing.own(owner);
  return { store, lit, log, polishing, document };
}

test('a layout that has settled is lit exactly, once', async () => {
  const { store, lit, log } = polished();
  store.shown.value = shownOf(layoutOf('t1'));
  store.progress.value = state('improving');
  await pause();
  expect(lit).toEqual([]);
  store.progress.value = state('settled');
  await pause();
  expect(lit).toHaveLength(1);
  expect([...lit[0]!.hung]).toEqual([1, 0, 900, 90, Number.NaN, Number.NaN, Number.NaN]);
  log.answer();
  await pause();
  expect(log.polished).toHaveLength(1);
  expect(store.exact.peek()).toEqual({ shown: store.shown.peek(), bytes: 1e6 });
  expect(lit).toHaveLength(1);
});

test('of what was shown meanwhile the latest is lit', async () => {
  const { store, lit, log } = polished();
  store.progress.value = state('shown');
  store.shown.value = shownOf(layoutOf('t1'));
  await pause();
  store.shown.value = shownOf(layoutOf('t1'));
  const latest = shownOf(layoutOf('t1'));
  store.shown.value = latest;
  log.answer();
  await pause();
  expect(log.polished).toEqual([]);
  expect(lit).toHaveLength(2);
  log.answer();
  await pause();
  expect(log.polished).toEqual([latest]);
});

test('squares, painted rooms and direct light alone are left as they are', async () => {
  const { store, lit } = polished();
  store.progress.value = state('settled');
  store.shown.value = shownOf({ sites: [1], flux: [900], dimming: 1 });
  await pause();
  store.edit('Paint', (draft) => void (draft.paint = [{ surface: 'floor', reflectance: 0.5 }] as never));
  store.shown.value = shownOf(layoutOf('t1'));
  await pause();
  expect(lit).toEqual([]);
  expect(hungOf(layoutOf('another'), [spot], scene, () => new Uint8Array())).toBeNull();
  expect(hungOf(layoutOf('t1'), [spot], scene, () => undefined)).toBeNull();
});

test('whoever made the room is let go with it, or where it holds too much', async () => {
  const { store, log } = polished();
  store.scene.value = { ...scene, identity: 'b' };
  await pause();
  expect(log.isEnded).toBe(true);
  expect(polished(2e9).log.isEnded).toBe(true);
});

/** What is carried over from a draft to the full room, and how the time left is told. */
import { describe, expect, test } from '@jest/globals';
import { startHistory, edit } from '../../../web/document/history.ts';
import type { FiatLuxDocument, SceneInfo } from '../../../web/document/types.ts';
import type { BuilderPool } from '../../../web/builder/pool.ts';
import type { Model } from '../../../web/builder/protocol.ts';
import { Lighting, type Shelf } from '../../../web/app/lighting/lighting.ts';
import type { Placing } from '../../../web/app/opening/placing.ts';
import type { Solving } from '../../../web/app/solving.ts';
import { firstDisplay, Store } from '../../../web/app/state/store.ts';
import { areSameSites, carriedOver } from '../../../web/app/lighting/carried-over.ts';
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

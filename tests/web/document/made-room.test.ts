// A made room in files and links: its plan comes back, and what is none is refused.
import { describe, expect, test } from '@jest/globals';
import { planOfGlb, planOfScene, type PackedPlan } from '../../../web/document/made-room.ts';
import { decodeLink, encodeLink, fitLink, longestLink, type Link } from '../../../web/document/share-link.ts';
import { glbOf } from '../../../web/room-maker/make-room.mjs';
import { canonicalPlan, packedPlan, planIdentity, unpackedPlan } from '../../../web/room-maker/plan-code.mjs';
import { outlines } from '../../../web/room-maker/plan-shapes.mjs';
import {
  itemKinds,
  planOf,
  usualItem,
  usualOpening,
  type RoomPlan,
} from '../../../web/room-maker/room-plan.mjs';

/** A room of 20 objects that share nothing: the longest case. */
function studio(): RoomPlan {
  const plan = planOf(outlines.U(11.3, 8.7, 3.1, 4.2), 3.15, 'Studio');
  return {
    ...plan,
    openings: [
      usualOpening('door', 7, 1.237),
      usualOpening('window', 0, 2.345),
      usualOpening('window', 0, 5.1),
    ],
    items: Array.from({ length: 20 }, (_, i) => {
      const at = [Number((0.7 + 0.517 * i).toFixed(3)), Number((1 + ((i * 1.237) % 3)).toFixed(3))] as const;
      return usualItem(itemKinds[i % itemKinds.length]!, at, 3.15, (i * 37.5) % 360);
    }),
    mount: { ...plan.mount, kind: 'tiles', origin: [0.13, 0.27], turn: 12.5 },
  };
}

const link: Link = {
  scene: '0123456789abcdef',
  room: 'Studio.glb',
  cards: [{ id: 'c-first', surfaces: ['working plane'], verb: 'illuminate', weight: 1, aim: 500 }],
  saving: false,
  luminaires: { count: 12, flux: 3000, dimming: [1, 1], excluded: [], minDistance: 0 },
  quantity: 'illuminance',
  seed: 1,
  layout: {
    positions: Array.from({ length: 12 }, (_, i) => [0.9 + 0.6 * (i % 4) * 2, 3.15, 0.9 + 1.2 * Math.floor(i / 4)] as const), // prettier-ignore
    flux: Array.from({ length: 12 }, () => 3000),
    dimming: 1,
    pinned: [],
  },
  plan: packedPlan(studio()),
  camera: { position: [10, 8, 12], target: [2, 1, 4], plan: false },
  display: null,
};

describe('a link with a made room', () => {
  test('holds the room of 20 objects, and whoever opens it makes the very same', () => {
    const hash = encodeLink(link);
    expect(hash.length).toBeLessThan(longestLink);
    const decoded = decodeLink(hash);
    expect(decoded).toEqual({ ok: true, link });
    const { plan } = unpackedPlan(decoded.ok && decoded.link.plan);
    expect(plan).toEqual(canonicalPlan(studio()));
    expect(planIdentity(plan!, {}, '5')).toBe(planIdentity(studio(), {}, '5'));
  });

  test.each<[string, unknown]>([
    ['10 000 objects', (packedPlan(studio()) as unknown[]).map((part, i) => (i === 6 ? Array(70_000).fill(1) : part))],
    ['NaN', (packedPlan(studio()) as unknown[]).map((part, i) => (i === 3 ? [NaN, 0, 1, 1, 0, 1] : part))],
    ['a text', 'room'],
    ['nothing', []],
  ])('is refused with %s in it', (_, plan) => {
    const encoded = () => fitLink({ ...link, plan: plan as PackedPlan }).hash;
    let hash = '';
    try {
      hash = encoded();
    } catch (error) {
      expect(String(error)).toMatch(/more than a link can carry/);
      return;
    }
    expect(decodeLink(hash)).toMatchObject({ ok: false, message: expect.stringMatching(/cannot be read/) });
  }); // prettier-ignore
});

test('a made room carries its plan, and other files carry none', async () => {
  const bytes = await glbOf(canonicalPlan(studio()));
  expect(planOfGlb(bytes.slice().buffer)).toEqual(packedPlan(studio()));
  expect(planOfGlb(bytes.slice(0, 3000).buffer)).toBeNull();
  expect(planOfGlb(new ArrayBuffer(0))).toBeNull();
});

test('a scene tells the plan of its room, if that was made here', () => {
  const plan = packedPlan(studio());
  expect(planOfScene({ provenance: { plan } })).toEqual(plan);
  for (const provenance of [null, 'text', {}, { plan: 'text' }, { plan: [] }, { plan: [1, 'x', [0.5]] }])
    expect(planOfScene({ provenance })).toBeNull();
});

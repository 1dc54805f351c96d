/** Between sites and positions, and documents as links (linked-document.ts). */
import { describe, expect, test } from '@jest/globals';
import { sampleDocument } from '../sample-rooms.ts';
import { decodeLink, encodeLink } from '../../../web/document/share-link.ts';
import { variantOf } from '../../../web/document/variants.ts';
import { documentOf, linkOf } from '../../../web/document/linked-document.ts';
import { nearestSite } from '../../../web/document/sites.ts';
import { fakeScene } from '../fake-solver.ts';

const scene = fakeScene();

const layout = { sites: [0, 5], flux: [1200, 600], dimming: 0.5 };

const asked = sampleDocument(scene.identity, 'box');
const document = { ...asked, luminaires: { ...asked.luminaires, count: 2, pinned: [5], excluded: [7] } };

test('the layout of a kept variant goes along, judged by what the link asks', () => {
  const other = { sites: [3], flux: [900], dimming: 1 };
  const kept = { ...document, kept: variantOf({ ...document, seed: 99 }, other) };
  const both = linkOf(kept, layout, scene.sites, { camera: null, display: null });
  expect(documentOf(both, scene, true)).toMatchObject({
    layout,
    kept: { layout: other, seed: document.seed, luminaires: { count: 1, pinned: [] } },
  });
  const decoded = decodeLink(encodeLink(both));
  expect(decoded).toEqual({ ok: true, link: both });
  const foreign = { ...other, mountings: [{ type: 'gone', turn: 0, aim: null }] };
  const unknown = { ...document, kept: variantOf(document, foreign) };
  expect(linkOf(unknown, layout, scene.sites, { camera: null, display: null }).kept).toBeUndefined();
});

test('paint and what energy is reckoned by go along', () => {
  const paint = [{ surface: 'wall', reflectance: 0.3 }];
  const energy = { efficacy: 95, daylight: 0.7 };
  const link = linkOf({ ...document, paint, energy }, layout, scene.sites, { camera: null, display: null });
  expect(documentOf(link, scene, true)).toMatchObject({ paint, energy });
});

describe('positions and sites', () => {
  const link = linkOf(document, layout, scene.sites, { camera: null, display: null });

  test('a layout survives as positions', () => {
    expect(link.layout?.positions).toEqual([
      [0, 3, 0],
      [1, 3, 1],
    ]);
    expect(link.layout?.pinned).toEqual([1]);
    expect(documentOf(link, scene, true)).toEqual({ ...document, layout });
  });

  test('a light outside the sites is named', () => {
    const lost = {
      ...link,
      layout: {
        ...link.layout!,
        positions: [
          [0, 3, 0],
          [9, 9, 9],
        ] as [number, number, number][],
      },
    };
    expect(documentOf(lost, scene, true)).toMatch(/L2/);
    expect(documentOf(lost, scene, false)).toMatchObject({ layout: { sites: [0, 15] } });
  });

  test('two lights at one place are refused, in another version of the room dropped', () => {
    const twice = {
      ...link,
      layout: {
        ...link.layout!,
        positions: [
          [0, 3, 0],
          [0, 3, 0.1],
        ] as [number, number, number][],
      },
    };
    expect(documentOf(twice, scene, true)).toMatch(/same place/);
    expect(documentOf(twice, scene, false)).toMatchObject({ layout: { sites: [0], flux: [1200] } });
  });

  test('mountings stay with their luminaires, also where one of them is dropped', () => {
    const mountings = [
      { type: 'a', turn: 0, aim: null },
      { type: 'b', turn: 90, aim: [1, 2, 3] as const },
    ];
    const typed = linkOf(document, { ...layout, mountings }, scene.sites, { camera: null, display: null });
    expect(documentOf(typed, scene, true)).toMatchObject({ layout: { mountings } });
    const [, second] = typed.layout!.positions;
    const other = {
      ...typed,
      layout: {
        ...typed.layout!,
        positions: [second!, second!, [2, 3, 2] as const],
        flux: [1, 2, 3],
        pinned: [2],
        mountings: [mountings[0]!, mountings[0]!, mountings[1]!],
      },
    };
    expect(documentOf(other, scene, false)).toMatchObject({
      layout: { sites: [5, 10], flux: [1, 3], mountings },
      luminaires: { pinned: [10] },
    });
  });

  test('nearest site', () => {
    expect(nearestSite(scene.sites, [2.2, 3, 0.9])).toEqual({
      site: 6,
      distance: expect.closeTo(Math.hypot(0.2, 0.1)),
    });
  });
});

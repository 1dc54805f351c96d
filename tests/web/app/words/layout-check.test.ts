// What "Check this layout" and "About this room" say.
import { describe, expect, test } from '@jest/globals';
import { Store } from '../../../../web/app/state/store.ts';
import { checkText, marginText } from '../../../../web/app/words/layout-check.ts';
import {
  hiddenAreas,
  patchSize,
  readProvenance,
  roomFacts,
  roomWarnings,
} from '../../../../web/app/words/provenance.ts';
import { intentionsOf } from '../../../../web/document/intentions.ts';
import { fakeScene } from '../../fake-solver.ts';

describe('the check', () => {
  const first = new Store().document.value;
  const card = {
    id: 'a',
    surfaces: ['floor'],
    verb: 'homogenize',
    weight: 1,
    mean: { min: 100, max: 200 },
  } as const;
  const document = { ...first, quantity: 'illuminance', cards: [card] } as const;
  const { origins } = intentionsOf(document);
  const checked = (...margins: number[]) =>
    checkText(
      {
        layout: { sites: [], flux: [], dimming: 1 },
        largestDifference: 2.34e-5,
        surface: 'floor',
        margins: margins.map((margin, constraint) => ({ constraint, margin })),
      },
      document,
      origins,
    );

  test('tells the largest difference and where', () => {
    expect(checked()).toMatch(/at most 0\.0023 % \(“floor”\)\.$/);
  });
  test('names the bounds with little to spare, the worst first', () => {
    expect(checked(0.01, -0.05)).toMatch(
      /Little margin: floor: mean at most 200 lx, 5\.0 % over; floor: mean at least 100 lx, 1\.0 % to spare\.$/,
    );
  });
  test('says so where every bound has room', () => {
    expect(checked(0.3, 0.12)).toMatch(/met with 12 % or more to spare/);
  });
  test('margins read as words', () => {
    expect([0, 0.004, -0.2].map((margin) => marginText(margin))).toEqual([
      'met exactly',
      '0.4 % to spare',
      '20 % short',
    ]);
    expect(marginText(-0.2, { isMost: true })).toBe('20 % over');
    expect(marginText(-0.0004, { isMost: true, isMet: true })).toBe('within 0.04 %');
  });
});

describe('the room', () => {
  const scene = {
    ...fakeScene(),
    provenance: {
      patchSize: 0.1875,
      options: { rays: 1024, refine: 24 }, // at most
      residuals: [0.05, 0.007, 0.0012],
      lost: 0.02,
      warnings: ['no mount is marked'],
      fewPatches: ['floor', 'wall'],
      errors: { mean: 1e-9, sigma: 'damaged' },
    },
  };

  test('tells its sizes, rays and what is left over, and leaves out what it cannot read', () => {
    const facts = new Map(roomFacts(scene));
    expect(facts.get('Patches')).toBe('16 of 0.19 m');
    expect(facts.get('Rays from each patch')).toMatch(/1.024, refined 2 times/);
    expect(facts.get('Reflected light left out')).toBe('0.12 %');
    expect(facts.get('Light lost')).toBe('2 %');
    expect(facts.get('Spread uncertain by over 1 %, of few patches')).toBe('floor, wall');
    expect([...facts.keys()].some((name) => name.startsWith('Changed'))).toBe(false);
  });
  test('tells warnings, and surfaces that lose more than a hundredth of their light', () => {
    const [floor, wall] = scene.surfaces.map((surface, s) => ({ ...surface, lost: [0.008, 0.3][s] ?? 0 }));
    expect(roomWarnings({ ...scene, surfaces: [floor!, wall!] })).toEqual([
      'no mount is marked',
      expect.stringMatching(/^30 % .*“wall”/),
    ]);
  });
  test('tells how much of which surface is hidden and in no figure', () => {
    expect(hiddenAreas(scene)).toEqual([]);
    expect(new Map(roomFacts(scene)).has('Hidden, in no figure')).toBe(false);
    const [first, ...others] = scene.surfaceOfPatch;
    const covered = Uint8Array.from([first, ...others], (surface, row) =>
      Number(surface === first && row < 2),
    );
    const hidden = { ...scene, patchCovered: covered };
    const { name } = scene.surfaces[first!]!;
    expect(hiddenAreas(hidden)).toEqual([{ name, area: scene.patchArea[0]! + scene.patchArea[1]! }]);
    expect(new Map(roomFacts(hidden)).get('Hidden, in no figure')).toBe(`${name} 2 m²`);
    // What is less than a hundredth of it is counted and not named.
    const other = scene.surfaceOfPatch.findIndex((surface) => surface !== first);
    const patchArea = scene.patchArea.map((area, row) => (row === other ? 0.01 : area));
    const more = {
      ...hidden,
      patchArea,
      patchCovered: covered.map((is, row) => Number(is || row === other)),
    };
    expect(new Map(roomFacts(more)).get('Hidden, in no figure')).toBe(`${name} 2 m², 1 more`);
  });
  test('without a word on how it was made has the patches that it has', () => {
    for (const provenance of [null, 'x', [], {}, { patchSize: -1 }, { patchSize: NaN }]) {
      expect(patchSize({ ...scene, provenance })).toBeCloseTo(1);
      expect(roomWarnings({ ...scene, provenance })).toEqual([]);
    }
    expect(readProvenance({ warnings: [1], lost: 0.5 })).toEqual({ lost: 0.5 });
  });
});

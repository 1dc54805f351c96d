/** What a row of the verdict has to spare, as it is read. */
import { expect, test } from '@jest/globals';
import { singlesText, spareText, verdicts, type Verdict } from '../../../../web/app/words/verdict.ts';
import { glareVerdict } from '../../../../web/app/words/glare.ts';
import { intentionsOf } from '../../../../web/document/intentions.ts';
import { Store } from '../../../../web/app/state/store.ts';
import type { Card } from '../../../../web/document/types.ts';
import type { ObserverResult } from '../../../../web/solver/protocol.ts';
import { fakeScene, fakeShown } from '../../fake-solver.ts';

const row = (margin: number | null): Verdict => ({
  where: 'plane',
  what: 'mean',
  target: 500,
  actual: 550,
  unit: 'lx',
  margin,
  met: true,
});

const seen = (ugr: number) => glareVerdict([{ name: 'P1', ugr } as ObserverResult], 19);

test('light has a share to spare, glare as many units as its figures differ by', () => {
  expect(spareText(row(0.1))).toBe('10 % to spare');
  expect(spareText(row(null))).toBeNull();
  const missed = { ...row(-0.1), met: false };
  expect(spareText(missed)).toBe('10 % short');
  expect(spareText({ ...missed, isMost: true })).toBe('10 % over');
  expect(spareText({ ...row(-0.0005), isMost: true })).toBe('within 0.05 %'); // counts as met
  expect(spareText(seen(18.64))).toBe('0.4 to spare');
  expect(spareText(seen(19.62))).toBe('0.6 over');
  expect(spareText(seen(19.04))).toBe(spareText(row(0)));
});

test('what nothing is to be read of, or nobody has computed, has nothing to spare', () => {
  expect(spareText(seen(8))).toBeNull();
  expect(spareText(glareVerdict([], 19))).toBeNull();
});

test('a row of several surfaces tells what they have one by one', () => {
  const scene = fakeScene();
  const layout = { sites: [0], flux: [900], dimming: 1 };
  const rowsOf = (asked: Partial<Card>) => {
    const card: Card = { id: 'c', surfaces: ['floor', 'wall'], verb: 'illuminate', weight: 1, ...asked };
    const document = { ...new Store().document.value, cards: [card], quantity: 'illuminance' } as const;
    const traced = intentionsOf(document);
    return verdicts(document, traced, fakeShown(scene, layout, traced.intentions), scene);
  };
  const [floor, wall] = fakeShown(
    scene,
    layout,
    intentionsOf(new Store().document.value).intentions,
  ).surfaces;
  const inOrder = (...ends: number[]) => ends.sort((a, b) => a - b);
  const bounds = rowsOf({
    verb: 'keep',
    mean: { max: 60 },
    uniformity: 0.5,
    guarantee: { by: 'chebyshev', alpha: 1, min: 1 },
  });
  const below = [floor!, wall!].map(({ mean, sigma }) => mean - sigma);
  expect(bounds.map(({ each }) => each)).toEqual([
    inOrder(floor!.mean, wall!.mean),
    inOrder(...below),
    inOrder(floor!.min / floor!.mean, wall!.min / wall!.mean),
  ]);
  expect(rowsOf({ aim: 40 })[0]!.each).toEqual(inOrder(floor!.mean, wall!.mean));
  expect(rowsOf({ verb: 'homogenize' })[0]!.each).toEqual(inOrder(floor!.sigma, wall!.sigma));
  expect(singlesText({ ...row(0), each: [118.2, 177.4] })).toBe('118 to 177 each');
  expect(singlesText({ ...row(0), each: [0.31, 0.62], unit: '' })).toBe('0.31 to 0.62 each');
  expect(singlesText({ ...row(0), each: [150.1, 150.2] })).toBeNull();
  for (const surfaces of [['floor'], ['all']]) expect(rowsOf({ surfaces, aim: 40 })[0]!.each).toBeUndefined();
});

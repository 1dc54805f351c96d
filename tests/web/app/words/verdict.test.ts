/** What a row of the verdict has to spare, as it is read. */
import { expect, test } from '@jest/globals';
import { spareText, type Verdict } from '../../../../web/app/words/verdict.ts';
import { glareVerdict } from '../../../../web/app/words/glare.ts';
import type { ObserverResult } from '../../../../web/solver/protocol.ts';

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
  expect(spareText(row(-0.1))).toBe('10 % short');
  expect(spareText({ ...row(-0.1), isMost: true })).toBe('10 % over');
  expect(spareText(seen(18.64))).toBe('0.4 to spare');
  expect(spareText(seen(19.62))).toBe('0.6 over');
  expect(spareText(seen(19.04))).toBe(spareText(row(0)));
});

test('what nothing is to be read of, or nobody has computed, has nothing to spare', () => {
  expect(spareText(seen(8))).toBeNull();
  expect(spareText(glareVerdict([], 19))).toBeNull();
});

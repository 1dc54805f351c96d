/** Numbers as people read them. */
import { afterEach, expect, test } from '@jest/globals';
import {
  compact,
  duration,
  easedBound,
  niceCeiling,
  niceStep,
  percent,
  percentAtMost,
  ratio,
  sentence,
  shortName,
  tabular,
} from '../../../../web/app/words/format.ts';
import { speak } from '../../../../web/language/language.ts';

afterEach(() => speak('en'));

test('a proved gap is never told smaller than it is', () => {
  expect([0, 0.0001, 0.0084, 0.05, 0.0992, 0.0996, 0.189].map(percentAtMost)).toEqual([
    '0.0 %',
    '0.1 %',
    '0.9 %',
    '5.0 %',
    '10.0 %',
    '10 %',
    '19 %',
  ]);
});

test('a contrast against darkness is infinite, one of darkness against darkness none', () => {
  expect([0.4, 12, 5 / 0, 0 / 0].map(ratio)).toEqual(['0.40', '12.00', '∞', '–']);
});

test('times in the unit that keeps them short', () => {
  expect([0.84, 42.4, 999.4, 2818].map(duration)).toEqual(['0.8 ms', '42 ms', '999 ms', '2.8 s']);
});

test('numbers in three digits, on round scales', () => {
  expect([0, 0.0123, 1.234, 12.34, 123.4, 1234.5].map(compact)).toEqual([
    '0',
    '0.0123',
    '1.23',
    '12.3',
    '123',
    '1\u202f235',
  ]);
  expect([0, 0.0004, 0.0979, 0.996, 1.03, 606].map(tabular)).toEqual([
    '0',
    '< 0.01',
    '0.10',
    '1.00',
    '1.03',
    '606',
  ]);
  expect([0, 0.0004, 0.052, 0.5, 1].map(percent)).toEqual(['0.0 %', '< 0.1 %', '5.2 %', '50 %', '100 %']);
  expect([0.7, 1, 12, 130, 999].map(niceCeiling)).toEqual([0.8, 1, 15, 150, 1000]);
  expect([200, 1000, 30].map(niceStep)).toEqual([1, 5, 0.2]);
});

test('an eased bound can be met by what is reached', () => {
  for (const value of [0.123456, 9.999, 285.3, 1234.5, 31.4159]) {
    expect(easedBound(value, 'min')).toBeLessThan(value);
    expect(easedBound(value, 'max')).toBeGreaterThan(value);
    expect(easedBound(value, 'min')).toBeGreaterThan(value * 0.985);
    expect(easedBound(value, 'max')).toBeLessThan(value * 1.015);
  }
});

test('a sentence begins with a capital, but the name of a file is left as it is', () => {
  expect(sentence('no connection')).toBe('No connection.');
  expect(sentence('my hall.glb: that is no model')).toBe('my hall.glb: that is no model.');
});

test('a long name is cut within a sentence, whole characters at a time', () => {
  expect(shortName('my room')).toBe('my room');
  expect(shortName('🏠'.repeat(40))).toBe('🏠'.repeat(40));
  expect(shortName('🏠'.repeat(41))).toBe(`${'🏠'.repeat(39)}…`);
});

/** What is typed into a number field. */
import { expect, test } from '@jest/globals';
import { readNumber, remarkOn } from '../../../../web/panel/controls/number-field.tsx';

test('numbers are read as people write them, with their unit or without', () => {
  expect(['1.250,5', '1,250.5', "1'250.5", '1.000.000,', '1,5.5'].map((text) => readNumber(text))).toEqual([
    1250.5,
    1250.5,
    1250.5,
    1e6,
    null,
  ]);
  expect(['300 lx', '300lx', '300 m', 'lx'].map((text) => readNumber(text, 'lx'))).toEqual([
    300,
    300,
    null,
    null,
  ]);
  expect(['1 250,5', '.5', '-3', '1e3', '', 'abc', '1.2.3'].map((text) => readNumber(text))).toEqual([
    1250.5,
    0.5,
    -3,
    null,
    null,
    null,
    null,
  ]);
});

test('three digits behind a comma or a point are thousands where the locale has the other sign', () => {
  const english = (text: string) => readNumber(text, 'lx', '.');
  const german = (text: string) => readNumber(text, 'lx', ',');
  expect(['1,250', '1.250', '1,250 lx', '0,250', '1,25', '1,250,000'].map(english)).toEqual([
    1250, 1.25, 1250, 0.25, 1.25, 1250000,
  ]);
  expect(['1,250', '1.250', '0.250', '12.500'].map(german)).toEqual([1.25, 1250, 0.25, 12500]);
});

test('what was read unexpectedly, or cut, is told', () => {
  expect(remarkOn('1,250', 'lx', [0, 1e7])).toBe('Read as 1\u202f250'); // tests run in English
  expect(remarkOn('1,25', 'lx', [0, 1e7])).toBeNull();
  expect(remarkOn('99', '', [1, 60])).toBe('At most 60');
  expect(remarkOn('2', '', [4, 60])).toBe('At least 4');
  expect(remarkOn('2', '', [4, 60], 'No fewer: 4 are pinned.')).toBe('No fewer: 4 are pinned.');
  expect(remarkOn('-5', '', [0, 60])).toBe('At least 0');
});

test('what is no number is told, what is empty is not', () => {
  for (const text of ['abc', 'NaN', '1e9', '-', '300 m'])
    expect(remarkOn(text, 'lx', [0, 60])).toBe('Not a plain number');
  expect(remarkOn(' ', 'lx', [0, 60])).toBeNull();
});

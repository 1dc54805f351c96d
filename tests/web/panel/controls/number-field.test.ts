/** What is typed into a number field. */
import { expect, test } from '@jest/globals';
import { readNumber } from '../../../../web/panel/controls/number-field.tsx';

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

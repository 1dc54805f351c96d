/** The select of the axis offers the same ways in both languages, in the words of each. */
import { afterEach, expect, test } from '@jest/globals';
import { speak } from '../../../../web/language/language.ts';
import { axesOf } from '../../../../web/panel/luminaires/arrangement-choice.tsx';

const wide = [0, 3, 0, 6, 3, 0, 0, 3, 2]; // places, xyz each: further along x than along z
const deep = [0, 3, 0, 2, 3, 0, 0, 3, 6];

afterEach(() => speak('en'));

test.each([
  ['symmetric', wide, ['found', 'x', 'z', 'both']],
  ['symmetric', deep, ['found', 'z', 'x', 'both']],
  ['field', wide, ['found', 'x', 'z', 'both']],
  ['rows', wide, ['found', 'x', 'z']],
  ['rows', deep, ['found', 'z', 'x']],
] as const)('%s along %j: %j', async (rule, position, ways) => {
  const english = axesOf(rule, position);
  await speak('de');
  const german = axesOf(rule, position);
  for (const offered of [english, german]) expect(offered.map(([way]) => way)).toEqual(ways);
  const texts = [...english, ...german].map(([, text]) => text);
  expect(new Set(texts).size).toBe(2 * ways.length);
});

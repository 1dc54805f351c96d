/** A made room opens with a field in its middle, where one does what is asked. */
import { expect, test } from '@jest/globals';
import { askedAsField } from '../../../../web/app/rooms/opening-field.ts';
import { askedOfUnknown } from '../../../../web/app/rooms/opening-wish.ts';
import type { Shown } from '../../../../web/solver/protocol.ts';

const asked = askedOfUnknown([], 100);
const of = (count: number) => ({ ...asked, luminaires: { ...asked.luminaires, count } });

/** Rooms in which fields of these counts serve; others are there but too dark, or not there at all. */
async function opened(count: number, serves: readonly number[], dark: readonly number[] = []) {
  const tried: number[] = [];
  const found = await askedAsField(of(count), async ({ luminaires }) => {
    tried.push(luminaires.count);
    if (serves.includes(luminaires.count)) return { violation: 0 } as Shown;
    if (dark.includes(luminaires.count)) return { violation: 0.1 } as Shown;
    throw new Error('there is no such field');
  });
  return { tried, luminaires: found.luminaires };
}

test('the field that serves, of as few more as need be, in the middle', async () => {
  const { luminaires } = await opened(4, [4, 6]);
  expect(luminaires).toMatchObject({ count: 4, arrangement: { rule: 'field', axis: 'both' } });
  expect((await opened(4, [6], [4])).luminaires.count).toBe(6);
});

test('five in a row are no field', async () => {
  expect(await opened(5, [5, 6])).toMatchObject({ tried: [6], luminaires: { count: 6 } });
});

test('where none serves luminaires hang anywhere', async () => {
  const { tried, luminaires } = await opened(4, []);
  expect(tried).toEqual([4, 6]);
  expect(luminaires).toEqual(of(4).luminaires);
});

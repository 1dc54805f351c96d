/** What files are called. Covers opening-files. */
import { expect, test } from '@jest/globals';
import { cleanFileName } from '../../../../web/app/opening/opening-files.ts';

test('a name that is too long keeps what says what the file is', () => {
  expect(cleanFileName('office.glb')).toBe('office.glb');
  expect(cleanFileName('no suffix')).toBe('no suffix');
  const long = cleanFileName(`${'a_very_long_name_'.repeat(14)}.glb`);
  expect(long).toHaveLength(200);
  expect(long).toMatch(/^a_very_long_name_.*\.glb$/);
});

/** The line that precomputes a room. */
import { expect, test } from '@jest/globals';
import { precomputeLine } from '../../../web/panel/preview-note.tsx';

test('the line that makes a room live survives any file name', () => {
  expect(precomputeLine('office.glb')).toBe('fiatlux precompute office.glb -o office.flux');
  expect(precomputeLine("my o'ffice.GLB")).toBe(
    "fiatlux precompute 'my o'\\''ffice.GLB' -o 'my o'\\''ffice.flux'",
  );
  expect(precomputeLine('-rf.glb')).toContain("'-rf.glb'");
});

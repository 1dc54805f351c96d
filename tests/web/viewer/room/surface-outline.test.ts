/** Outlines of furniture over a measuring plane that is read. */
import { expect, test } from '@jest/globals';
import { MinEquation } from 'three';
import { outlineOver } from '../../../../web/viewer/room/surface-outline.ts';

test('lines over a plane are no darker where many cross', () => {
  const { blendEquation, color, toneMapped, depthTest } = outlineOver();
  expect(blendEquation).toBe(MinEquation);
  expect(Math.min(...color.toArray())).toBeGreaterThan(0.1); // isolux lines are darker
  expect([toneMapped, depthTest]).toEqual([false, false]);
});

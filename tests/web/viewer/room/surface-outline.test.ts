/** Outlines of furniture over a measuring plane that is read. */
import { expect, test } from '@jest/globals';
import { Color, LineBasicMaterial } from 'three';
import { planeUniforms } from '../../../../web/viewer/light/plane-footprints.ts';
import { outlineOver } from '../../../../web/viewer/room/surface-outline.ts';

test('lines over a plane are no darker where many cross, and seen on much light and on little', () => {
  const { opacity, color, toneMapped } = outlineOver(planeUniforms(), new LineBasicMaterial());
  expect(opacity).toBe(1);
  const brightness = ({ r, g, b }: Color) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
  const [least, most] = [new Color('#440154'), new Color('#fde725')]; // the ends of viridis
  expect(brightness(color)).toBeGreaterThan(5 * brightness(least));
  expect(brightness(color)).toBeLessThan(brightness(most) / 5);
  expect(toneMapped).toBe(false);
});

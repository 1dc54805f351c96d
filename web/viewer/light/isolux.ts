/** Lines of equal light: the usual levels of lighting design, drawn by the fragment shader with anti-aliased edges. */

/** lx (or lm/m2 in the exitance view). */
export const isoluxLevels = [10, 20, 50, 75, 100, 150, 200, 300, 500, 750, 1000, 1500, 2000] as const;

const float = (value: number): string => value.toFixed(1);

/**
 * GLSL: float isoluxLine(float light, float width) = how much of a line covers the pixel, 0..1. `width` in pixels.
 * The distance to a level in pixels is |light - level| / |grad light|; where the light is flat a floor under the
 * gradient keeps a level from flooding the surface. Where lines would crowd (small or steep things) they fade.
 */
export const isoluxShader = /* glsl */ `
float isoluxLine(float light, float width) {
  float slope = fwidth(light);
  float covered = 0.0;
  float levels[${isoluxLevels.length}] = float[${isoluxLevels.length}](${isoluxLevels.map(float).join(', ')});
  for (int i = 0; i < ${isoluxLevels.length}; i++) {
    float pixels = abs(light - levels[i]) / max(slope, 2e-4 * levels[i]);
    float apart = 0.35 * levels[i] / max(slope, 1e-6); // px to the next level, about
    float line = 1.0 - smoothstep(0.5 * width, 0.5 * width + 1.0, pixels);
    covered = max(covered, line * smoothstep(3.0, 9.0, apart));
  }
  return covered;
}
`;

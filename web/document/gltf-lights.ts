/**
 * The luminaires as glTF 2.0 with KHR_lights_punctual, each a downward spot of 180 degrees at its site.
 * A punctual light is given in candela: a Lambertian source of flux Phi has Phi / pi on its axis.
 */
import { positionOf } from './sites.ts';
import type { Layout, SceneInfo } from './types.ts';

/** The unit quaternion (x, y, z, w) that turns -z, where a glTF light points, to `direction`. */
export function rotationFromMinusZ(direction: readonly number[]): [number, number, number, number] {
  const [x = 0, y = 0, z = 0] = direction;
  const length = Math.hypot(x, y, z) || 1;
  const w = 1 - z / length; // 1 + cos of the angle between -z and the direction
  if (w < 1e-9) return [0, 1, 0, 0];
  // cross(-z, direction) = (y, -x, 0)
  const norm = Math.hypot(y / length, x / length, w);
  return [y / length / norm, -x / length / norm, 0, w / norm];
}

export function gltfLights(layout: Layout, sites: SceneInfo['sites']): string {
  const lights = layout.sites.map((_, index) => {
    const flux = (layout.flux[index] ?? 0) * layout.dimming;
    return {
      name: `L${index + 1}`,
      type: 'spot',
      intensity: flux / Math.PI,
      spot: { innerConeAngle: 0, outerConeAngle: Math.PI / 2 },
      extras: { fiatlux: { flux, distribution: 'lambertian', size: sites.size[layout.sites[index] ?? 0] } },
    };
  });
  const nodes = layout.sites.map((site, index) => ({
    name: `L${index + 1}`,
    translation: positionOf(sites, site),
    rotation: rotationFromMinusZ([0, 1, 2].map((axis) => sites.normal[3 * site + axis] ?? 0)),
    extensions: { KHR_lights_punctual: { light: index } },
  }));
  return JSON.stringify(
    {
      asset: { version: '2.0', generator: 'Fiat Lux' },
      extensionsUsed: ['KHR_lights_punctual'],
      extensions: { KHR_lights_punctual: { lights } },
      scene: 0,
      scenes: [{ nodes: nodes.map((_, index) => index) }],
      nodes,
    },
    null,
    2,
  );
}

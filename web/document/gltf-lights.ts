/**
 * The luminaires as glTF 2.0 with KHR_lights_punctual, each a spot at its site. A punctual light is given in candela: a
 * Lambertian source of flux Phi has Phi / pi on its axis. Luminaires of photometric files have EXT_lights_ies on the same
 * node, the file embedded: a viewer that knows both takes the file, whose light the spot only resembles. There -z is
 * gamma 0, +x is C0 and planes are counted towards +y, which is the other way round than here.
 */
import { iesOf } from './ies-file.ts';
import { frameOn, type Frame } from './mounting.ts';
import { bytesOfText, type PhotometricFiles } from './photometric-files.ts';
import type { PhotometricDescription } from './photometry.ts';
import { positionOf } from './sites.ts';
import type { Layout, LuminaireType, Mounting, SceneInfo } from './types.ts';

/** The types that are in use, what their files say and the files themselves, by hash. */
export interface LightProfiles {
  readonly types: readonly LuminaireType[];
  readonly descriptions: Readonly<Record<string, PhotometricDescription>>;
  readonly files: PhotometricFiles;
}

type Quaternion = [number, number, number, number]; // x, y, z, w

/** The unit quaternion that turns -z, where a glTF light points, to `direction`. */
export function rotationFromMinusZ(direction: readonly number[]): Quaternion {
  const [x = 0, y = 0, z = 0] = direction;
  const length = Math.hypot(x, y, z) || 1;
  const w = 1 - z / length; // 1 + cos of the angle between -z and the direction
  if (w < 1e-9) return [0, 1, 0, 0];
  // cross(-z, direction) = (y, -x, 0)
  const norm = Math.hypot(y / length, x / length, w);
  return [y / length / norm, -x / length / norm, 0, w / norm];
}

/** The unit quaternion that turns -z to gamma 0 and x to C0. */
function rotationTo({ down, along }: Frame): Quaternion {
  const first = rotationFromMinusZ(down);
  const [x, y, z, w] = first;
  // Where x and y are after that; what is left is a turn about gamma 0.
  const turnedX = [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)];
  const turnedY = [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)];
  const on = (axis: readonly number[]) => along.reduce((sum, value, i) => sum + value * (axis[i] ?? 0), 0);
  const half = Math.atan2(on(turnedY), on(turnedX)) / 2;
  const [c, s] = [Math.cos(half), Math.sin(half)]; // about z, before the first
  return [x * c + y * s, y * c - x * s, z * c + w * s, w * c - z * s];
}

const lambertian = (flux: number, name: string, size: number | undefined) => ({
  name,
  type: 'spot',
  intensity: flux / Math.PI,
  spot: { innerConeAngle: 0, outerConeAngle: Math.PI / 2 },
  extras: { fiatlux: { flux, distribution: 'lambertian', size } },
});

const radians = Math.PI / 180;
const widest = Math.PI / 2; // of a spot's outer cone

/** What comes near to a photometric file for those who cannot read it. */
function resembling(
  name: string,
  flux: number,
  file: string,
  description: PhotometricDescription | undefined,
) {
  const extras = { fiatlux: { flux, photometry: file } };
  if (!description || description.upwardShare > 0.3)
    return { name, type: 'point', intensity: flux / (4 * Math.PI), extras };
  const outer = Math.min(widest, Math.max(0.01, (description.fieldAngle / 2) * radians));
  const inner = Math.min(outer * 0.99, (description.beamAngle / 2) * radians);
  const intensity = description.maxCandela * (flux / description.integratedFlux);
  return { name, type: 'spot', intensity, spot: { innerConeAngle: inner, outerConeAngle: outer }, extras };
}

/** The file itself where it is one of LM-63 that reads the same whichever way its planes are counted. */
function embedded(file: string, text: string | undefined, description: PhotometricDescription | undefined) {
  const isPlain =
    description !== undefined &&
    /^LM-63-(1995|2002|2019)$/.test(description.format) &&
    ['axial', 'quadrant', 'C0-C180'].includes(description.symmetry);
  const ies = isPlain || !description ? (text ?? '') : iesOf(description, true);
  let binary = '';
  for (const byte of bytesOfText(ies)) binary += String.fromCharCode(byte);
  return { name: file, uri: `data:application/x-ies-lm-63;base64,${btoa(binary)}` };
}

/** The types of a layout, each once. */
function typesIn(
  mountings: readonly Mounting[] | undefined,
  types: readonly LuminaireType[],
): LuminaireType[] {
  return types.filter(({ id }) => mountings?.some(({ type }) => type === id));
}

export function gltfLights(
  layout: Layout,
  sites: SceneInfo['sites'],
  profiles: LightProfiles | null = null,
): string {
  const used = typesIn(layout.mountings, profiles?.types ?? []);
  const profiled = used.filter(({ hash }) => profiles?.files[hash] !== undefined);
  const typeOf = (index: number) => used.find(({ id }) => id === layout.mountings?.[index]?.type);
  const describedBy = (type: LuminaireType) => profiles?.descriptions[type.hash];
  const fluxOf = (index: number) => (layout.flux[index] ?? 0) * layout.dimming;
  const lights = layout.sites.map((site, index) => {
    const [type, name] = [typeOf(index), `L${index + 1}`];
    return type
      ? resembling(name, fluxOf(index), type.file, describedBy(type))
      : lambertian(fluxOf(index), name, sites.size[site]);
  });
  const nodes = layout.sites.map((site, index) => {
    const type = typeOf(index);
    const mounting = layout.mountings?.[index];
    const held = type && describedBy(type)?.integratedFlux;
    const light = type ? profiled.indexOf(type) : -1;
    const profile = type && light >= 0 && { light, multiplier: fluxOf(index) / (held ?? type.flux) };
    return {
      name: `L${index + 1}`,
      translation: positionOf(sites, site),
      rotation:
        type && mounting
          ? rotationTo(frameOn(sites, site, mounting, type.tilt))
          : rotationFromMinusZ([0, 1, 2].map((axis) => sites.normal[3 * site + axis] ?? 0)),
      extensions: {
        KHR_lights_punctual: { light: index },
        ...(profile && { EXT_lights_ies: profile }),
      },
    };
  });
  const files = profiled.map((type) => embedded(type.file, profiles?.files[type.hash], describedBy(type)));
  return JSON.stringify(
    {
      asset: { version: '2.0', generator: 'Fiat Lux' },
      extensionsUsed: ['KHR_lights_punctual', ...(files.length > 0 ? ['EXT_lights_ies'] : [])],
      extensions: {
        KHR_lights_punctual: { lights },
        ...(files.length > 0 && { EXT_lights_ies: { lights: files } }),
      },
      scene: 0,
      scenes: [{ nodes: nodes.map((_, index) => index) }],
      nodes,
    },
    null,
    2,
  );
}

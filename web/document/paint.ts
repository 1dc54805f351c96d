/** Paint on the surfaces of a room: how much of the light it reflects, and of what colour it is. */
import type { Words } from '../language/en.ts';
import { linearFromHex, luminance, type Rgb } from './linear-colour.mjs';
import type { Paint, SceneInfo } from './types.ts';

export const leastPaint = 0.05; // reflectance
export const mostPaint = 0.9;

const mostAlbedo = 0.95; // of a channel

/** The hue of a colour, so light that it reflects so much. */
export function albedoOf(color: string, reflectance: number): Rgb {
  const rgb = linearFromHex(color);
  const own = luminance(rgb);
  const of = (channel: number) => Math.min(mostAlbedo, own > 0 ? (channel * reflectance) / own : reflectance);
  return [of(rgb[0]), of(rgb[1]), of(rgb[2])];
}

/** Leaves that can be painted. */
export const isPaintable = ({ measuring, patches }: SceneInfo['surfaces'][number]): boolean =>
  !measuring && patches > 0;

/** The paint on each leaf of a room; what is of no leaf of it is left out. */
export function paintByLeaf(
  paint: readonly Paint[] | undefined,
  surfaces: SceneInfo['surfaces'],
): ReadonlyMap<number, Paint> {
  const byLeaf = new Map<number, Paint>();
  for (const each of paint ?? []) {
    const leaf = surfaces.findIndex(({ name }) => name === each.surface);
    const surface = surfaces[leaf];
    if (surface && isPaintable(surface)) byLeaf.set(leaf, each);
  }
  return byLeaf;
}

/** The room as it is painted; the same object where nothing is. */
export function paintedScene(scene: SceneInfo, paint: readonly Paint[] | undefined): SceneInfo {
  const byLeaf = scene.hasOperator ? paintByLeaf(paint, scene.surfaces) : new Map<number, Paint>();
  if (byLeaf.size === 0) return scene;
  const surfaces = scene.surfaces.map((surface, leaf) => ({
    ...surface,
    reflectance: byLeaf.get(leaf)?.reflectance ?? surface.reflectance,
  }));
  const patchReflectance = scene.patchReflectance.map(
    (own, patch) => byLeaf.get(scene.surfaceOfPatch[patch] ?? -1)?.reflectance ?? own,
  );
  return { ...scene, surfaces, patchReflectance };
}

/** Linear RGB of the patches, 3 each, where some have another colour than their material. */
export function paintedColors(
  own: Float32Array,
  { surfaces, surfaceOfPatch }: SceneInfo,
  paint: readonly Paint[] | undefined,
): Float32Array {
  const albedos = [...paintByLeaf(paint, surfaces)].flatMap(([leaf, { color, reflectance }]) =>
    color === undefined ? [] : [[leaf, albedoOf(color, reflectance)] as const],
  );
  if (albedos.length === 0) return own;
  const byLeaf = new Map(albedos);
  const colors = own.slice();
  for (let patch = 0; 3 * patch < colors.length; patch++) {
    const albedo = byLeaf.get(surfaceOfPatch[patch] ?? -1);
    if (albedo) colors.set(albedo, 3 * patch);
  }
  return colors;
}

/** A paint or finish as one finds it, for the palette. */
export interface NamedPaint {
  readonly id: keyof Words['paint']['names'];
  readonly reflectance: number;
  readonly color: string;
}

export const palette: readonly NamedPaint[] = [
  { id: 'ceiling', reflectance: 0.85, color: '#f7f6f2' },
  { id: 'offWhite', reflectance: 0.75, color: '#efe8d8' },
  { id: 'sand', reflectance: 0.6, color: '#dcc9a3' },
  { id: 'lightGrey', reflectance: 0.5, color: '#bdbdbc' },
  { id: 'blue', reflectance: 0.45, color: '#98bbd6' },
  { id: 'sage', reflectance: 0.35, color: '#9cb08c' },
  { id: 'oak', reflectance: 0.3, color: '#bd8f5a' },
  { id: 'terracotta', reflectance: 0.2, color: '#bf6c4a' },
  { id: 'walnut', reflectance: 0.12, color: '#6f4c34' },
  { id: 'charcoal', reflectance: 0.06, color: '#45474a' },
];

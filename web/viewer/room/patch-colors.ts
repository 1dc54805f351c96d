/** What colour each patch of a room has: its materials, averaged over the vertices that take their light from it. */
import type { Texture, Vector4 } from 'three';
import { linearFromSrgb } from '../../document/linear-colour.mjs';
import { breath } from '../stage/breath.ts';
import { numbersOf } from './attribute-numbers.ts';
import type { LitMesh } from './room-mesh.ts';

const portion = 16_384; // vertices between two breaths: some milliseconds
const side = 16; // pixels of a texture that is asked for colours: about a patch each

/** Linear RGB of a small copy of a texture, row by row. */
type SmallPicture = Float32Array;

const linear = Float32Array.from({ length: 256 }, (_, byte) => linearFromSrgb(byte / 255));

async function smallPicture({ image }: Texture): Promise<SmallPicture | null> {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = side;
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) return null;
  const small = await createImageBitmap(image as ImageBitmapSource, {
    resizeWidth: side,
    resizeHeight: side,
    resizeQuality: 'medium',
  });
  context.drawImage(small, 0, 0);
  small.close();
  const { data } = context.getImageData(0, 0, side, side);
  return Float32Array.from(
    { length: 3 * side * side },
    (_, i) => linear[data[4 * Math.floor(i / 3) + (i % 3)]!]!,
  );
}

const wrapped = (coordinate: number): number =>
  Math.min(side - 1, Math.floor(side * (coordinate - Math.floor(coordinate))));

/** Adds the colours at some vertices of a mesh to those of their patches. */
function addVertices(
  { mesh }: LitMesh,
  picture: SmallPicture | null,
  sums: Float32Array,
  begin: number,
  end: number,
): void {
  const { geometry, material } = mesh;
  const { albedo, mapTransform } = material.uniforms;
  const base = (albedo!.value as Vector4).toArray();
  const uv = picture && geometry.getAttribute(String(material.defines['MAP_UV']));
  const [a, b, , c, d, , e, f] = mapTransform!.value?.elements ?? [1, 0, 0, 0, 1, 0, 0, 0];
  const tint = material.vertexColors ? numbersOf(geometry.getAttribute('color')) : null;
  const patches = numbersOf(geometry.getAttribute('_patches'));
  const weights = numbersOf(geometry.getAttribute('_weights'));
  const own = [1, 1, 1];
  for (let vertex = begin; vertex < end; vertex++) {
    let at = -1;
    if (uv) {
      const [u, v] = [uv.getX(vertex), uv.getY(vertex)];
      at = 3 * (side * wrapped(b * u + d * v + f) + wrapped(a * u + c * v + e));
    }
    for (let channel = 0; channel < 3; channel++) {
      own[channel] = (at < 0 ? 1 : picture![at + channel]!) * base[channel]!;
      if (tint) own[channel]! *= tint.array[vertex * tint.stride + tint.offset + channel]! * tint.scale;
    }
    for (let corner = 0; corner < 4; corner++) {
      const weight = weights.array[vertex * weights.stride + weights.offset + corner]! * weights.scale;
      const patch = 3 * patches.array[vertex * patches.stride + patches.offset + corner]!;
      if (!(weight > 0) || patch + 2 >= sums.length) continue;
      for (let channel = 0; channel < 3; channel++) sums[patch + channel]! += weight * own[channel]!;
    }
  }
}

/** Linear RGB, 3 a patch, up to a factor; black where no vertex tells. */
export async function patchColors(lit: readonly LitMesh[], patches: number): Promise<Float32Array> {
  const pictures = new Map<Texture, SmallPicture | null>();
  const sums = new Float32Array(3 * patches);
  for (const each of lit) {
    if (each.measuring) continue;
    const map = each.mesh.material.uniforms['albedoMap']!.value as Texture | null;
    if (map && !pictures.has(map)) pictures.set(map, await smallPicture(map).catch(() => null));
    const { count } = each.mesh.geometry.getAttribute('_patches');
    for (let begin = 0; begin < count; begin += portion) {
      addVertices(each, map && pictures.get(map)!, sums, begin, Math.min(count, begin + portion));
      await breath(); // nobody waits for colours: others come first
    }
  }
  return sums;
}

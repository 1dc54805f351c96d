// What of a stranger's .glb the picture reads. Covers glb, room-mesh.
import { afterEach, expect, jest, test } from '@jest/globals';
import { ClampToEdgeWrapping, Mesh, RepeatWrapping, type MeshStandardMaterial } from 'three';
import { readGlb } from '../../../../web/viewer/room/glb.ts';
import { changed } from '../../hostile-models.ts';

const world = globalThis as Record<string, unknown>;
world['self'] = globalThis; // the loader asks for it

afterEach(() => {
  delete world['createImageBitmap'];
});

/** The material of each mesh of a file as a change leaves it. */
async function materialsOf(change: Parameters<typeof changed>[0]): Promise<MeshStandardMaterial[]> {
  const room = await readGlb(changed(change).buffer);
  const materials: MeshStandardMaterial[] = [];
  room.traverse((object) => object instanceof Mesh && materials.push(object.material));
  return materials;
}

test('a picture that is KTX2 alone leaves the plain colour, and refuses nothing', async () => {
  const [first] = await materialsOf(({ json }) => {
    json.extensionsUsed = json.extensionsRequired = ['KHR_texture_basisu'];
    json.images = [{ uri: 'data:image/ktx2;base64,q0tUWCAyMLsNChoK', mimeType: 'image/ktx2' }];
    json.textures = [{ extensions: { KHR_texture_basisu: { source: 0 } } }];
    json.materials[0].pbrMetallicRoughness.baseColorTexture = { index: 0 };
  });
  expect(first!.map).toBeNull();
  expect(first!.color.r).toBeCloseTo(0.5, 6);
});

test('pictures of a file are decoded in tasks of their own, each once, and one that is broken is none', async () => {
  let [task, isTimed] = [0, true];
  const tick = () => {
    task += 1;
    if (isTimed) setTimeout(tick);
  };
  tick();
  const decoded: { type: string; size: number; task: number }[] = [];
  world['createImageBitmap'] = jest.fn(async ({ type, size }: Blob) => {
    decoded.push({ type, size, task });
    if (size === 3) throw new Error('not a picture');
    return { width: size, height: 1 };
  });
  const materials = await materialsOf(({ json }) => {
    const views = [7, 3, 9].map((byteLength) => json.bufferViews.push({ buffer: 0, byteLength }) - 1);
    json.images = views.map((bufferView) => ({ bufferView, mimeType: 'image/png' }));
    json.samplers = [{ wrapS: 33071 }];
    json.textures = [{ source: 0 }, { source: 1 }, { source: 2 }, { source: 0, sampler: 0 }];
    json.materials = json.textures.map((_: unknown, index: number) => ({
      pbrMetallicRoughness: { baseColorTexture: { index } },
    }));
    const [square] = json.meshes[0].primitives;
    json.meshes[0].primitives = json.materials.map((_: unknown, material: number) => ({
      ...square,
      material,
    }));
  });
  isTimed = false;
  expect(decoded.map(({ type, size }) => [type, size])).toEqual([7, 3, 9].map((size) => ['image/png', size]));
  expect(new Set(decoded.map((each) => each.task)).size).toBe(3);
  const seen = materials.map(({ map }) => map && [(map.image as { width: number }).width, map.wrapS]);
  expect(seen).toEqual([[7, RepeatWrapping], null, [9, RepeatWrapping], [7, ClampToEdgeWrapping]]);
});

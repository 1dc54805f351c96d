// What of a stranger's .glb the picture reads. Covers room-mesh.
import { expect, test } from '@jest/globals';
import { Mesh, type MeshStandardMaterial } from 'three';
import { readGlb } from '../../../../web/viewer/room/room-mesh.ts';
import { changed } from '../../hostile-models.ts';

Object.assign(globalThis, { self: globalThis }); // the loader asks for it

test('a picture that is KTX2 alone leaves the plain colour, and refuses nothing', async () => {
  const glb = changed(({ json }) => {
    json.extensionsUsed = json.extensionsRequired = ['KHR_texture_basisu'];
    json.images = [{ uri: 'data:image/ktx2;base64,q0tUWCAyMLsNChoK', mimeType: 'image/ktx2' }];
    json.textures = [{ extensions: { KHR_texture_basisu: { source: 0 } } }];
    json.materials[0].pbrMetallicRoughness.baseColorTexture = { index: 0 };
  });
  const room = await readGlb(glb.buffer);
  const meshes: Mesh[] = [];
  room.traverse((object) => object instanceof Mesh && meshes.push(object));
  const { map, color } = meshes[0]!.material as MeshStandardMaterial;
  expect(map).toBeNull();
  expect(color.r).toBeCloseTo(0.5, 6);
});

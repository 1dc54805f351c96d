/** What a scene graph needs on the graphics card, each thing once. */
import { expect, test } from '@jest/globals';
import { BoxGeometry, Group, Mesh, MeshLambertMaterial, ShaderMaterial, Texture } from 'three';
import { texturesUnder } from '../../../../web/viewer/stage/gpu-resources.ts';

test('textures of materials and of uniforms, of all meshes, each once', () => {
  const [oak, stone, light] = [new Texture(), new Texture(), new Texture()];
  const geometry = new BoxGeometry();
  const shader = new ShaderMaterial({ uniforms: { light: { value: light }, range: { value: 3 } } });
  const root = new Group();
  const inner = new Group().add(new Mesh(geometry, [new MeshLambertMaterial({ map: stone }), shader]));
  root.add(new Mesh(geometry, new MeshLambertMaterial({ map: oak })), inner);
  root.add(new Mesh(geometry, new MeshLambertMaterial({ map: oak })));
  expect([...texturesUnder(root)]).toEqual([oak, stone, light]);
});

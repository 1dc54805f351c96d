/**
 * The programs of the first picture, given to the graphics card while the room is still on its way: linking them takes
 * longer than anything else between the first light and the first picture.
 */
import {
  PlaneGeometry,
  Color,
  Mesh,
  Scene,
  Texture,
  type Camera,
  type Material,
  type WebGLRenderer,
} from 'three';
import { createLightMaterial, type SharedUniforms } from './light-material.ts';
import { createHaloMaterial, createPanelMaterial } from './luminaire-materials.ts';

/** As most meshes of a room are: opaque, with and without a texture. */
function roomMaterials(shared: SharedUniforms): Material[] {
  const plain = { color: new Color(), opacity: 1, alphaCut: 0, vertexColors: false, transparent: false };
  return [null, new Texture()].map((map) =>
    createLightMaterial(shared, { albedo: { ...plain, map }, measuring: false, reflectance: 0 }),
  );
}

/** Starts the linking and returns at once; the programs last as long as what it returns is not called. */
export function warmUp(renderer: WebGLRenderer, camera: Camera, shared: SharedUniforms): () => void {
  const materials = [...roomMaterials(shared), createPanelMaterial(), createHaloMaterial()];
  const geometry = new PlaneGeometry(); // positions and normals, as everything here has
  const scene = new Scene();
  for (const material of materials) scene.add(new Mesh(geometry, material));
  renderer.compile(scene, camera);
  return () => {
    for (const material of materials) material.dispose();
    geometry.dispose();
  };
}

/**
 * Samples of what rooms are drawn with, for the stage to link while no room waits for it: that takes longer than anything
 * else between the first light and the first picture. Their programs last as long as they do.
 */
import {
  PlaneGeometry,
  Color,
  Group,
  Mesh,
  MeshStandardMaterial,
  Texture,
  type Material,
  type Side as DrawnSide,
} from 'three';
import { createLightMaterial, type SharedUniforms } from './light/light-material.ts';
import { diffuse } from './room/room-mesh.ts';
import {
  createHaloMaterial,
  createHousingMaterial,
  createPanelMaterial,
} from './luminaires/luminaire-materials.ts';

/** As most meshes of a room are: opaque, with and without a texture. */
function roomMaterials(shared: SharedUniforms): Material[] {
  const plain = { color: new Color(), opacity: 1, alphaCut: 0, vertexColors: false, transparent: false };
  return [null, new Texture()].map((map) =>
    createLightMaterial(shared, {
      albedo: { ...plain, map },
      measuring: false,
      standing: false,
      back: false,
      yields: false,
      reflectance: 0,
    }),
  );
}

/** As most that is drawn of a room with light is: its surfaces, with and without a texture, and luminaires. */
export function litSample(shared: SharedUniforms): Group {
  const geometry = new PlaneGeometry(); // positions and normals, as everything here has
  const group = new Group();
  for (const material of [
    ...roomMaterials(shared),
    createPanelMaterial(),
    createHousingMaterial(),
    createHaloMaterial(),
  ])
    group.add(new Mesh(geometry, material));
  return group;
}

/** As most meshes of a room without light are. */
export function previewSample(side: DrawnSide): Group {
  const group = new Group();
  for (const map of [null, new Texture()])
    group.add(new Mesh(new PlaneGeometry(), diffuse(new MeshStandardMaterial({ map }), side)));
  return group;
}

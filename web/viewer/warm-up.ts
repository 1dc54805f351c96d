/**
 * The programs of the first picture, given to the graphics card while the room is still on its way: linking them takes
 * longer than anything else between the first light and the first picture.
 */
import {
  PlaneGeometry,
  Color,
  Group,
  Mesh,
  MeshStandardMaterial,
  Scene,
  Texture,
  type Camera,
  type Material,
  type Side as DrawnSide,
  type WebGLRenderer,
} from 'three';
import { createLightMaterial, type SharedUniforms } from './light/light-material.ts';
import { diffuse } from './room/room-mesh.ts';
import { programsOf } from './stage/gpu-resources.ts';
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

const often = 10; // ms
const enough = 500; // times: where no link ends (the context is lost) the first picture does without

/** Uses every program once it is linked: only the first use waits for the link, and asks for the uniforms. */
function useLinked(renderer: WebGLRenderer, turn = 0): void {
  const programs = programsOf(renderer);
  if (programs.every((program) => program.isReady())) for (const program of programs) program.getUniforms();
  else if (turn < enough) setTimeout(() => useLinked(renderer, turn + 1), often);
}

/** As most meshes of a room without light are. The programs of what it returns are those of them, once it is compiled. */
export function previewSample(side: DrawnSide): Group {
  const group = new Group();
  for (const map of [null, new Texture()])
    group.add(new Mesh(new PlaneGeometry(), diffuse(new MeshStandardMaterial({ map }), side)));
  return group;
}

/** Starts the linking and returns at once; the programs last until what it returns is called. */
export function warmUp(renderer: WebGLRenderer, camera: Camera, shared: SharedUniforms): () => void {
  const materials = [
    ...roomMaterials(shared),
    createPanelMaterial(),
    createHousingMaterial(),
    createHaloMaterial(),
  ];
  const geometry = new PlaneGeometry(); // positions and normals, as everything here has
  const scene = new Scene();
  for (const material of materials) scene.add(new Mesh(geometry, material));
  renderer.compile(scene, camera);
  const timer = setTimeout(() => useLinked(renderer));
  return () => {
    clearTimeout(timer);
    for (const material of materials) material.dispose();
    geometry.dispose();
  };
}

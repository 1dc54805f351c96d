/**
 * The room on the screen: the display .glb of a scene file, its glTF materials replaced by the light material where
 * the mesh carries `_PATCHES` and `_WEIGHTS`. Meshes without them (glass) are drawn as thin translucent sheets.
 */
import {
  Box3,
  type BufferGeometry,
  Color,
  DoubleSide,
  FrontSide,
  Mesh,
  MeshBasicMaterial,
  ShaderMaterial,
  Vector3,
  type Group,
  type Material,
  type MeshStandardMaterial,
  type Object3D,
} from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { deinterleaveGeometry } from 'three/examples/jsm/utils/BufferGeometryUtils.js';
import type { SceneInfo } from '../../document/types.ts';
import { createLightMaterial, type Albedo, type SharedUniforms } from '../light/light-material.ts';
import { splitHungMeshes } from './hung-meshes.ts';
import type { Side } from './standing.ts';
import type { Box } from '../eye/framing.ts';

/** A mesh that carries light: one leaf surface, one material. */
export interface LitMesh {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  readonly surface: number; // leaf surface, -1 = none
  readonly measuring: boolean;
}

export interface RoomMesh {
  readonly root: Group;
  readonly lit: readonly LitMesh[];
  readonly hanging: ReadonlyMap<Object3D, Side>; // on the walls and the ceiling
  readonly standing: ReadonlySet<Object3D>; // furniture
  readonly box: Box;
  /** How much of the surfaces faces an eye at azimuth 45, 135, 225 and 315 degrees; every surface counts 1. */
  readonly facing: readonly number[];
  dispose(): void;
}

/** extras of the mesh or of the nearest node above it. */
function extra(object: Object3D, key: string): unknown {
  for (let at: Object3D | null = object; at; at = at.parent) {
    const value: unknown = at.userData[key];
    if (value !== undefined) return value;
  }
  return undefined;
}

function surfaceIndex(mesh: Mesh, scene: SceneInfo | null): number {
  const index = extra(mesh, 'surfaceIndex');
  if (typeof index === 'number') return index;
  const name = extra(mesh, 'surface');
  return scene ? scene.surfaces.findIndex((surface) => surface.name === name) : -1;
}

const isMeasuring = (mesh: Mesh, scene: SceneInfo): boolean =>
  extra(mesh, 'measuring') === true || scene.surfaces[surfaceIndex(mesh, scene)]?.measuring === true;

function albedoOf(material: MeshStandardMaterial): Albedo {
  return {
    color: material.color ?? new Color(1, 1, 1),
    opacity: material.opacity,
    map: material.map ?? null,
    alphaCut: material.alphaTest,
    vertexColors: material.vertexColors,
    transparent: material.transparent,
  };
}

function translucent(material: MeshStandardMaterial): MeshBasicMaterial {
  const opacity = Math.min(material.opacity, 0.22);
  return new MeshBasicMaterial({
    color: material.color ?? new Color(1, 1, 1),
    transparent: true,
    opacity,
    depthWrite: false,
    side: DoubleSide,
  });
}

/** Adds up, for each surface, what share of its upright area faces each of the four corners. */
function facingShares(lit: readonly LitMesh[]): number[] {
  const perSurface = new Map<number, [number, number, number, number, number]>();
  const [a, b, c, normal] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  for (const { mesh, surface, measuring } of lit) {
    const index = mesh.geometry.index;
    if (measuring || !index) continue;
    const sums = perSurface.get(surface) ?? [0, 0, 0, 0, 0];
    perSurface.set(surface, sums);
    const position = mesh.geometry.getAttribute('position');
    for (let i = 0; i + 2 < index.count; i += 3) {
      a.fromBufferAttribute(position, index.getX(i));
      b.fromBufferAttribute(position, index.getX(i + 1)).sub(a);
      c.fromBufferAttribute(position, index.getX(i + 2)).sub(a);
      normal.crossVectors(b, c).transformDirection(mesh.matrixWorld);
      const area = b.cross(c).length();
      if (!(area > 0)) continue;
      sums[4] += area;
      if (normal.x + normal.z > 0.1) sums[0] += area;
      if (normal.x - normal.z > 0.1) sums[1] += area;
      if (-normal.x - normal.z > 0.1) sums[2] += area;
      if (normal.z - normal.x > 0.1) sums[3] += area;
    }
  }
  const shares = [0, 0, 0, 0];
  for (const sums of perSurface.values())
    for (let q = 0; q < 4; q++) shares[q]! += sums[4] > 0 ? sums[q]! / sums[4] : 0;
  return shares;
}

/** Reads any .glb; the buffer stays as it is. Rejects with one readable line. */
export async function readGlb(glb: ArrayBuffer): Promise<Group> {
  try {
    const gltf = await new GLTFLoader().parseAsync(glb, '');
    for (const mesh of meshesOf(gltf.scene)) deinterleaveGeometry(mesh.geometry);
    return gltf.scene;
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    throw new Error(`The room's geometry cannot be displayed: ${reason}`, { cause: error });
  }
}

function boundsOf(root: Object3D): Box {
  const box = new Box3().setFromObject(root);
  if (box.isEmpty()) throw new Error('The room has no geometry to display.');
  return { min: box.min.toArray(), max: box.max.toArray() };
}

const meshesOf = (root: Object3D): Mesh[] => {
  const meshes: Mesh[] = [];
  root.traverse((object) => object instanceof Mesh && meshes.push(object));
  return meshes;
};

function freeMeshes(root: Object3D, more: Iterable<Material>): void {
  const materials = new Set<Material>(more);
  for (const mesh of meshesOf(root)) {
    mesh.geometry.dispose();
    for (const material of [mesh.material].flat()) materials.add(material);
  }
  for (const material of materials) {
    const map = (material as MeshStandardMaterial).map;
    map?.dispose();
    if (typeof ImageBitmap !== 'undefined' && map?.image instanceof ImageBitmap) map.image.close();
    material.dispose();
  }
}

/** Makes the display mesh of a scene file ready for its light; takes `root` over. Throws one readable line. */
export function loadRoomMesh(
  root: Group,
  scene: SceneInfo,
  shared: SharedUniforms,
  anisotropy: number,
): RoomMesh {
  root.updateMatrixWorld(true);
  const lit: LitMesh[] = [];
  const box = boundsOf(root);
  const solid = meshesOf(root).filter((mesh) => !isMeasuring(mesh, scene));
  const { hanging, standing } = splitHungMeshes(solid, box);
  const meshes = meshesOf(root);
  const sources = new Set<Material>();
  for (const mesh of meshes) {
    const source = mesh.material as MeshStandardMaterial;
    sources.add(source);
    if (source.map) source.map.anisotropy = anisotropy;
    mesh.matrixAutoUpdate = false;
    if (!mesh.geometry.hasAttribute('_patches') || !mesh.geometry.hasAttribute('_weights')) {
      mesh.material = translucent(source);
      continue;
    }
    const surface = surfaceIndex(mesh, scene);
    const measuring = isMeasuring(mesh, scene);
    const reflectance = scene.surfaces[surface]?.reflectance ?? 0;
    const material = createLightMaterial(shared, { albedo: albedoOf(source), measuring, reflectance });
    mesh.material = material;
    if (measuring) [mesh.visible, mesh.renderOrder] = [false, 2];
    lit.push({ mesh: mesh as Mesh<BufferGeometry, ShaderMaterial>, surface, measuring });
  }
  return {
    root,
    lit,
    hanging,
    standing,
    box,
    facing: facingShares(lit),
    dispose: () => freeMeshes(root, sources),
  };
}

/** Loads any .glb as it is, to be looked at under plain lights. */
export async function loadPreview(glb: ArrayBuffer, cutAway: boolean): Promise<RoomMesh> {
  const root = await readGlb(glb);
  root.updateMatrixWorld(true);
  for (const mesh of meshesOf(root))
    for (const material of [mesh.material].flat()) material.side = cutAway ? FrontSide : DoubleSide;
  const box = boundsOf(root);
  const { hanging, standing } = splitHungMeshes(meshesOf(root), box);
  const dispose = () => freeMeshes(root, []);
  return { root, lit: [], hanging, standing, box, facing: [0, 0, 0, 0], dispose };
}

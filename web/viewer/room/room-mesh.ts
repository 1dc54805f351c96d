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
  type Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  ShaderMaterial,
  type Group,
  type Material,
  type MeshStandardMaterial,
  type Object3D,
  type Side as DrawnSide,
} from 'three';
import type { SceneInfo } from '../../document/types.ts';
import { createLightMaterial, type Albedo, type SharedUniforms } from '../light/light-material.ts';
import { facingOf, type Facing } from './facing.ts';
import { readGlb } from './glb.ts';
import { splitHungMeshes } from './hung-meshes.ts';
import type { Side } from './standing.ts';
import type { Box } from '../eye/framing.ts';
import { inTurn, type Pieces } from '../stage/breath.ts';
import { meshesUnder } from '../stage/gpu-resources.ts';
import { words } from '../../language/language.ts';
import { frontOf } from '../../language/surface-names.ts';

/** A mesh that carries light: one leaf surface, one material. */
export interface LitMesh {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  readonly surface: number; // leaf surface, -1 = none
  readonly measuring: boolean;
  readonly back: boolean; // the other side of a sheet, as the inside of a hollow wall is
}

export interface RoomMesh {
  readonly root: Group;
  readonly lit: readonly LitMesh[];
  readonly hanging: ReadonlyMap<Object3D, Side>; // on the walls and the ceiling
  readonly standing: ReadonlySet<Object3D>; // furniture
  readonly rugs: ReadonlySet<Object3D>; // of it, what lies flat on the floor
  readonly box: Box;
  readonly facing: Facing;
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

function boundsOf(root: Object3D): Box {
  const box = new Box3().setFromObject(root);
  if (box.isEmpty()) throw new Error(words.value.opening.view.nothing);
  return { min: box.min.toArray(), max: box.max.toArray() };
}

function freeMeshes(root: Object3D, more: Iterable<Material>): void {
  const materials = new Set<Material>(more);
  for (const mesh of meshesUnder(root)) {
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
export function* loadRoomMesh(
  root: Group,
  scene: SceneInfo,
  shared: SharedUniforms,
  anisotropy: number,
): Pieces<RoomMesh> {
  root.updateMatrixWorld(true);
  const lit: LitMesh[] = [];
  const box = boundsOf(root);
  const solid = meshesUnder(root).filter((mesh) => !isMeasuring(mesh, scene));
  yield;
  const { hanging, standing, rugs } = yield* splitHungMeshes(solid, box);
  const meshes = meshesUnder(root);
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
    const { reflectance = 0, name = '' } = scene.surfaces[surface] ?? {};
    const back = frontOf(name) !== null;
    const material = createLightMaterial(shared, {
      albedo: albedoOf(source),
      measuring,
      standing: standing.has(mesh),
      back,
      yields: standing.has(mesh) && !rugs.has(mesh), // no light reaches the floor below a rug
      reflectance,
    });
    mesh.material = material;
    if (measuring) [mesh.visible, mesh.renderOrder] = [false, 2];
    lit.push({ mesh: mesh as Mesh<BufferGeometry, ShaderMaterial>, surface, measuring, back });
  }
  return {
    root,
    lit,
    hanging,
    standing,
    rugs,
    box,
    facing: yield* facingOf(lit),
    dispose: () => freeMeshes(root, sources),
  };
}

/**
 * All is diffuse. glTF's own material would have other pictures fetched that say nothing of that, and a program that takes
 * long to link, without which nothing is seen.
 */
export function diffuse(source: MeshStandardMaterial, side: DrawnSide): MeshLambertMaterial {
  const { name, color, map, vertexColors, transparent, opacity, alphaTest, depthWrite } = source;
  const { flatShading = false } = source; // of an unlit material there is none
  const look = { name, color, map, vertexColors, flatShading, transparent, opacity, alphaTest, depthWrite };
  return new MeshLambertMaterial({ ...look, side });
}

export const drawnSide = (cutAway: boolean): DrawnSide => (cutAway ? FrontSide : DoubleSide);

/** Loads any .glb as it is, to be looked at under plain lights. */
export async function loadPreview(glb: ArrayBuffer, cutAway: boolean): Promise<RoomMesh> {
  const root = await readGlb(glb);
  root.updateMatrixWorld(true);
  const looks = new Map<Material, Material>();
  for (const mesh of meshesUnder(root)) {
    const source = mesh.material as MeshStandardMaterial;
    const look = looks.get(source) ?? diffuse(source, drawnSide(cutAway));
    looks.set(source, look);
    mesh.material = look;
  }
  const box = boundsOf(root);
  const { hanging, standing, rugs } = await inTurn(splitHungMeshes(meshesUnder(root), box));
  const dispose = () => freeMeshes(root, looks.keys());
  return { root, lit: [], hanging, standing, rugs, box, facing: new Map(), dispose };
}

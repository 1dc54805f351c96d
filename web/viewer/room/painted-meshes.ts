/** Paint on the meshes of a room: what its materials are drawn with. */
import type { Vector4 } from 'three';
import type { SceneInfo } from '../../document/types.ts';
import type { LitMesh } from './room-mesh.ts';
import type { SurfacePaint } from '../types.ts';

export function paintMeshes(lit: readonly LitMesh[], scene: SceneInfo, paint: readonly SurfacePaint[]): void {
  const bySurface = new Map(paint.map((each) => [each.surface, each]));
  for (const { mesh, surface } of lit) {
    const painted = bySurface.get(surface);
    const uniforms = mesh.material.uniforms;
    const value = uniforms['paint']!.value as Vector4;
    if (painted?.albedo) value.set(...painted.albedo, 1);
    else value.setScalar(painted?.factor ?? 1).setW(0);
    uniforms['reflectance']!.value = painted?.reflectance ?? scene.surfaces[surface]?.reflectance ?? 0;
  }
}

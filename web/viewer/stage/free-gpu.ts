/**
 * Forgets what was uploaded for a scene graph without losing the data: geometries, materials and textures announce
 * their disposal, and are uploaded again when they are next drawn. To be called while a lost context is still lost;
 * afterwards the old buffers would be deleted in a context that they do not belong to.
 */
import { InstancedMesh, type Object3D } from 'three';
import { materialsOf, texturesOf, type Drawn } from './gpu-resources.ts';

export function freeGpu(root: Object3D): void {
  root.traverse((object) => {
    const drawn = object as Drawn;
    drawn.geometry?.dispose();
    if (object instanceof InstancedMesh) object.dispose();
    for (const each of materialsOf(drawn)) {
      for (const texture of texturesOf(each)) texture.dispose();
      each.dispose();
    }
  });
}

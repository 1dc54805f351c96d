/**
 * Forgets what was uploaded for a scene graph without losing the data: geometries, materials and textures announce
 * their disposal, and are uploaded again when they are next drawn. To be called while a lost context is still lost;
 * afterwards the old buffers would be deleted in a context that they do not belong to.
 */
import {
  InstancedMesh,
  Texture,
  type BufferGeometry,
  type Material,
  type Object3D,
  type ShaderMaterial,
} from 'three';

interface Drawn {
  readonly geometry?: BufferGeometry;
  readonly material?: Material | Material[];
}

function texturesOf(material: Material): Texture[] {
  const uniforms = (material as Partial<ShaderMaterial>).uniforms ?? {};
  const values: unknown[] = [
    ...Object.values(material),
    ...Object.values(uniforms).map((each) => each.value),
  ];
  return values.filter((value): value is Texture => value instanceof Texture);
}

export function freeGpu(root: Object3D): void {
  root.traverse((object) => {
    const { geometry, material } = object as Drawn;
    geometry?.dispose();
    if (object instanceof InstancedMesh) object.dispose();
    for (const each of [material ?? []].flat()) {
      for (const texture of texturesOf(each)) texture.dispose();
      each.dispose();
    }
  });
}

/** What a scene graph needs on the graphics card: programs and textures. */
import { Mesh, Texture, type Material, type Object3D, type ShaderMaterial, type WebGLRenderer } from 'three';

/** What three has and its types leave out. */
export interface Program {
  isReady(): boolean; // linked, or not to be known without waiting
  getUniforms(): unknown; // the first time asks the graphics process, and waits for all that it was given before
}

export const programsOf = ({ info }: WebGLRenderer): readonly Program[] =>
  (info.programs ?? []) as unknown as readonly Program[];

export interface Drawn {
  readonly geometry?: { dispose(): void };
  readonly material?: Material | Material[];
}

export const materialsOf = ({ material }: Drawn): readonly Material[] => [material ?? []].flat();

export function texturesOf(material: Material): readonly Texture[] {
  const uniforms = (material as Partial<ShaderMaterial>).uniforms ?? {};
  const values: unknown[] = [
    ...Object.values(material),
    ...Object.values(uniforms).map((each) => each.value),
  ];
  return values.filter((value): value is Texture => value instanceof Texture);
}

export function meshesUnder(root: Object3D): readonly Mesh[] {
  const meshes: Mesh[] = [];
  root.traverse((object) => object instanceof Mesh && meshes.push(object));
  return meshes;
}

export function texturesUnder(root: Object3D): ReadonlySet<Texture> {
  const textures = new Set<Texture>();
  root.traverse((object) => {
    for (const material of materialsOf(object as Drawn))
      for (const texture of texturesOf(material)) textures.add(texture);
  });
  return textures;
}

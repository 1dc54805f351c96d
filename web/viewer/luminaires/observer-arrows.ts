/** Those who look, as arrows at their eyes: which way each looks, and by colour what glares there. */
import {
  Color,
  ConeGeometry,
  CylinderGeometry,
  Group,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  Quaternion,
  Vector3,
} from 'three';
import { mergeGeometries } from 'three/examples/jsm/utils/BufferGeometryUtils.js';
import { glareColor } from '../../document/glare.ts';
import type { SeenGlare } from '../types.ts';

const length = 0.45; // m

/** Along +y, its tail at the origin. */
function arrowGeometry() {
  const shaft = new CylinderGeometry(0.018, 0.018, 0.6 * length, 8).translate(0, 0.3 * length, 0);
  const head = new ConeGeometry(0.06, 0.4 * length, 12).translate(0, 0.8 * length, 0);
  const arrow = mergeGeometries([shaft, head]);
  shaft.dispose();
  head.dispose();
  return arrow;
}

export class ObserverArrows {
  readonly root = new Group();
  readonly #geometry = arrowGeometry();
  readonly #material = new MeshBasicMaterial({ toneMapped: false, transparent: true, opacity: 0.9 });
  #mesh: InstancedMesh | null = null;

  show(observers: readonly SeenGlare[]): void {
    this.#clear();
    if (observers.length === 0) return;
    const mesh = new InstancedMesh(this.#geometry, this.#material, observers.length);
    const [along, one] = [new Vector3(0, 1, 0), new Vector3(1, 1, 1)];
    observers.forEach(({ position, direction, ugr }, i) => {
      const turn = new Quaternion().setFromUnitVectors(along, new Vector3(...direction).normalize());
      mesh.setMatrixAt(i, new Matrix4().compose(new Vector3(...position), turn, one));
      mesh.setColorAt(i, new Color(glareColor(ugr)));
    });
    mesh.renderOrder = 4;
    mesh.frustumCulled = false;
    this.#mesh = mesh;
    this.root.add(mesh);
  }

  dispose(): void {
    this.#clear();
    this.#geometry.dispose();
    this.#material.dispose();
  }

  #clear(): void {
    if (this.#mesh) this.root.remove(this.#mesh);
    this.#mesh?.dispose();
    this.#mesh = null;
  }
}

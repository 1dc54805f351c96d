/** Where a luminaire's light goes, as a body in the room: in each direction as far out as it is strong. */
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial } from 'three';
import { sampledGammas, sampledPlanes } from '../../document/photometry.ts';

const reach = 1.4; // m, in the strongest direction
const step = 3; // degrees of gamma between two rings

/** x along C0, y along C90, z along gamma 0. `candela` as a description has it. */
export function solidGeometry(candela: Float32Array): BufferGeometry {
  const rings = (sampledGammas - 1) / step + 1;
  const most = candela.reduce((a, b) => Math.max(a, b), 1e-9);
  const position = new Float32Array(sampledPlanes * rings * 3);
  const index: number[] = [];
  for (let plane = 0; plane < sampledPlanes; plane++) {
    const c = (plane / sampledPlanes) * 2 * Math.PI;
    for (let ring = 0; ring < rings; ring++) {
      const gamma = (ring * step * Math.PI) / 180;
      const r = (reach * (candela[plane * sampledGammas + ring * step] ?? 0)) / most;
      const at = 3 * (plane * rings + ring);
      position.set(
        [r * Math.sin(gamma) * Math.cos(c), r * Math.sin(gamma) * Math.sin(c), r * Math.cos(gamma)],
        at,
      );
      if (ring + 1 === rings) continue;
      const [a, b] = [plane * rings + ring, ((plane + 1) % sampledPlanes) * rings + ring];
      index.push(a, b, a + 1, b, b + 1, a + 1);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setIndex(index);
  return geometry;
}

export class PhotometricSolid {
  readonly mesh = new Mesh(
    new BufferGeometry(),
    new MeshBasicMaterial({
      color: '#ffcf7a',
      transparent: true,
      opacity: 0.13, // a tint: on a light floor more of it would be taken for light
      depthWrite: false,
      side: DoubleSide,
      toneMapped: false,
    }),
  );
  /** Colours that stand for numbers are not to be tinted. */
  isWanted = true;
  #candela: Float32Array | null = null;

  constructor() {
    this.mesh.visible = false;
    this.mesh.renderOrder = 5;
    this.mesh.frustumCulled = false;
  }

  /** null: none is shown. */
  show(candela: Float32Array | null): void {
    this.mesh.visible = candela !== null && this.isWanted;
    if (candela === null || candela === this.#candela) return;
    this.#candela = candela;
    this.mesh.geometry.dispose();
    this.mesh.geometry = solidGeometry(candela);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

/**
 * Sites as marks on their mount: dots on the free ones while a luminaire is dragged, frames where those go that move with
 * it, crosses on the excluded ones.
 */
import {
  BoxGeometry,
  CircleGeometry,
  Color,
  DoubleSide,
  Group,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  RingGeometry,
  Vector3,
  type BufferGeometry,
} from 'three';
import { mergeGeometries } from 'three/examples/jsm/utils/BufferGeometryUtils.js';
import type { SceneInfo } from '../../document/types.ts';
import { sitePosition, siteRotation } from './luminaire-objects.ts';

function crossGeometry(): BufferGeometry {
  const bars = [0.25, -0.25].map((turn) => new BoxGeometry(1, 0.14, 0.02).rotateZ(turn * Math.PI));
  const cross = mergeGeometries(bars);
  for (const bar of bars) bar.dispose();
  return cross;
}

/** A square frame whose outer edge is 1. */
function frameGeometry(): BufferGeometry {
  return new RingGeometry(0.86 * Math.SQRT1_2, Math.SQRT1_2, 4).rotateZ(Math.PI / 4);
}

class Marks {
  mesh: InstancedMesh | null = null;
  #root: Group;
  #geometry: BufferGeometry;
  #material: MeshBasicMaterial;
  #size: number; // share of the site's side

  constructor(root: Group, geometry: BufferGeometry, color: string, size: number) {
    this.#root = root;
    this.#geometry = geometry;
    this.#size = size;
    this.#material = new MeshBasicMaterial({
      color: new Color(color),
      side: DoubleSide,
      toneMapped: false,
      transparent: true,
      opacity: 0.85,
      depthWrite: false,
    });
  }

  show(sites: SceneInfo['sites'], shown: readonly number[]): void {
    this.hide();
    if (shown.length === 0) return;
    this.mesh = new InstancedMesh(this.#geometry, this.#material, shown.length);
    this.mesh.renderOrder = 5;
    const matrix = new Matrix4();
    shown.forEach((site, i) => {
      const scale = new Vector3().setScalar(this.#size * sites.size[site]!);
      matrix.compose(sitePosition(sites, site, 0.02), siteRotation(sites, site), scale);
      this.mesh!.setMatrixAt(i, matrix);
    });
    this.#root.add(this.mesh);
  }

  hide(): void {
    if (!this.mesh) return;
    this.#root.remove(this.mesh);
    this.mesh.dispose();
    this.mesh = null;
  }

  dispose(): void {
    this.hide();
    this.#geometry.dispose();
    this.#material.dispose();
  }
}

export class SiteMarks {
  readonly root = new Group();
  #candidates = new Marks(this.root, new CircleGeometry(0.5, 20), '#6fb1ff', 0.16);
  #ghosts = new Marks(this.root, frameGeometry(), '#4f9dff', 1.15);
  #crosses = new Marks(this.root, crossGeometry(), '#e5605c', 0.3);

  showCandidates(sites: SceneInfo['sites'], free: readonly number[]): void {
    this.#candidates.show(sites, free);
  }

  hideCandidates(): void {
    this.#candidates.hide();
  }

  setGhosts(sites: SceneInfo['sites'] | null, shown: readonly number[]): void {
    if (sites) this.#ghosts.show(sites, shown);
    else this.#ghosts.hide();
  }

  setCrossed(sites: SceneInfo['sites'] | null, crossed: readonly number[]): void {
    if (sites) this.#crosses.show(sites, crossed);
    else this.#crosses.hide();
  }

  dispose(): void {
    this.#candidates.dispose();
    this.#ghosts.dispose();
    this.#crosses.dispose();
  }
}

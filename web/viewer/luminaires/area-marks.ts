/** Areas in plan as tinted panes just below where the luminaires hang: red where none may, blue where they shall. */
import { DoubleSide, Group, Mesh, MeshBasicMaterial, PlaneGeometry } from 'three';
import type { Areas, PlanArea, SceneInfo } from '../../document/types.ts';

const lift = 0.03; // m below the sites

export interface DraftArea {
  readonly area: PlanArea;
  readonly isOut: boolean;
}

export class AreaMarks {
  readonly root = new Group();
  #plane = new PlaneGeometry(1, 1).rotateX(-Math.PI / 2);
  #out = paneMaterial('#e5605c');
  #in = paneMaterial('#4d8dff');

  show(areas: Areas | null, draft: DraftArea | null, sites: SceneInfo['sites'] | null): void {
    this.root.clear();
    if (!sites || sites.size.length === 0) return;
    const height = Math.max(...Array.from(sites.size, (_, site) => sites.position[3 * site + 1]!)) - lift;
    for (const area of areas?.keepOut ?? []) this.#add(area, this.#out, height);
    for (const area of areas?.keepIn ?? []) this.#add(area, this.#in, height);
    if (draft) this.#add(draft.area, draft.isOut ? this.#out : this.#in, height);
  }

  dispose(): void {
    this.root.clear();
    this.#plane.dispose();
    this.#out.dispose();
    this.#in.dispose();
  }

  #add([x, z, farX, farZ]: PlanArea, material: MeshBasicMaterial, height: number): void {
    const pane = new Mesh(this.#plane, material);
    pane.position.set((x + farX) / 2, height, (z + farZ) / 2);
    pane.scale.set(farX - x, 1, farZ - z);
    pane.renderOrder = 5;
    this.root.add(pane);
  }
}

function paneMaterial(color: string): MeshBasicMaterial {
  return new MeshBasicMaterial({
    color,
    transparent: true,
    opacity: 0.28,
    side: DoubleSide,
    depthWrite: false,
    toneMapped: false,
  });
}

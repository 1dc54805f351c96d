/** Areas in plan as tinted panes just below where the luminaires hang: red where none may, blue where they shall. */
import { DoubleSide, Group, Mesh, MeshBasicMaterial, PlaneGeometry } from 'three';
import type { AreaKind, MarkedArea } from '../../document/areas.ts';
import type { SceneInfo } from '../../document/types.ts';

const lift = 0.03; // m below the sites

const colors: Record<AreaKind, string> = { keepOut: '#e5605c', keepIn: '#4d8dff', select: '#9aa4b2' };

export class AreaMarks {
  readonly root = new Group();
  #plane = new PlaneGeometry(1, 1).rotateX(-Math.PI / 2);
  #materials = new Map<AreaKind, MeshBasicMaterial>();

  show(areas: readonly MarkedArea[], sites: SceneInfo['sites'] | null): void {
    this.root.clear();
    if (!sites || sites.size.length === 0) return;
    const height = Math.max(...Array.from(sites.size, (_, site) => sites.position[3 * site + 1]!)) - lift;
    for (const area of areas) this.#add(area, height);
  }

  dispose(): void {
    this.root.clear();
    this.#plane.dispose();
    for (const material of this.#materials.values()) material.dispose();
  }

  #add({ kind, area: [x, z, farX, farZ] }: MarkedArea, height: number): void {
    const material = this.#materials.get(kind) ?? paneMaterial(colors[kind]);
    this.#materials.set(kind, material);
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

/**
 * Areas in plan as tinted panes with an edge: just below where the luminaires hang, red where none may and blue where they
 * shall; green on the planes where a task is.
 */
import {
  BufferGeometry,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineLoop,
  Mesh,
  MeshBasicMaterial,
  Shape,
  ShapeGeometry,
  Vector2,
} from 'three';
import type { AreaKind, MarkedArea } from '../../document/areas.ts';
import type { SceneInfo } from '../../document/types.ts';

const lift = 0.03; // m below the sites, or above a plane
const tint = 0.28;
const strongTint = 0.45;

const colors: Record<AreaKind, string> = {
  keepOut: '#e5605c',
  keepIn: '#4d8dff',
  select: '#9aa4b2',
  task: '#16a37f',
  plane: '#7fb2ff',
};

export class AreaMarks {
  readonly root = new Group();

  show(areas: readonly MarkedArea[], sites: SceneInfo['sites'] | null): void {
    this.#clear();
    if (!sites || sites.size.length === 0) return;
    const top = Math.max(...Array.from(sites.size, (_, site) => sites.position[3 * site + 1]!)) - lift;
    for (const area of areas) this.#add(area, area.height === null ? top : area.height + lift);
  }

  dispose(): void {
    this.#clear();
  }

  #clear(): void {
    for (const child of this.root.children) {
      if (!(child instanceof Mesh || child instanceof LineLoop)) continue;
      child.geometry.dispose();
      child.material.dispose();
    }
    this.root.clear();
  }

  #add({ kind, outline, isStrong }: MarkedArea, height: number): void {
    const corners = outline.map(([x, z]) => new Vector2(x, -z));
    const color = colors[kind];
    const shared = { color, transparent: true, depthWrite: false, toneMapped: false };
    const opacity = isStrong ? strongTint : tint;
    const pane = new Mesh(
      new ShapeGeometry(new Shape(corners)),
      new MeshBasicMaterial({ ...shared, opacity, side: DoubleSide }),
    );
    const edge = new LineLoop(
      new BufferGeometry().setFromPoints(corners),
      new LineBasicMaterial({ ...shared, opacity: 0.9, depthTest: false }),
    );
    for (const part of [pane, edge]) {
      part.rotation.x = -Math.PI / 2; // from x, y of the drawing to x, -z of the room
      part.position.y = height;
      part.renderOrder = 5;
      this.root.add(part);
    }
  }
}

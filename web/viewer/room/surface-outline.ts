/**
 * Outlines of surfaces, made when first needed: thick lines around surfaces that are selected, hovered or told of,
 * and thin ones along every edge of the room in false colour, where light alone would not tell one wall from the next.
 */
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  type Material,
  type Object3D,
  type Plane,
  Vector3,
} from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import { joined } from '../../document/joined.ts';
import { inWorld } from './in-world.ts';
import { surfaceEdges } from './surface-edges.ts';
import { overPlaneShader, type PlaneUniforms } from '../light/plane-footprints.ts';
import type { LitMesh } from './room-mesh.ts';
import { atOnce, type Pieces } from '../stage/breath.ts';

const level = 0.02; // m of height that a ceiling may have
const hand = 0.1; // m
const crease = 35; // degrees: sharper edges inside a surface are drawn too

/** Line ends of the edges of meshes in world space, xyz each. */
function* edgesOf(meshes: readonly LitMesh[]): Pieces<Float32Array> {
  const parts: Float32Array[] = [];
  for (const { mesh } of meshes) {
    const { index, positions } = inWorld(mesh);
    parts.push(yield* surfaceEdges(index, positions, crease));
  }
  return joined(parts, Float32Array);
}

/** The same of one mesh in its own space. */
function edgesOfMesh({ geometry }: LitMesh['mesh']): Float32Array {
  const position = geometry.getAttribute('position');
  const index = geometry.index?.array ?? [...Array(position.count).keys()];
  return atOnce(surfaceEdges(index, position.array, crease));
}

/** Meshes that close the room above: level, facing down, within a hand of its highest point. */
function ceilingOf(room: readonly LitMesh[]): readonly LitMesh[] {
  const boxed = room
    .filter(({ measuring }) => !measuring)
    .map((lit) => ({ lit, box: new Box3().setFromObject(lit.mesh) }));
  const top = boxed.reduce((most, { box }) => Math.max(most, box.max.y), -Infinity);
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  const facesDown = ({ mesh }: LitMesh) => {
    const position = mesh.geometry.getAttribute('position');
    const corner = (i: number) => mesh.geometry.index?.getX(i) ?? i;
    a.fromBufferAttribute(position, corner(0));
    b.fromBufferAttribute(position, corner(1)).sub(a);
    c.fromBufferAttribute(position, corner(2)).sub(a);
    return b.cross(c).transformDirection(mesh.matrixWorld).y < -0.9;
  };
  return boxed
    .filter(({ lit, box }) => box.max.y - box.min.y < level && top - box.max.y < hand && facesDown(lit))
    .map(({ lit }) => lit);
}

/** The edge of the ceiling, line ends in world space, xyz each. */
export const rimOf = (room: readonly LitMesh[]): Pieces<Float32Array> => edgesOf(ceilingOf(room));

/**
 * Lines over the light on a measuring plane: no darker where many cross, and lighter than isolux lines, so that a chair is
 * no black spot on what is read there; lighter than little light, so that a sofa in the dark is seen. What is hardly below
 * the plane (seats, desks) is seen through it; beside the plane they are as thin as all others.
 */
export function outlineOver(uniforms: PlaneUniforms, aside: LineBasicMaterial): LineBasicMaterial {
  // note: "transparent", though it is not, so that it is drawn after the plane
  const lines = new LineBasicMaterial({ color: 0x62676f, transparent: true, toneMapped: false });
  const { r, g, b } = aside.color;
  lines.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = `${overPlaneShader}
varying vec3 vPlace;
${shader.vertexShader.replace(
  '#include <project_vertex>',
  `#include <project_vertex>
  vPlace = (modelMatrix * vec4(transformed, 1.0)).xyz;
  if (isOverPlane(vPlace, 0.35)) {
    vec4 nearer = projectionMatrix * vec4(mvPosition.xy, min(mvPosition.z + 0.4, -0.1), 1.0);
    gl_Position.z = nearer.z / nearer.w * gl_Position.w;
  }`,
)}`;
    shader.fragmentShader = `${overPlaneShader}
varying vec3 vPlace;
${shader.fragmentShader.replace(
  '#include <color_fragment>',
  `#include <color_fragment>
  if (!isOverPlane(vPlace, 0.35)) diffuseColor = vec4(${[r, g, b, aside.opacity].map((c) => c.toFixed(3)).join()});`,
)}`;
  };
  return lines;
}

/** What lines are around: what is selected, what the pointer is over, what something on the page tells of. */
type Outline = 'selected' | 'hovered' | 'told';

export class SurfaceOutlines {
  readonly root = new Group();
  #room: readonly LitMesh[] = [];
  #edges = new Map<number, Float32Array>();
  #selected = this.#material('#4f9dff', 2.5, 1);
  #through = this.#material('#4f9dff', 1.5, 0.35); // where the surface is hidden
  #hovered = this.#material('#ffffff', 2, 0.85);
  #thin = new LineBasicMaterial({ color: 0x000000, transparent: true, opacity: 0.42 });
  #over: LineBasicMaterial;
  #told = this.#material('#4f9dff', 2, 0.9);
  #shown = new Map<Outline, LineSegments2[]>();
  #drawing: LineSegments[] = [];
  #rim = new LineBasicMaterial({ color: 0x20242b, transparent: true, opacity: 0.38 });
  #ceiling: LineSegments | null = null;

  constructor(footprints: PlaneUniforms) {
    this.#over = outlineOver(footprints, this.#thin);
    this.#through.depthTest = false;
  }

  setRoom(room: readonly LitMesh[]): void {
    for (const which of ['selected', 'hovered', 'told'] as const) this.show(which, []);
    for (const lines of this.#drawing) {
      lines.removeFromParent();
      lines.geometry.dispose();
    }
    this.#drawing = [];
    this.#ceiling?.removeFromParent();
    this.#ceiling?.geometry.dispose();
    this.#ceiling = null;
    this.#room = room;
    this.#edges.clear();
  }

  show(which: Outline, surfaces: readonly number[]): void {
    for (const object of this.#shown.get(which) ?? []) {
      this.root.remove(object);
      object.geometry.dispose();
    }
    this.#shown.delete(which);
    const ends = surfaces.flatMap((surface) => [...this.#edgesOfSurface(surface)]);
    if (ends.length === 0) return;
    const geometry = new LineSegmentsGeometry().setPositions(ends);
    const materials = {
      selected: [this.#through, this.#selected],
      hovered: [this.#hovered],
      told: [this.#told],
    }[which];
    const objects = materials.map((material) => {
      const lines = new LineSegments2(geometry, material);
      lines.renderOrder = 6;
      this.root.add(lines);
      return lines;
    });
    this.#shown.set(which, objects);
  }

  /**
   * Thin lines along every edge of the room, or none. Each mesh carries its own, so they are cut away with it.
   * `through`: meshes whose lines are seen on measuring planes below them.
   */
  showAll(visible: boolean, through: ReadonlySet<Object3D> | null): void {
    if (visible && this.#drawing.length === 0) {
      for (const { mesh, measuring } of this.#room) {
        if (measuring) continue;
        const ends = edgesOfMesh(mesh);
        const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(ends, 3));
        const lines = new LineSegments(geometry, this.#thin);
        lines.renderOrder = 1;
        mesh.add(lines);
        this.#drawing.push(lines);
      }
    }
    for (const lines of this.#drawing) {
      lines.visible = visible;
      const isThrough = lines.parent !== null && through?.has(lines.parent) === true;
      lines.material = isThrough ? this.#over : this.#thin;
      lines.renderOrder = isThrough ? 3 : 1;
    }
  }

  /** The edge of the ceiling, which itself is cut away: where the room that is set ends above. `rim`: rimOf() it. */
  setRim(rim: Float32Array): void {
    const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(rim, 3));
    this.#ceiling = new LineSegments(geometry, this.#rim);
    this.#ceiling.renderOrder = 2;
    this.root.add(this.#ceiling);
  }

  showRim(visible: boolean): void {
    if (this.#ceiling) this.#ceiling.visible = visible;
  }

  /** Lines beyond the planes are not drawn. */
  clip(planes: Plane[] | null): void {
    for (const material of this.#materials) material.clippingPlanes = planes;
  }

  dispose(): void {
    this.setRoom([]);
    for (const material of this.#materials) material.dispose();
  }

  get #materials(): readonly Material[] {
    return [this.#selected, this.#through, this.#hovered, this.#told, this.#thin, this.#over, this.#rim];
  }

  #edgesOfSurface(surface: number): Float32Array {
    let ends = this.#edges.get(surface);
    if (!ends) {
      ends = atOnce(edgesOf(this.#room.filter((lit) => lit.surface === surface)));
      this.#edges.set(surface, ends);
    }
    return ends;
  }

  #material(color: string, linewidth: number, opacity: number): LineMaterial {
    const material = new LineMaterial({ color, linewidth, transparent: true, opacity });
    material.toneMapped = false;
    material.depthWrite = false;
    material.polygonOffset = true;
    material.polygonOffsetFactor = -4;
    material.polygonOffsetUnits = -4;
    return material;
  }
}

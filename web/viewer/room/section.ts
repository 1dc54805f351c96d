/**
 * A level cut through the picture: what is higher is not drawn, and lines show where walls are cut. Furniture stays
 * whole on the storeys whose floors are below the cut, with all that it carries, and goes with those above.
 */
import { BufferAttribute, type BufferGeometry, Mesh, MeshBasicMaterial, Plane, Vector3 } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import type { Box } from '../eye/framing.ts';
import {
  darkBack,
  darkRoof,
  darkShell,
  levelShell,
  noSection,
  type SharedUniforms,
} from '../light/light-material.ts';
import { forEachCut, type Solid } from './columns.ts';
import { partsOf, type Part } from './hung-meshes.ts';
import { inWorld } from './in-world.ts';
import { atOnce } from '../stage/breath.ts';
import type { RoomMesh } from './room-mesh.ts';
import { carry } from './standing.ts';
import { storeysOf, type Storey } from './storeys.ts';

const onFloor = 0.1; // m above a floor: what begins higher is carried by something
const belowCeiling = 0.2; // m: what reaches higher is part of the building
const below = 0.05; // m that a floor is below the cut, at least
const plates = 0.5; // m below a floor: what is there belongs to it
const floorDepth = 0.15; // m: carpets and steps are floor, too
const aHair = 1e-3; // m: what is level with the cut is drawn
const attribute = '_storey';

/** A mesh as it stands in the world. */
interface Piece {
  readonly mesh: Mesh;
  readonly solid: Solid;
}

/** What of some parts stands whole: the storey, counted from 1; 0 = the cut goes through it. `storeys`: from below. */
export function standingStoreys(parts: readonly Box[], storeys: readonly Storey[]): number[] {
  const result = parts.map(() => 0);
  storeys.forEach(({ floor, clear }, i) => {
    const top = storeys[i + 1]?.floor ?? Infinity;
    const isOwn = ({ min, max }: Box) =>
      min[1] > floor - onFloor && min[1] < top - onFloor && max[1] < floor + clear - belowCeiling;
    const stands = parts.map((part) => isOwn(part) && part.min[1] < floor + onFloor);
    carry(
      parts,
      stands,
      (part) => isOwn(parts[part]!),
      () => true,
    );
    stands.forEach((does, part) => does && (result[part] = i + 1));
  });
  return result;
}

export class Section {
  readonly lines = new LineSegments2(
    new LineSegmentsGeometry(),
    new LineMaterial({ color: '#3d444d', linewidth: 2, toneMapped: false }),
  );
  readonly #uniforms: SharedUniforms;
  readonly #plane = new Plane(new Vector3(0, -1, 0), noSection);
  #room: RoomMesh | null = null;
  #storeys: readonly Storey[] | null = null; // of the room, once they were asked for
  #pieces: readonly Piece[] | null = null;
  #cut: readonly Solid[] | null = null; // what the cut goes through
  #height: number | null = null;
  #cutAway = true;
  #backs: ReadonlySet<BufferGeometry> = new Set(); // other sides of sheets, as those within walls are

  constructor(uniforms: SharedUniforms) {
    this.#uniforms = uniforms;
    this.lines.renderOrder = 2;
    this.lines.visible = false;
    this.lines.frustumCulled = false;
  }

  setRoom(room: RoomMesh | null): void {
    this.#room = room;
    this.#backs = new Set(room?.lit.filter(({ back }) => back).map(({ mesh }) => mesh.geometry));
    this.#storeys = this.#pieces = this.#cut = null;
    this.#uniforms.building.value = false;
    this.#uniforms.openFrom.value = this.#uniforms.openTo.value = noSection;
    this.#show();
  }

  /** m, or null for the whole room; `cutAway`: the walls in front of the highest storey that is shown are not drawn. */
  set(height: number | null, cutAway: boolean): void {
    const isNew = height !== this.#height;
    this.#height = height;
    this.#cutAway = cutAway;
    if (isNew) this.#show();
  }

  get storeys(): readonly Storey[] {
    if (!this.#room) return [];
    if (!this.#storeys) {
      const solids = this.#allPieces.map(({ solid }) => solid);
      this.#storeys = storeysOf(solids, this.#room.box);
    }
    return this.#storeys;
  }

  /** Several storeys: it has outsides. False until somebody has asked for them. */
  get isBuilding(): boolean {
    return this.#storeys !== null && this.#storeys.length > 1;
  }

  /** Whether a height is that of a storey's floor. */
  isFloor(y: number): boolean {
    return this.isBuilding && this.storeys.some(({ floor }) => Math.abs(y - floor) < floorDepth);
  }

  /**
   * Before a picture: from within, a building has no outsides, and the storeys below the highest shown one are closed. A
   * single room with walls that have two sides shows no shell to an eye outside, where it is cut away.
   */
  look(eye: Vector3): void {
    const box = this.#room?.box;
    if (!box) return;
    const isWithin = eye.toArray().every((at, i) => at > box.min[i]! && at < box.max[i]!);
    const isOpened = this.#backs.size > 0 && this.#cutAway && !isWithin && !this.isBuilding;
    this.#uniforms.openTo.value = isOpened ? (box.min[1] + box.max[1]) / 2 : noSection;
    if (!this.isBuilding) return;
    const floor = isWithin ? -noSection : (this.#shown.at(-1)?.floor ?? -noSection);
    this.#uniforms.building.value = !isWithin;
    this.#uniforms.openFrom.value = this.#cutAway ? floor - plates : noSection;
  }

  /** Luminaires that hang higher belong to a storey that is not shown. */
  get ceiling(): number {
    if (this.#height === null) return Infinity;
    return this.storeys.find(({ floor }) => floor > this.#height! - below)?.floor ?? Infinity;
  }

  /** What built-in materials are clipped by. */
  get planes(): Plane[] | null {
    return this.#height === null ? null : [this.#plane];
  }

  /** Whether a point of a mesh is not drawn, by one of its vertices; `isBack`: it is seen from behind. */
  hides(geometry: BufferGeometry, vertex: number, y: number, isBack: boolean): boolean {
    if (isBack && y > this.#uniforms.openFrom.value) return true;
    if (!isBack && this.#isShell(geometry, vertex)) return true;
    if (this.#height === null) return false;
    const storey = geometry.getAttribute(attribute)?.getX(vertex) ?? 0;
    return storey > 0 ? storey > this.#uniforms.storeys.value : y > this.#height;
  }

  /** As the shader of the light has it. */
  #isShell(geometry: BufferGeometry, vertex: number): boolean {
    const { openTo, usualLight, lightTexture, sides } = this.#uniforms;
    const [patches, normals] = [geometry.getAttribute('_patches'), geometry.getAttribute('normal')];
    const light = (lightTexture.value?.image as { data: Float32Array } | undefined)?.data;
    if (openTo.value >= noSection || !patches || !normals || !light) return false;
    const normal = new Vector3().fromBufferAttribute(normals, vertex);
    const isLevel = Math.abs(normal.y) > levelShell;
    const most = isLevel ? darkRoof : this.#backs.has(geometry) ? darkBack : darkShell;
    const dark = most * usualLight.value;
    if ((light[patches.getX(vertex)] ?? 0) > dark) return false;
    const way = new Vector3().fromBufferAttribute(geometry.getAttribute('position'), vertex);
    const { x, y, z, w } = sides.value;
    way.sub(new Vector3((x + z) / 2, openTo.value, (y + w) / 2));
    if (isLevel) return normal.y > 0 && way.y > 0;
    return normal.x * way.x + normal.z * way.z > 0;
  }

  dispose(): void {
    this.lines.geometry.dispose();
    this.lines.material.dispose();
  }

  /** Everything but measuring planes. */
  get #allPieces(): readonly Piece[] {
    const surfaces = new Map(this.#room!.lit.map((lit) => [lit.mesh as Mesh, lit]));
    const pieces: Piece[] = [];
    if (!this.#pieces) {
      this.#room!.root.traverse((mesh) => {
        if (!(mesh instanceof Mesh) || surfaces.get(mesh)?.measuring) return;
        pieces.push({ mesh, solid: { ...inWorld(mesh), surface: surfaces.get(mesh)?.surface ?? -1 } });
      });
      this.#pieces = pieces;
    }
    return this.#pieces;
  }

  /** Marks what stands whole, once; returns the rest. */
  #sorted(): readonly Solid[] {
    const lit = this.#allPieces.filter(({ mesh }) => mesh.geometry.hasAttribute('_patches'));
    const parts: Part[] = lit.flatMap(({ mesh }) => atOnce(partsOf(mesh)));
    const storeys = standingStoreys(
      parts.map(({ box }) => box),
      this.storeys,
    );
    const whole = new Map<Mesh, Float32Array>();
    parts.forEach(({ mesh, triangles }, i) => {
      const index = mesh.geometry.index?.array;
      const marks = whole.get(mesh) ?? new Float32Array(mesh.geometry.getAttribute('position').count);
      whole.set(mesh, marks);
      for (const first of triangles)
        for (let corner = first; corner < first + 3; corner++) marks[index?.[corner] ?? corner] = storeys[i]!;
    });
    return this.#allPieces.map(({ mesh, solid }) => {
      const marks = whole.get(mesh);
      if (!marks?.some((mark) => mark > 0)) return solid;
      mesh.geometry.setAttribute(attribute, new BufferAttribute(marks, 1));
      const cut = Array.from(solid.index).filter((_, i, all) => marks[all[i - (i % 3)]!] === 0);
      return { ...solid, index: cut };
    });
  }

  #show(): void {
    const height = this.#room ? this.#height : null;
    this.lines.visible = height !== null;
    this.#uniforms.section.value = this.#plane.constant = (height ?? noSection) + aHair;
    this.#clip();
    this.#uniforms.storeys.value = height === null ? noSection : this.#shown.length;
    if (height === null) return;
    this.#cut ??= this.#sorted();
    const ends: number[] = [];
    for (const { index, positions } of this.#cut)
      forEachCut(index, positions, height, (ax, az, bx, bz) => ends.push(ax, height, az, bx, height, bz));
    this.lines.geometry.dispose();
    this.lines.geometry = new LineSegmentsGeometry().setPositions(ends);
    this.lines.visible = ends.length > 0;
  }

  /** Storeys whose floors are not cut off. */
  get #shown(): readonly Storey[] {
    return this.storeys.filter(({ floor }) => floor < (this.#height ?? noSection) - below);
  }

  /** Materials that are not ours (glass, a preview's) are clipped by planes. */
  #clip(): void {
    const planes = this.planes;
    this.#room?.root.traverse((object) => {
      if (!(object instanceof Mesh) || object.geometry.hasAttribute('_patches')) return;
      for (const material of [object.material].flat() as MeshBasicMaterial[])
        material.clippingPlanes = planes;
    });
  }
}

/** What lies under a point of the canvas: a luminaire, a surface, and the light there. */
import {
  Box3,
  DoubleSide,
  Raycaster,
  Vector2,
  Vector3,
  type Camera,
  type Mesh,
  type Object3D,
  type Ray,
} from 'three';
import type { LuminaireObject } from '../luminaires/luminaire-objects.ts';
import type { LitMesh } from '../room/room-mesh.ts';
import { barycentric, lightAtVertex } from '../light/probe.ts';
import { inWorld, type InWorld } from '../room/in-world.ts';
import { TriangleTree, type TreeHit } from '../room/triangle-tree.ts';
import { inTurn } from '../stage/breath.ts';

export interface Hit {
  readonly luminaire: number | null;
  readonly surface: number | null;
  readonly point: Vector3;
  readonly lux: number; // illuminance; 0 on a luminaire
  readonly exitance: number; // lm/m2
}

/** A mesh and the tree over its triangles; made when first needed. */
interface Indexed extends InWorld {
  readonly tree: TriangleTree;
}

/** Whether a place on a mesh, near one of its vertices, is not drawn; `isBack`: as seen from behind. */
export type Hidden = (mesh: LitMesh['mesh'], vertex: number, place: Vector3, isBack: boolean) => boolean;

const past = 1e-4; // m: so far behind a hit that does not count the next is looked for

/** In world space. */
function boxOf({ geometry, matrixWorld }: Mesh): Box3 {
  if (!geometry.boundingBox) geometry.computeBoundingBox();
  return new Box3().copy(geometry.boundingBox!).applyMatrix4(matrixWorld);
}

/** Meshes that a ray may meet. */
const onWay = (ray: Ray, room: readonly LitMesh[]) =>
  room.filter(({ mesh, measuring }) => !measuring && ray.intersectsBox(boxOf(mesh))).map(({ mesh }) => mesh);

export class Picking {
  #caster = new Raycaster();
  #canvas: HTMLCanvasElement;
  #hidden: Hidden;
  #indexed = new WeakMap<Mesh, Indexed>();
  #center = new Vector3();

  constructor(canvas: HTMLCanvasElement, hidden: Hidden) {
    this.#canvas = canvas;
    this.#hidden = hidden;
  }

  /** The ray through a point of the page (client coordinates). */
  ray(clientX: number, clientY: number, camera: Camera): Raycaster['ray'] {
    const frame = this.#canvas.getBoundingClientRect();
    const x = (2 * (clientX - frame.left)) / frame.width - 1;
    const y = 1 - (2 * (clientY - frame.top)) / frame.height;
    this.#caster.setFromCamera(new Vector2(x, y), camera);
    return this.#caster.ray;
  }

  pick(
    clientX: number,
    clientY: number,
    camera: Camera,
    room: readonly LitMesh[],
    luminaires: readonly LuminaireObject[],
    light: Float32Array | null,
    reflectance: Float32Array | null,
  ): Hit | null {
    this.ray(clientX, clientY, camera);
    // From behind, through a ceiling that is cut away, it is the housing that is seen.
    const shown = luminaires.filter(({ group }) => group.visible);
    const bodies: Object3D[] = shown.flatMap(({ panel, housing }) => [panel, housing]);
    const [body] = this.#caster.intersectObjects(bodies, false);
    const wall = this.#nearest(room, body?.distance ?? Infinity);
    if (wall) return this.#hitOf(wall.lit, wall.distance, wall.first, light, reflectance);
    if (!body) return null;
    const luminaire = luminaires.findIndex(({ group }) => group === body.object.parent);
    return { luminaire, surface: null, point: body.point, lux: 0, exitance: 0 };
  }

  /** Where the latest ray first meets something that is drawn. */
  pointOn(root: Object3D): Vector3 | null {
    return this.#caster.intersectObject(root, true)[0]?.point ?? null;
  }

  /** Makes ready what `reach` wants to know for a ray. */
  async prepare(ray: Ray, room: readonly LitMesh[]): Promise<void> {
    for (const mesh of onWay(ray, room)) {
      if (this.#indexed.has(mesh)) continue;
      const { index, positions } = inWorld(mesh);
      const tree = await inTurn(TriangleTree.growing(index, positions));
      this.#indexed.set(mesh, { index, positions, tree });
    }
  }

  /** How far a ray goes until it meets the front of something, drawn or not, m; Infinity where it leaves the room. */
  reach(ray: Ray, room: readonly LitMesh[]): number {
    let least = Infinity;
    for (const mesh of onWay(ray, room)) {
      const { tree } = this.#indexOf(mesh);
      const hit = tree.cast(ray.origin.toArray(), ray.direction.toArray(), false, least);
      if (hit) least = hit.distance;
    }
    return least;
  }

  #nearest(room: readonly LitMesh[], limit: number) {
    let best: { lit: LitMesh; distance: number; first: number } | null = null;
    for (const lit of room) {
      if (!lit.mesh.visible || this.#misses(lit.mesh)) continue;
      const hit = this.#nearestOn(lit, best?.distance ?? limit);
      if (hit) best = { lit, ...hit };
    }
    return best;
  }

  /** The nearest place of a mesh that is drawn. */
  #nearestOn({ mesh }: LitMesh, limit: number): TreeHit | null {
    const { origin, direction } = this.#caster.ray;
    const both = mesh.material.side === DoubleSide;
    const { tree, index } = this.#indexOf(mesh);
    for (let from = 0; ;) {
      const start = origin.clone().addScaledVector(direction, from);
      const hit = tree.cast(start.toArray(), direction.toArray(), both, limit - from);
      if (!hit) return null;
      const distance = from + hit.distance;
      const place = this.#caster.ray.at(distance, new Vector3());
      if (!this.#hidden(mesh, index[hit.first]!, place, tree.isBack)) return { ...hit, distance };
      from = distance + past;
    }
  }

  #misses(mesh: Mesh): boolean {
    if (!mesh.geometry.boundingSphere) mesh.geometry.computeBoundingSphere();
    const sphere = mesh.geometry.boundingSphere!;
    this.#center.copy(sphere.center).applyMatrix4(mesh.matrixWorld);
    const radius = sphere.radius * mesh.matrixWorld.getMaxScaleOnAxis();
    return this.#caster.ray.distanceSqToPoint(this.#center) > radius * radius;
  }

  #indexOf(mesh: Mesh): Indexed {
    let indexed = this.#indexed.get(mesh);
    if (!indexed) {
      const { index, positions } = inWorld(mesh);
      indexed = { index, positions, tree: TriangleTree.of(index, positions) };
      this.#indexed.set(mesh, indexed);
    }
    return indexed;
  }

  #hitOf(
    lit: LitMesh,
    distance: number,
    first: number,
    light: Float32Array | null,
    reflectance: Float32Array | null,
  ): Hit {
    const { index, positions } = this.#indexOf(lit.mesh);
    const point = this.#caster.ray.at(distance, new Vector3());
    const corners = [0, 1, 2].map((i) => index[first + i]!);
    const [a, b, c] = corners.map((v) => [0, 1, 2].map((axis) => positions[3 * v + axis]!));
    const share = barycentric(point.toArray(), a!, b!, c!);
    const { _patches: patches, _weights: weights } = lit.mesh.geometry.attributes;
    const lightHere = (reflecting?: Float32Array | null) =>
      corners.reduce((sum, vertex, i) => {
        if (!light || reflecting === null) return 0;
        return sum + share[i]! * lightAtVertex(vertex, patches!.array, weights!.array, light, reflecting);
      }, 0);
    const surface = lit.surface >= 0 ? lit.surface : null;
    return { luminaire: null, surface, point, lux: lightHere(), exitance: lightHere(reflectance) };
  }
}

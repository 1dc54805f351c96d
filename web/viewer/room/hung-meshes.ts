/** Takes a room's meshes apart where they hang on several walls, so that each part can be cut away with its wall. */
import { BufferAttribute, BufferGeometry, Mesh, type Object3D } from 'three';
import type { Box } from '../eye/framing.ts';
import { inWorld } from './in-world.ts';
import { connectedParts } from './mesh-parts.ts';
import { hangingSides, isRoomItself, isRug, type Side } from './standing.ts';
import type { Pieces } from '../stage/breath.ts';

const splittable = 60_000; // triangles; finer meshes are left whole

/** A connected part of a mesh: first indices of its triangles, and its box in world space. */
export interface Part {
  readonly mesh: Mesh;
  readonly triangles: readonly number[];
  readonly box: Box;
}

/** Box of some triangles (first indices) of a mesh whose positions are in world space. */
function boxOf(triangles: readonly number[], index: ArrayLike<number>, positions: ArrayLike<number>): Box {
  const min: [number, number, number] = [Infinity, Infinity, Infinity];
  const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (const first of triangles)
    for (let corner = first; corner < first + 3; corner++)
      for (let i = 0; i < 3; i++) {
        const value = positions[3 * index[corner]! + i]!;
        if (value < min[i]!) min[i] = value;
        if (value > max[i]!) max[i] = value;
      }
  return { min, max };
}

export function* partsOf(mesh: Mesh): Pieces<Part[]> {
  const { index, positions } = inWorld(mesh);
  const whole = !mesh.geometry.index || index.length > 3 * splittable;
  const every = () => Array.from({ length: Math.floor(index.length / 3) }, (_, i) => 3 * i);
  const parts = whole ? [every()] : yield* connectedParts(index, positions);
  return parts.map((triangles) => ({ mesh, triangles, box: boxOf(triangles, index, positions) }));
}

/** The triangles of `index` alone, with the vertices that they use. */
function indexedPart(geometry: BufferGeometry, index: readonly number[]): BufferGeometry {
  const part = new BufferGeometry();
  const used = [...new Set(index)];
  const place = new Map(used.map((vertex, i) => [vertex, i]));
  for (const [name, source] of Object.entries(geometry.attributes)) {
    const attribute = source as BufferAttribute;
    const size = attribute.itemSize;
    const values = new (attribute.array.constructor as Float32ArrayConstructor)(size * used.length);
    used.forEach((vertex, i) => {
      for (let c = 0; c < size; c++) values[size * i + c] = attribute.array[size * vertex + c]!;
    });
    part.setAttribute(name, new BufferAttribute(values, size, attribute.normalized));
  }
  return part.setIndex(index.map((vertex) => place.get(vertex)!));
}

/** Splits `mesh` by the sides of its parts; returns each side's mesh. */
function splitMesh(mesh: Mesh, parts: readonly { part: Part; side: Side | null }[]): [Mesh, Side | null][] {
  const { geometry } = mesh;
  const groups = new Map<string, { side: Side | null; triangles: number[] }>();
  for (const { part, side } of parts) {
    const key = side ? `${side.axis} ${side.sign}` : '';
    const group = groups.get(key) ?? { side, triangles: [] };
    groups.set(key, group);
    group.triangles.push(...part.triangles);
  }
  if (groups.size === 1) return [...groups.values()].map(({ side }) => [mesh, side]);
  const index = geometry.index!.array;
  const meshes = [...groups.values()].map(({ side, triangles }, i): [Mesh, Side | null] => {
    const own = i === 0 ? mesh : mesh.clone();
    own.geometry = indexedPart(
      geometry,
      triangles.flatMap((first) => [index[first]!, index[first + 1]!, index[first + 2]!]),
    );
    if (i > 0) mesh.parent?.add(own);
    return [own, side];
  });
  geometry.dispose();
  return meshes;
}

/** What hangs on the room's sides, each a mesh of its own from now on, and what stands in it. */
export interface SortedMeshes {
  readonly hanging: ReadonlyMap<Object3D, Side>;
  readonly standing: ReadonlySet<Object3D>;
  readonly rugs: ReadonlySet<Object3D>; // of what stands, what lies flat on the floor
}

/** `meshes` have their world matrices. */
export function* splitHungMeshes(meshes: readonly Mesh[], room: Box): Pieces<SortedMeshes> {
  const parts: Part[] = [];
  for (const mesh of meshes) {
    for (const part of yield* partsOf(mesh)) parts.push(part);
    yield;
  }
  const sides = hangingSides(
    room,
    parts.map(({ box }) => box),
  );
  const perMesh = new Map<Mesh, { part: Part; side: Side | null }[]>();
  parts.forEach((part, i) => {
    const list = perMesh.get(part.mesh) ?? [];
    perMesh.set(part.mesh, list);
    list.push({ part, side: sides[i] ?? null });
  });
  const hanging = new Map<Object3D, Side>();
  const [standing, rugs] = [new Set<Object3D>(), new Set<Object3D>()];
  for (const [mesh, own] of perMesh) {
    for (const [piece, side] of splitMesh(mesh, own))
      if (side) hanging.set(piece, side);
      else if (own.every(({ part, side: of }) => of !== null || !isRoomItself(room, part.box))) {
        standing.add(piece);
        if (own.every(({ part, side: of }) => of !== null || isRug(room, part.box))) rugs.add(piece);
      }
    yield;
  }
  return { hanging, standing, rugs };
}

/** What of an IFC building can be lit by itself: the whole of it, a storey, a space; each as a binary glTF of what lies there. */
import { linearFromSrgb, type Rgb } from '../../../document/linear-colour.mjs';
import { writeGlb } from '../../../document/gltf-container.ts';
import type { IfcBuilding, Piece } from './ifc-building.ts';
import { boxOf, everywhere, meets, within, type Box, type Mesh } from './pieces.ts';

export interface IfcPlace {
  readonly kind: 'building' | 'storey' | 'space';
  readonly name: string; // '' where the file has none
  readonly size: readonly [width: number, depth: number] | null; // m, of a space
  readonly box: Box; // what is outside is cut off
  readonly near: Box; // elements that do not come so far belong to a neighbour
}

const around = 0.35; // m beside and below a space that belong to it: half a thick wall, the floor
const above = 0.6; // m: up to the slab where the space ends at a suspended ceiling
const touching = 0.05; // m beside a space: walls stand there
const belowStorey = 0.3; // m: the slab that it stands on
const aboveStorey = 0.15; // m over the next floor: that floor, which is the ceiling here

/** A storey comes before its spaces; the building first, unless it is one storey or one space. */
export function placesOf({ storeys, spaces }: IfcBuilding): readonly IfcPlace[] {
  const spacesOf = (storey: number | null): IfcPlace[] =>
    spaces
      .filter((space) => space.storey === storey)
      .sort((one, other) => one.name.localeCompare(other.name, undefined, { numeric: true }))
      .map(({ name, box }) => ({
        kind: 'space',
        name,
        size: footprint(box),
        box: grown(box, around),
        near: grown(box, touching),
      }));
  const known = new Set<number | null>(storeys.map(({ id }) => id));
  const floors = storeys.flatMap(({ id, name, floor }, i): IfcPlace[] => {
    const next = storeys.slice(i + 1).find((other) => other.floor > floor + belowStorey)?.floor ?? Infinity;
    const box: Box = {
      min: [-Infinity, floor - belowStorey, -Infinity],
      max: [Infinity, next + aboveStorey, Infinity],
    };
    return [{ kind: 'storey', name, size: null, box, near: box }, ...spacesOf(id)];
  });
  const others = [...new Set(spaces.map(({ storey }) => storey))].filter((storey) => !known.has(storey));
  const places = [...floors, ...others.flatMap(spacesOf)];
  return places.length === 1
    ? places
    : [{ kind: 'building', name: '', size: null, box: everywhere, near: everywhere }, ...places];
}

const footprint = ({ min, max }: Box) => [max[0] - min[0], max[2] - min[2]] as const;

const grown = ({ min, max }: Box, beside: number): Box => ({
  min: [min[0] - beside, min[1] - around, min[2] - beside],
  max: [max[0] + beside, max[1] + above, max[2] + beside],
});

/** null where nothing lies there. It stands on the origin: survey coordinates are too far away for floats. */
export function glbOfPlace(
  { pieces, names }: IfcBuilding,
  { box, near }: IfcPlace,
): Uint8Array<ArrayBuffer> | null {
  const inside = pieces.flatMap((piece) => {
    const own = boxOf([piece.mesh]);
    if (!meets(own, near)) return [];
    const mesh = box === everywhere ? piece.mesh : within(piece.mesh, box);
    return mesh ? [{ ...piece, mesh }] : [];
  });
  if (inside.length === 0) return null;
  const writing = new Writing(boxOf(inside.map(({ mesh }) => mesh)));
  for (const [element, name] of names) {
    const own = inside.filter((piece) => piece.element === element);
    if (own.length > 0) writing.node(name, own);
  }
  return writing.glb();
}

const [float, unsigned] = [5126, 5125];

interface AccessorKind {
  readonly componentType: number;
  readonly type: 'SCALAR' | 'VEC3';
  readonly min?: readonly number[];
  readonly max?: readonly number[];
}

/** A glTF that grows node by node. */
class Writing {
  readonly #nodes: object[] = [];
  readonly #meshes: object[] = [];
  readonly #materials: object[] = [];
  readonly #materialKeys = new Map<string, number>();
  readonly #accessors: object[] = [];
  readonly #views: object[] = [];
  readonly #parts: (Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>)[] = [];
  readonly #origin: readonly number[];
  #size = 0;

  constructor({ min, max }: Box) {
    this.#origin = [(min[0] + max[0]) / 2, min[1], (min[2] + max[2]) / 2];
  }

  node(name: string, pieces: readonly Piece[]): void {
    const primitives = pieces.map((piece) => ({
      attributes: { POSITION: this.#positions(piece.mesh) },
      indices: this.#accessor(piece.mesh.indices, { componentType: unsigned, type: 'SCALAR' }),
      ...this.#material(piece),
    }));
    this.#nodes.push({ name, mesh: this.#meshes.push({ name, primitives }) - 1 });
  }

  glb(): Uint8Array<ArrayBuffer> {
    const bytes = new Uint8Array(this.#size);
    let at = 0;
    for (const { buffer, byteOffset, byteLength } of this.#parts) {
      bytes.set(new Uint8Array(buffer, byteOffset, byteLength), at);
      at += byteLength;
    }
    const nodes = this.#nodes.map((_, i) => i);
    return writeGlb(
      {
        asset: { version: '2.0', generator: 'Fiat Lux, from IFC' },
        scene: 0,
        scenes: [{ nodes }],
        nodes: this.#nodes,
        meshes: this.#meshes,
        materials: this.#materials,
        accessors: this.#accessors,
        bufferViews: this.#views,
        buffers: [{ byteLength: this.#size }],
      },
      bytes,
    );
  }

  #positions({ positions, indices }: Mesh): number {
    const moved = positions.map((value, i) => value - this.#origin[i % 3]!);
    const { min, max } = boxOf([{ positions: moved, indices }]);
    return this.#accessor(moved, { componentType: float, type: 'VEC3', min, max });
  }

  #accessor(part: Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>, rest: AccessorKind): number {
    this.#views.push({ buffer: 0, byteOffset: this.#size, byteLength: part.byteLength });
    this.#parts.push(part);
    this.#size += part.byteLength;
    const count = part.length / (rest.type === 'VEC3' ? 3 : 1);
    return this.#accessors.push({ ...rest, bufferView: this.#views.length - 1, count }) - 1;
  }

  /** None where the file says neither a colour nor a name: what the surface is decides how much it reflects. */
  #material({ material: name, color, reflectance, opacity }: Piece): { material?: number } {
    if (!name && !color && !reflectance && opacity >= 1) return {};
    const linear: Rgb = reflectance ?? (color?.map(linearFromSrgb) as Rgb | undefined) ?? [1, 1, 1];
    const key = JSON.stringify([name, linear, opacity]);
    const index =
      this.#materialKeys.get(key) ??
      this.#materials.push({
        ...(name && { name }),
        pbrMetallicRoughness: {
          baseColorFactor: [...linear, opacity],
          metallicFactor: 0,
          roughnessFactor: 0.9,
        },
        ...(opacity < 1 && { alphaMode: 'BLEND' }),
      }) - 1;
    this.#materialKeys.set(key, index);
    return { material: index };
  }
}

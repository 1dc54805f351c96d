/**
 * An .ifc as triangles by element, and the places in it that can be lit by themselves: its storeys from below, and the
 * spaces of each (IfcSpace). Terrain, openings and luminaires of the file are left out: light does not need them.
 */
import type { FlatMesh, IfcAPI } from 'web-ifc';
import type { Rgb } from '../../../document/linear-colour.mjs';
import { IfcLines, materialsByElement, stylesByItem, textOf, type Style } from './ifc-styles.ts';
import { boxOf, type Box, type Mesh } from './pieces.ts';

/** What one element has of one material. */
export interface Piece {
  readonly element: number;
  readonly material: string; // '' where the file names none
  readonly color: Rgb | null; // sRGB; null: the file has none
  readonly reflectance: Rgb | null;
  readonly opacity: number;
  readonly mesh: Mesh;
}

export interface Storey {
  readonly id: number;
  readonly name: string;
  readonly floor: number; // m
}

export interface Space {
  readonly name: string;
  readonly storey: number | null; // its id
  readonly box: Box;
}

export interface IfcBuilding {
  readonly pieces: readonly Piece[];
  readonly names: ReadonlyMap<number, string>; // of elements
  readonly storeys: readonly Storey[]; // from below
  readonly spaces: readonly Space[];
  readonly luminaires: number; // that were left out
}

export type IfcFault = 'noIfc' | 'noGeometry' | 'tooMuch';

const mostTriangles = 5e6; // as the builder accepts them
const silent = 6; // a level of the library's log
const skipped = /^IFC(SITE|SPACE|OPENING.*|ANNOTATION|GRID|GEOGRAPHICELEMENT|VIRTUALELEMENT|LIGHTFIXTURE.*)$/;

/** note: the library logs and goes on where bytes are no IFC at all, so that is looked for here. */
export function readIfc(api: IfcAPI, bytes: Uint8Array): IfcBuilding | IfcFault {
  if (
    !/^[\s\uFEFF]*(\/\*[\s\S]*?\*\/\s*)*ISO-10303-21\s*;/.test(
      new TextDecoder().decode(bytes.subarray(0, 4096)),
    )
  )
    return 'noIfc';
  api.SetLogLevel(silent);
  const model = api.OpenModel(bytes);
  if (model < 0) return 'noIfc';
  try {
    return new Reading(api, model).building();
  } finally {
    api.CloseModel(model);
  }
}

class Reading {
  readonly #api: IfcAPI;
  readonly #model: number;
  readonly #lines: IfcLines;
  readonly #styles: ReadonlyMap<number, Style>;
  readonly #materials: ReadonlyMap<number, string>;
  #triangles = 0;

  constructor(api: IfcAPI, model: number) {
    this.#api = api;
    this.#model = model;
    this.#lines = new IfcLines(api, model);
    this.#styles = stylesByItem(this.#lines);
    this.#materials = materialsByElement(this.#lines);
  }

  building(): IfcBuilding | IfcFault {
    const pieces: Piece[] = [];
    const luminaires = new Set<number>();
    let sample: number | null = null;
    this.#api.StreamAllMeshes(this.#model, (mesh) => {
      const entity = this.#lines.entityOf(mesh.expressID);
      if (entity.startsWith('IFCLIGHTFIXTURE')) luminaires.add(mesh.expressID);
      if (skipped.test(entity) || this.#triangles > mostTriangles) return;
      sample ??= mesh.expressID;
      pieces.push(...this.#piecesOf(mesh));
    });
    if (this.#triangles > mostTriangles) return 'tooMuch';
    if (sample === null || pieces.length === 0) return 'noGeometry';
    const names = new Map(pieces.map(({ element }) => [element, this.#nameOf(element)]));
    const storeys = this.#storeys(this.#unit(sample));
    return { pieces, names, storeys, spaces: this.#spaces(), luminaires: luminaires.size };
  }

  #piecesOf({ expressID: element, geometries }: FlatMesh): Piece[] {
    const pieces: Piece[] = [];
    for (let i = 0; i < geometries.size(); i++) {
      const { geometryExpressID, color, flatTransformation } = geometries.get(i);
      const mesh = this.#meshOf(geometryExpressID, flatTransformation);
      this.#triangles += mesh.indices.length / 3;
      if (mesh.indices.length === 0) continue;
      const style = this.#styles.get(geometryExpressID);
      const isPlain = Math.min(color.x, color.y, color.z) >= 1;
      pieces.push({
        element,
        material: style?.name || (this.#materials.get(element) ?? ''),
        color: isPlain ? null : [color.x, color.y, color.z],
        reflectance: style?.reflectance ?? null,
        opacity: color.w,
        mesh,
      });
    }
    return pieces;
  }

  /** In metres, y upwards; what is mirrored keeps its front. */
  #meshOf(geometry: number, m: readonly number[]): Mesh {
    const read = this.#api.GetGeometry(this.#model, geometry);
    const vertices = this.#api.GetVertexArray(read.GetVertexData(), read.GetVertexDataSize());
    const indices = this.#api.GetIndexArray(read.GetIndexData(), read.GetIndexDataSize()).slice();
    const positions = new Float32Array(vertices.length / 2);
    for (let i = 0; i < vertices.length / 6; i++) {
      const [x, y, z] = [vertices[6 * i]!, vertices[6 * i + 1]!, vertices[6 * i + 2]!];
      for (let row = 0; row < 3; row++)
        positions[3 * i + row] = m[row]! * x + m[4 + row]! * y + m[8 + row]! * z + m[12 + row]!;
    }
    if (determinant(m) < 0)
      for (let i = 0; i < indices.length; i += 3)
        [indices[i], indices[i + 1]] = [indices[i + 1]!, indices[i]!];
    read.delete();
    return { positions, indices: indices as Mesh['indices'] };
  }

  /** Metres per unit of the file, by an element that is read in both. */
  #unit(element: number): number {
    const length = (inMetres: boolean) => {
      const [x = 0, y = 0, z = 0] = this.#api
        .GetFlatMesh(this.#model, element, inMetres)
        .geometries.get(0).flatTransformation;
      return Math.hypot(x, y, z);
    };
    const unit = length(true) / length(false);
    return Number.isFinite(unit) && unit > 0 ? unit : 1;
  }

  /** As the file calls it, or by what it is; a ceiling says so. */
  #nameOf(element: number): string {
    const line = this.#lines.line(element);
    const kind = this.#api
      .GetNameFromTypeCode(this.#api.GetLineType(this.#model, element))
      .replace(/^Ifc|StandardCase$/g, '');
    const name = textOf(line, 'Name') || kind;
    const isCeiling = textOf(line, 'PredefinedType') === 'CEILING';
    return isCeiling && !/ceiling|decke/i.test(name) ? `Ceiling ${name}` : name;
  }

  #storeys(unit: number): Storey[] {
    const storeys = this.#lines.ids('IFCBUILDINGSTOREY').map((id) => {
      const line = this.#lines.line(id);
      const [placement] = this.#lines.named(line, 'ObjectPlacement');
      const height =
        placement === undefined ? NaN : this.#api.GetWorldTransformMatrix(this.#model, placement)[14];
      return { id, name: textOf(line, 'Name') || textOf(line, 'LongName'), floor: unit * (height ?? NaN) };
    });
    return storeys.filter(({ floor }) => Number.isFinite(floor)).sort((a, b) => a.floor - b.floor);
  }

  /** Those that have a shape. */
  #spaces(): Space[] {
    const storeyOf = new Map<number, number>();
    for (const id of this.#lines.ids('IFCRELAGGREGATES')) {
      const relation = this.#lines.line(id);
      const [whole] = this.#lines.named(relation, 'RelatingObject');
      for (const part of this.#lines.named(relation, 'RelatedObjects')) storeyOf.set(part, whole!);
    }
    return this.#lines.ids('IFCSPACE').flatMap((id) => {
      const line = this.#lines.line(id);
      const meshes = this.#piecesOf(this.#api.GetFlatMesh(this.#model, id)).map(({ mesh }) => mesh);
      if (meshes.length === 0) return [];
      const [name, long] = [textOf(line, 'Name'), textOf(line, 'LongName')];
      const title = [name, long].filter((part, i, all) => part && all.indexOf(part) === i).join(' ');
      return [{ name: title, storey: storeyOf.get(id) ?? null, box: boxOf(meshes) }];
    });
  }
}

/** Of the upper left 3 x 3, by columns. */
function determinant([
  a = 0,
  b = 0,
  c = 0,
  ,
  d = 0,
  e = 0,
  f = 0,
  ,
  g = 0,
  h = 0,
  i = 0,
]: readonly number[]): number {
  return a * (e * i - f * h) - d * (b * i - c * h) + g * (b * f - c * e);
}

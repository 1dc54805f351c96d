/**
 * What the parts of an IFC model are made of: the name of an item's surface style or else of its element's material, and
 * the diffuse reflectance where a style says one for lighting (IfcSurfaceStyleLighting).
 */
import type { IfcAPI } from 'web-ifc';
import type { Rgb } from '../../../document/linear-colour.mjs';

type Line = Record<string, unknown>;

/** A model that is open, asked by entity. */
export class IfcLines {
  readonly #api: IfcAPI;
  readonly #model: number;

  constructor(api: IfcAPI, model: number) {
    this.#api = api;
    this.#model = model;
  }

  ids(entity: string): number[] {
    const ids = this.#api.GetLineIDsWithType(this.#model, this.#api.GetTypeCodeFromName(entity));
    return Array.from({ length: ids.size() }, (_, i) => ids.get(i));
  }

  /** Upper case. */
  entityOf(id: number): string {
    return this.#api.GetNameFromTypeCode(this.#api.GetLineType(this.#model, id)).toUpperCase();
  }

  /** An empty one where the file names a line that it does not have. */
  line(id: number): Line {
    return this.#api.GetLine(this.#model, id) ?? {};
  }

  /** The lines that an attribute names, one or a list of them. */
  named(line: Line, attribute: string): number[] {
    const all = [line[attribute]].flat() as ({ type?: number; value?: unknown } | null | undefined)[];
    return all.flatMap((each) => (each?.type === 5 && typeof each.value === 'number' ? [each.value] : []));
  }
}

/** '' where there is none. */
export function textOf(line: Line, attribute: string): string {
  const { value } = (line[attribute] ?? {}) as { value?: unknown };
  return typeof value === 'string' ? value.trim() : '';
}

function numberOf(line: Line, attribute: string): number {
  const value = line[attribute] as { value?: unknown; _representationValue?: unknown } | number | null;
  const number = typeof value === 'object' && value ? (value._representationValue ?? value.value) : value;
  return typeof number === 'number' ? number : NaN;
}

export interface Style {
  readonly name: string;
  readonly reflectance: Rgb | null;
}

/** By representation item. */
export function stylesByItem(lines: IfcLines): ReadonlyMap<number, Style> {
  const styles = new Map<number, Style>();
  for (const id of lines.ids('IFCSTYLEDITEM')) {
    const styled = lines.line(id);
    const [item] = lines.named(styled, 'Item');
    const [style] = lines.named(styled, 'Styles').flatMap((each) => surfaceStyles(lines, each));
    if (item === undefined || style === undefined) continue;
    styles.set(item, { name: textOf(lines.line(style), 'Name'), reflectance: reflectanceOf(lines, style) });
  }
  return styles;
}

/** note: IFC2x3 puts an assignment between. */
function surfaceStyles(lines: IfcLines, id: number): number[] {
  const entity = lines.entityOf(id);
  if (entity === 'IFCSURFACESTYLE') return [id];
  if (entity !== 'IFCPRESENTATIONSTYLEASSIGNMENT') return [];
  return lines.named(lines.line(id), 'Styles').filter((each) => lines.entityOf(each) === 'IFCSURFACESTYLE');
}

function reflectanceOf(lines: IfcLines, style: number): Rgb | null {
  const parts = lines.named(lines.line(style), 'Styles');
  const light = parts.find((part) => lines.entityOf(part) === 'IFCSURFACESTYLELIGHTING');
  const [colour] = light === undefined ? [] : lines.named(lines.line(light), 'DiffuseReflectionColour');
  if (colour === undefined) return null;
  const line = lines.line(colour);
  const rgb = ['Red', 'Green', 'Blue'].map((name) => numberOf(line, name)) as [number, number, number];
  return rgb.every((value) => value >= 0 && value <= 1) ? rgb : null;
}

/** Names of materials by element: the first one, where it has several. */
export function materialsByElement(lines: IfcLines): ReadonlyMap<number, string> {
  const materials = new Map<number, string>();
  for (const id of lines.ids('IFCRELASSOCIATESMATERIAL')) {
    const relation = lines.line(id);
    const [material] = lines.named(relation, 'RelatingMaterial');
    const name = material === undefined ? '' : materialName(lines, material, 0);
    for (const element of lines.named(relation, 'RelatedObjects')) if (name) materials.set(element, name);
  }
  return materials;
}

const inward = ['ForLayerSet', 'ForProfileSet', 'MaterialLayers', 'MaterialProfiles', 'MaterialConstituents', 'Materials', 'Material']; // prettier-ignore
const mostDeep = 5; // usage, set, layer, material: a file may go in circles

function materialName(lines: IfcLines, id: number, depth: number): string {
  const line = lines.line(id);
  if (lines.entityOf(id) === 'IFCMATERIAL' || depth === mostDeep) return textOf(line, 'Name');
  for (const attribute of inward)
    for (const part of lines.named(line, attribute).slice(0, 1)) {
      const name = materialName(lines, part, depth + 1);
      if (name) return name;
    }
  return '';
}

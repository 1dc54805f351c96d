/**
 * How a model is to be understood, as a person may choose it before it is lit: the unit of its numbers, which way is up, where
 * luminaires hang, what its materials reflect. The builder gets options, and a file in which the rest is written down.
 */
import {
  facings,
  uses,
  usualOptions,
  type BuildOptions,
  type Survey,
  type SurveyedSurface,
} from '../../builder/builder.ts';
import type { Model } from '../../builder/protocol.ts';
import { readContainer, writeGlb } from '../../document/gltf-container.ts';
import { luminance, type Rgb } from '../../document/linear-colour.mjs';

export interface ModelChoices {
  readonly unit: number; // metres; 0: 1, or a guess where that is absurd
  readonly up: 'y' | 'z';
  readonly mounts: readonly string[]; // surfaces; none: those that are proposed
  readonly ceiling: number; // m, of a plane over the largest floor; 0: only where there is no ceiling
  readonly doubleSided: boolean;
  readonly reflectances: Readonly<Record<number, number>>; // by material
}

export const usualChoices: ModelChoices = {
  unit: 0,
  up: 'y',
  mounts: [],
  ceiling: 0,
  doubleSided: false,
  reflectances: {},
};

export interface ModelMaterial {
  readonly index: number;
  readonly name: string; // '' where it has none
  readonly reflectance: number | null; // null: a picture says it, or what the surface is (pure white, no colour yet)
  readonly hasPicture: boolean;
}

/** Those parts of a glTF's JSON that are touched. */
interface Gltf {
  scene?: number;
  scenes?: { nodes?: number[] }[];
  nodes?: object[];
  materials?: {
    name?: string;
    pbrMetallicRoughness?: { baseColorFactor?: number[]; baseColorTexture?: unknown };
  }[];
  meshes?: { primitives?: { material?: number }[] }[];
}

const most = 0.95; // of a reflectance
const turned = Math.SQRT1_2; // a quarter about x, as a quaternion

function colorOf(factor: readonly number[] | undefined): Rgb {
  const [r = 1, g = 1, b = 1] = factor ?? [];
  return [r, g, b];
}

/** The materials that a mesh has, in the file's order; none where the file cannot be read. */
export function materialsOf(glb: Model['bytes']): readonly ModelMaterial[] {
  try {
    const { materials = [], meshes = [] } = JSON.parse(readContainer(glb).text) as Gltf;
    const used = new Set(meshes.flatMap(({ primitives = [] }) => primitives.map(({ material }) => material)));
    return materials.flatMap(({ name = '', pbrMetallicRoughness: own }, index) => {
      if (!used.has(index)) return [];
      const hasPicture = own?.baseColorTexture !== undefined;
      const color = colorOf(own?.baseColorFactor);
      const isWhite = Math.min(...color) >= 1;
      return [{ index, name, hasPicture, reflectance: hasPicture || isWhite ? null : luminance(color) }];
    });
  } catch {
    return [];
  }
}

export function chosenOptions({ unit, mounts, ceiling, doubleSided }: ModelChoices): BuildOptions {
  return { ...usualOptions, scale: unit, mounts, ceiling, doubleSided };
}

/** The model with its choices written down; itself where there are none that a file can hold. */
export function chosenModel(model: Model, { up, reflectances }: ModelChoices): Model {
  const asked = Object.entries(reflectances);
  if (up === 'y' && asked.length === 0) return model;
  const { text, bin } = readContainer(model.bytes);
  const gltf = JSON.parse(text) as Gltf;
  for (const [index, reflectance] of asked) {
    const material = gltf.materials?.[Number(index)];
    if (material) material.pbrMetallicRoughness = repainted(material.pbrMetallicRoughness, reflectance);
  }
  if (up === 'z') stand(gltf);
  return { ...model, bytes: writeGlb(gltf, bin) };
}

/** Of the same hue as far as it stays a colour, and grey where a picture said what it was. */
function repainted(own: NonNullable<Gltf['materials']>[number]['pbrMetallicRoughness'], reflectance: number) {
  const { baseColorTexture: picture, ...rest } = own ?? {};
  const color = picture === undefined ? colorOf(rest.baseColorFactor) : ([1, 1, 1] satisfies Rgb);
  const wanted = Math.min(most, Math.max(0, reflectance));
  const now = luminance(color);
  const scaled = color.map((value) => (now > 0 ? (value * wanted) / now : wanted));
  const isColor = scaled.every((value) => value <= 1);
  const baseColorFactor = [...(isColor ? scaled : [wanted, wanted, wanted]), 1];
  return { ...rest, baseColorFactor };
}

/** From z up to y up. */
function stand(gltf: Gltf): void {
  const scene = gltf.scenes?.[gltf.scene ?? 0];
  if (!scene?.nodes?.length) return;
  gltf.nodes = [...(gltf.nodes ?? []), { rotation: [-turned, 0, 0, turned], children: scene.nodes }];
  scene.nodes = [gltf.nodes.length - 1];
}

interface Understood {
  readonly choices: ModelChoices;
  readonly survey: Survey | null;
}

/** Where luminaires would hang: what was chosen, or else what is proposed. */
export function mountsIn({ choices, survey }: Understood): readonly string[] {
  if (choices.mounts.length > 0) return choices.mounts;
  return survey?.surfaces.filter(({ use }) => use === uses.mount).map(({ name }) => name) ?? [];
}

/** Where luminaires would hang, and then what else faces down, the largest first: so many, and all of the former. */
export function hangable(state: Understood, most: number): readonly SurveyedSurface[] {
  const hung = mountsIn(state);
  const all = state.survey?.surfaces ?? [];
  const isHung = ({ name }: SurveyedSurface) => hung.includes(name);
  const others = all.filter((surface) => !isHung(surface) && surface.facing === facings.down);
  const shown = all.filter(isHung);
  return [...shown, ...others.slice(0, Math.max(0, most - shown.length))];
}

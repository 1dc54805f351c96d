/**
 * How a model is to be understood, as a person may choose it before it is lit: the unit of its numbers, which way is up,
 * where luminaires hang and how large they are, what is measured, what its materials reflect. All of it is options of
 * the command, too, so the scene file remembers it.
 */
import * as v from 'valibot';
import {
  facings,
  lids,
  uses,
  usualOptions,
  type BuildOptions,
  type Survey,
  type SurveyedSurface,
} from '../../builder/builder.ts';
import type { Model } from '../../builder/protocol.ts';
import { readContainer } from '../../document/gltf-container.ts';
import type { PlanOutline } from '../../document/types.ts';
import { luminance, type Rgb } from '../../document/linear-colour.mjs';
import { toldIn } from '../../language/faults.ts';

/** A level measuring plane that was drawn in the plan of the room. */
export interface DrawnPlane {
  readonly name: string;
  readonly outline: PlanOutline; // the room's x and z, m
  readonly height: number; // m, the room's y
  readonly border: number; // m, that is left out along its edges
}

export interface ModelChoices {
  readonly unit: number; // metres; 0: 1, or a guess where that is absurd
  readonly up: '' | 'y' | 'z'; // '': y, but where a room would lie on its back
  readonly mounts: readonly string[]; // surfaces; none: those that are proposed
  readonly ceiling: number; // m, of a plane over the largest floor; 0: only where there is no ceiling
  readonly patch: number; // m, edge of a patch; 0: as proposed
  readonly siteSpacing: number; // m, from luminaire to luminaire; 0: as proposed
  readonly siteSize: number; // m, side of a luminaire; 0: the spacing
  readonly drop: number; // m, below where they hang; 0: what the file says
  readonly plane: number; // m, of the working plane over the floor; 0: none
  readonly planeRim: number; // m, that it stays away from the floor's edges
  readonly drawn: readonly DrawnPlane[]; // other measuring planes; the only choice that is no option of the command
  readonly inside: readonly number[]; // m: x, y, z of a point in the only room that is lit; none: all of it
  readonly doors: number; // open ones that one may pass from there
  readonly lid: number; // of `lids`, on what then stays open
  readonly doubleSided: boolean;
  readonly reflectances: Readonly<Record<string, number>>; // by material
}

export const usualChoices: ModelChoices = {
  unit: 0,
  up: '',
  mounts: [],
  ceiling: 0,
  patch: 0,
  siteSpacing: 0,
  siteSize: 0,
  drop: 0,
  plane: 0,
  planeRim: usualOptions.planeRim,
  drawn: [],
  inside: [],
  doors: 0,
  lid: lids.none,
  doubleSided: false,
  reflectances: {},
};

const number = v.pipe(v.number(), v.finite());
const drawnPlane = v.object({
  name: v.string(),
  outline: v.pipe(v.array(v.tuple([number, number])), v.minLength(3)),
  height: number,
  border: v.pipe(number, v.minValue(0)),
});

export { lids };
export const mostDoors = 20;

const metres = v.optional(v.pipe(v.number(), v.finite(), v.minValue(0)), 0);
const choicesSchema = v.object({
  unit: metres,
  up: v.optional(v.picklist(['', 'y', 'z']), ''),
  mounts: v.optional(v.array(v.string()), []),
  ceiling: metres,
  patch: metres,
  siteSpacing: metres,
  siteSize: metres,
  drop: metres,
  plane: metres,
  planeRim: v.optional(v.pipe(v.number(), v.finite(), v.minValue(0)), usualOptions.planeRim),
  drawn: v.optional(v.array(drawnPlane), []),
  inside: v.optional(v.union([v.strictTuple([]), v.strictTuple([number, number, number])]), []),
  doors: v.optional(v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(mostDoors)), 0),
  lid: v.optional(v.picklist(Object.values(lids)), lids.none),
  doubleSided: v.optional(v.boolean(), false),
  reflectances: v.optional(v.record(v.string(), v.pipe(v.number(), v.minValue(0), v.maxValue(0.95))), {}),
});

/** Choices as they were kept; null where they are none, or the usual ones. */
export function keptChoices(kept: unknown): ModelChoices | null {
  const read = v.safeParse(choicesSchema, kept);
  if (!read.success) return null;
  if (read.output.drawn.length > 0) return read.output;
  return JSON.stringify(chosenOptions(read.output)) === JSON.stringify(usualOptions) ? null : read.output;
}

/** By which a model is known again; '' where the page may not tell. */
export async function digestOf({ bytes, siblings }: Model): Promise<string> {
  if (!globalThis.crypto?.subtle) return '';
  const parts = await Promise.all(
    [bytes, ...siblings.values()].map((part) => crypto.subtle.digest('SHA-256', part)),
  );
  const all = parts.flatMap((part) => [...new Uint8Array(part)]);
  return all.map((byte) => byte.toString(16).padStart(2, '0')).join('');
}

export interface ModelMaterial {
  readonly key: string; // what the pipeline calls it
  readonly index: number;
  readonly name: string; // '' where it has none
  readonly reflectance: number | null; // null: a picture says it, or what the surface is (pure white, no colour yet)
  readonly hasPicture: boolean;
}

/** Those parts of a glTF's JSON that are read. */
interface Gltf {
  materials?: {
    name?: string;
    pbrMetallicRoughness?: { baseColorFactor?: number[]; baseColorTexture?: unknown };
  }[];
  meshes?: { primitives?: { material?: number }[] }[];
}

/** As the pipeline takes it: between 0 and 1, whatever the file says. */
function colorOf(factor: readonly unknown[] = []): Rgb {
  const part = (value: unknown) => (typeof value === 'number' ? Math.min(1, Math.max(0, value)) : 1);
  return [part(factor[0]), part(factor[1]), part(factor[2])];
}

/** The materials that a mesh has, in the file's order, a name once; none where the file cannot be read. */
export function materialsOf(glb: Model['bytes']): readonly ModelMaterial[] {
  try {
    const { materials = [], meshes = [] } = JSON.parse(readContainer(glb).text) as Gltf;
    const used = new Set(meshes.flatMap(({ primitives = [] }) => primitives.map(({ material }) => material)));
    const named = new Map<string, ModelMaterial>();
    for (const [index, { name = '', pbrMetallicRoughness: own }] of materials.entries()) {
      const key = name || `material ${index}`;
      if (!used.has(index) || named.has(key)) continue;
      const hasPicture = own?.baseColorTexture !== undefined;
      const color = colorOf(own?.baseColorFactor);
      const isWhite = Math.min(...color) >= 1;
      const reflectance = hasPicture || isWhite ? null : luminance(color);
      named.set(key, { key, index, name, hasPicture, reflectance });
    }
    return [...named.values()];
  } catch {
    return [];
  }
}

/** What a person says of a material; undefined where they say nothing, even of one called "constructor". */
export function chosenReflectance({ reflectances }: ModelChoices, material: string): number | undefined {
  return Object.hasOwn(reflectances, material) ? reflectances[material] : undefined;
}

export function chosenOptions({ unit, reflectances, drawn: _drawn, ...choices }: ModelChoices): BuildOptions {
  return { ...usualOptions, ...choices, scale: unit, reflectances: Object.entries(reflectances) };
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

/** How high the plane hangs over the largest floor, m: as chosen, or as proposed; 0 where luminaires hang on surfaces. */
export function planeHeight({ choices, survey }: Understood): number {
  if (choices.ceiling > 0 || choices.mounts.length > 0) return choices.ceiling;
  const told = survey?.warnings.flatMap((line) => toldIn('proposedPlane', line) ?? []);
  return Number(told?.[0] ?? 0);
}

/** How high a surface lies over the nearest floor below it, m; null where there is none. */
export function overFloor({ high, area }: SurveyedSurface, { survey }: Understood): number | null {
  const below = largeLevels(survey?.surfaces ?? []).filter((level) => level.high < high - headroom);
  const [largest] = below;
  if (!largest) return null;
  // The top of a tall block is no floor, that of a gallery or a storey is one.
  const isFloor = (level: SurveyedSurface) =>
    level.area >= mostOf * largest.area ||
    (level.area >= muchOf * largest.area && level.area >= mostOf * area);
  return high - Math.max(largest.high, ...below.filter(isFloor).map((floor) => floor.high));
}

/** What faces up and is large enough for a floor, the largest first. */
function largeLevels(all: readonly SurveyedSurface[]): readonly SurveyedSurface[] {
  const level = all.filter(({ facing }) => facing === facings.up);
  return level.filter(({ area }) => area >= aPart * level[0]!.area);
}

/** A storey of a model: its floor, and what luminaires would hang on there. */
export interface ModelStorey {
  readonly floor: number; // m, over the lowest point of the model
  readonly ceilings: readonly string[];
}

const storeyHeight = 2; // m from floor to floor, at least
const headroom = 1.8; // m
const mostHeadroom = 7; // m: what faces down higher is a roof over something open
const aPart = 0.08; // of the largest floor: a smaller one is a landing
const mostOf = 0.5; // of the largest floor, or of what lies over it
const muchOf = 0.25; // of the largest floor: an attic's over it
const aShare = 0.02; // of its storey's floor: what is smaller is no ceiling

/** From below to above; one that has no ceiling is left out. What is proposed there comes before what only faces down. */
export function storeysIn({ survey }: Understood): readonly ModelStorey[] {
  const all = survey?.surfaces ?? [];
  const floors: SurveyedSurface[] = [];
  for (const surface of largeLevels(all)) {
    if (floors.every((other) => Math.abs(other.high - surface.high) >= storeyHeight)) floors.push(surface);
  }
  floors.sort((one, other) => one.high - other.high);
  return floors.flatMap(({ high: floor, area }, i) => {
    const top = Math.min(floors[i + 1]?.high ?? Infinity, floor + mostHeadroom);
    const above = all.filter(
      ({ high, facing }) => high > floor + headroom && high < top && facing === facings.down,
    );
    const proposed = above.filter(({ use }) => use === uses.mount);
    const ceilings = proposed.length > 0 ? proposed : above.filter((each) => each.area > aShare * area);
    return ceilings.length > 0 ? [{ floor, ceilings: ceilings.map(({ name }) => name) }] : [];
  });
}

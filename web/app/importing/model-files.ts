/** Which dropped files are models of other programs, and what is said of those that nothing here can read. */
import { words } from '../../language/language.ts';

/** Extensions of what is turned into a glTF here. */
export const modelExtensions: readonly string[] = ['obj', 'stl', 'dae', 'fbx', '3ds', 'ifc'];
/** All that models end with, as a person reads it. */
export const modelEndings = ['glb', 'gltf', ...modelExtensions].map((each) => `.${each}`).join(', ');
const models = new RegExp(`\\.(${modelExtensions.join('|')})$`, 'i');

/** The cure for formats without a reader, by extension. */
const unreadable: readonly (readonly [RegExp, () => string])[] = [
  [/\.skp$/i, () => words.value.opening.import.cures.sketchUp],
  [/\.(rvt|rfa)$/i, () => words.value.opening.import.cures.revit],
  [/\.(3dm)$/i, () => words.value.opening.import.cures.rhino],
  [/\.(blend)$/i, () => words.value.opening.import.cures.blender],
  [/\.(max|c4d|ma|mb)$/i, () => words.value.opening.import.cures.other],
  [/\.(dwg|dxf)$/i, () => words.value.opening.import.cures.cad],
  [/\.ifcxml$/i, () => words.value.opening.import.cures.bim],
  [/\.(evo|dlx|rdf)$/i, () => words.value.opening.import.cures.dialux],
  [/\.(step|stp|iges|igs)$/i, () => words.value.opening.import.cures.cadModel],
];

export const isModel = (name: string): boolean => models.test(name);
export const isIfc = (name: string): boolean => /\.ifc$/i.test(name);

/** Whether these files need the importer: a model, an STF room, or what only it knows by name. */
export function isForImport(names: readonly string[]): boolean {
  return names.some((name) => isModel(name) || /\.stf$/i.test(name) || cureOf(name) !== null);
}

/** "SketchUp: export it as ..."; null where the format is not known to be unreadable. */
export function cureOf(name: string): string | null {
  return unreadable.find(([pattern]) => pattern.test(name))?.[1]() ?? null;
}

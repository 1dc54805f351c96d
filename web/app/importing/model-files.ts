/** Which dropped files are models of other programs, and what is said of those that nothing here can read. */

const models = /\.(obj|stl|dae|fbx|3ds)$/i;

/** The cure for formats without a reader, by extension. */
const unreadable: readonly (readonly [RegExp, string])[] = [
  [/\.skp$/i, 'SketchUp: export it as glTF (File, Export, 3D Model, glTF) or as Collada (.dae)'],
  [/\.(rvt|rfa)$/i, 'Revit: export it as FBX (File, Export, FBX)'],
  [/\.(3dm)$/i, 'Rhino: export it as glTF or OBJ (File, Export Selected)'],
  [/\.(blend)$/i, 'Blender: export it as glTF (File, Export, glTF 2.0)'],
  [/\.(max|c4d|ma|mb)$/i, 'the program that made it: export it as glTF or FBX'],
  [/\.(dwg|dxf)$/i, 'CAD: draw the plan in the room maker (New room), or export a 3D model as FBX'],
  [/\.(ifc|ifczip)$/i, 'BIM: export the room as glTF, OBJ or Collada from the program that made it'],
  [/\.(evo|dlx|rdf)$/i, 'DIALux or Relux: export the room as STF (.stf)'],
  [/\.(step|stp|iges|igs)$/i, 'CAD: export it as glTF, OBJ or STL'],
];

export const isModel = (name: string): boolean => models.test(name);

/** Whether these files need the importer: a model, an STF room, or what only it knows by name. */
export function isForImport(names: readonly string[]): boolean {
  return names.some((name) => isModel(name) || /\.stf$/i.test(name) || cureOf(name) !== null);
}

/** "SketchUp: export it as ..."; null where the format is not known to be unreadable. */
export function cureOf(name: string): string | null {
  return unreadable.find(([pattern]) => pattern.test(name))?.[1] ?? null;
}

/**
 * What the solver, the builder and the readers of files say themselves, in English and word for word: another language finds
 * its own sentence by these. What is not here stays in English.
 */
import { photometricFaults } from './photometric-faults.ts';

export const faults = {
  ...photometricFaults,
  connectionLost: 'the room could not be loaded: the connection was lost; try again',
  computationStopped: (why: string) => `the computation stopped (${why}); try again`,
  noScript: 'its script cannot be loaded',
  builderOffline: 'what computes light could not be loaded: no connection; try again',
  builderMissing: 'what computes light in the page is not on this server yet; try again in some minutes',
  sceneCut: (bytes: string) => `the scene file ends after ${bytes} bytes; load the page again`,
  noCore: (code: string) => `core.wasm cannot be loaded: status ${code}`,
  coreOffline: 'core.wasm cannot be loaded: no connection',
  noRoom: 'the scene file has no room to display; make it again with fiatlux precompute',
  notUnderstood: (why: string) => `not understood (${why}); export the file again`,
  notFetched: (address: string) => `${address} could not be fetched ahead`,
  noScene: 'not a Fiat Lux scene file: make one with fiatlux precompute',
  sceneNewer: (version: string, own: string) =>
    `scene file of version ${version}, but this program reads up to version ${own}: use a newer Fiat Lux, or make the file again`,
  sceneDamaged: (where: string) => `${where}; the file is damaged: make it again with fiatlux precompute`,
  glbCut: 'the GLB is cut off; export it again',
  glbEmpty: 'the file is empty; export it again',
  noGltf: 'this is neither a GLB nor glTF JSON in UTF-8; export the room as .glb or .gltf',
  extension: (name: string) =>
    `it requires the extension '${name}', which is not understood; export without it`,
  compressed: (name: string) =>
    `it requires the extension '${name}', which is not understood; export without compression`,
  noTriangles: 'no surfaces: it holds no triangles; export meshes, not points or lines',
  allTransparent:
    'no surfaces: everything is transparent or a measuring plane; give the walls an opaque material',
  manyTriangles: (count: string, most: string) =>
    `${count} triangles after instancing, and ${most} million are accepted; simplify the meshes`,
  pageMemory: 'not enough memory in this browser: close other pages, or take larger patches',
  pageManyPatches: (needed: string, most: string, patches: string) =>
    `this would need ${needed} GB of memory, and a page may use ${most}: ${patches} patches are too many; take larger ones, make the room smaller, or use the command`,
  pageManyPlaces: (needed: string, most: string, places: string) =>
    `this would need ${needed} GB of memory, and a page may use ${most}: ${places} places for luminaires are too many; take a wider grid, make the room smaller, or use the command`,
  noMemory: 'needs more memory than there is; make the model smaller',
  narrow: (width: string) =>
    `the room is only ${width} m wide: pass --scale with the metres of one unit of the file`,
  millimetres: (width: string) =>
    `the room is ${width} m wide: the file is probably in millimetres: pass --scale 0.001`,
  centimetres: (width: string) =>
    `the room is ${width} m wide: the file is probably in centimetres or millimetres: pass --scale 0.01 or 0.001`,
  farNode: (name: string, metres: string) =>
    `node '${name}' reaches ${metres} m from the origin; check its scale, or pass --scale`,
  guessedUnit: (before: string, unit: string, after: string) =>
    `as metres the model would be ${before}: it is taken to be in ${unit}, ${after}; --scale 1 refuses that`,
  guessedUp: (height: string, sizes: string) =>
    `with y up the model would be ${height} m high: it is taken to have z up, ${sizes}; --up y refuses that`,
  sizes: (width: string, depth: string, height: string) => `${width} x ${depth} m and ${height} m high`,
  inCentimetres: 'centimetres',
  inMillimetres: 'millimetres',
  inInches: 'inches',
  inUnitsOf: (metres: string) => `units of ${metres} m`,
  inKilometres: 'kilometres',
  onlyPlace: (where: string, sizes: string, kept: string, all: string) =>
    `only the place around ${where} stays, ${sizes}: ${kept} of ${all} rooms, and the rest is left out; --doors N takes in what lies behind so many open doors`,
  noSuchPlace: (where: string) =>
    `${where}: there is no air that belongs to a room; name a point about a metre over its floor`,
  manyCells: (patch: string, cells: string) =>
    `patches of ${patch} m need ${cells} grid cells, more than --memory allows; pass a larger --patch`,
  roomMemory: 'not enough memory for this room; pass a larger --patch',
  lightMemory: 'not enough memory for the light; pass a larger --patch',
  runMemory: 'not enough memory; pass a larger --patch or fewer --rays',
  noMaterial: (meshes: string, ceilings: string, walls: string, floors: string, others: string) =>
    `${meshes} no material: ceilings are taken to reflect ${ceilings}, walls ${walls}, floors ${floors}, other things ${others}`,
  whiteMaterial: (
    meshes: string,
    name: string,
    ceilings: string,
    walls: string,
    floors: string,
    others: string,
  ) =>
    `${meshes} no material but white ('${name}'): ceilings are taken to reflect ${ceilings}, walls ${walls}, floors ${floors}, other things ${others}`,
  smallNodes: (count: string, what: string) => `${count} nodes: those below 0.5 % of the area are ${what}`,
  partsOfRoom: 'the floor, walls, ceiling or things of the room that they are in',
  oneSurface: (name: string) => `one surface, '${name}'`,
  clusters: (edge: string, other: string, most: string) =>
    `clusters are ${edge} x ${other} patches, so that there are at most ${most}`,
  tooLow: (count: string, all: string, mount: string, drop: string) =>
    `${count} of ${all} sites of mount '${mount}' are left out: something is less than ${drop} m below them; pass a smaller --drop`,
  noSquare: (mount: string, size: string) =>
    `mount '${mount}' has no room for a whole square of ${size} m; pass a smaller --site-spacing`,
  nowhere: (names: string) =>
    `nowhere to hang luminaires: no node is marked as mount, nothing faces down over a floor, and there is no floor with free space above; pass --mount with one of ${names}`,
  noSite: (mount: string) =>
    `no site fits on any mount (${mount}): pass a smaller --site-spacing, or another --mount`,
  tooLarge: (sizes: string) => `${sizes} m are too much for rooms to be told apart; export a part of it`,
  noSuchName: (name: string, names: string) =>
    `'${name}': no node or surface is called that; the closest are ${names}`,
  noSuchMaterial: (name: string, which: string) => `'${name}': no material is called that; ${which}`,
  noMaterials: 'the model has none',
  closest: (names: string) => `the closest are ${names}`,
  allWithoutArea: 'no surfaces: every triangle has zero area; check the scale of the nodes',
  clampedMore: (count: string, most: string, taken: string) =>
    `${count} more materials reflect more than ${most} and are taken as ${taken}`,
  ofMaterial: (name: string) => `material '${name}'`,
  clampedNode: (name: string, share: string, most: string) =>
    `node '${name}': reflectance ${share} is taken as ${most}`,
  clampedColour: (name: string) => `material '${name}': its base colour lies outside 0..1 and is clamped`,
  plainColour: (image: string, why: string) => `${image} is ${why}: it counts as the material's plain colour`,
  imageOfMaterial: (index: string, name: string) => `image ${index} of material '${name}'`,
  pictureFormat: (format: string) => `${format}, which is not read (use PNG or JPEG)`,
  pictureUnknown: 'neither PNG nor JPEG',
  pictureDamaged: 'damaged',
  pictureLarge: (width: string, height: string) => `larger than ${width} x ${height} pixels`,
  animated: 'the file is animated: its rest pose is used',
  skinned: 'the file holds skinned meshes: they stand as the rest pose of their joints bends them',
  unbalanced: (share: string) =>
    `the balance of light does not close (${share} of what is emitted is absorbed): are faces drawn twice? pass more --rays`,
  notSettled: (share: string) =>
    `reflected light has not settled (${share} is missing): pass --refine 100 or a smaller --cluster`,
  settledOnly: (share: string) =>
    `reflected light is settled to ${share} only, 0.1 % is usual: pass more --refine`,
  numbersOff: (share: string) =>
    `the file's numbers are off by up to ${share}: surfaces that are nearly dark are too large a part of it; choose fewer places with --mount`,
  noArea: (count: string) => `triangles without area are left out: ${count}`,
  repeated: (count: string) => `triangles that repeat others are left out: ${count}`,
  proposedMount: (where: string) =>
    `no mount is marked: luminaires are proposed to hang on ${where}; choose with --mount`,
  proposedPlane: (height: string, floor: string, area: string) =>
    `nothing is a ceiling: luminaires are proposed to hang in a plane ${height} m above '${floor}' (${area} m2); --ceiling says another height, --mount another place`,
  ceilingHeight: (height: string) =>
    `the ceiling is ${height} m above the floor: is that so? --scale says how many metres a unit of the file has`,
  ceilingInFeet: (height: string, metres: string) =>
    `the ceiling is ${height} m above the floor: is that so? in feet it would be ${metres} m: --scale 0.3048`,
  clamped: (name: string, share: string, most: string) =>
    `${name} reflects ${share} of the light: taken as ${most}`,
  lightLost:
    'nearly all light is lost: the luminaires hang outdoors or look at backs; see fiatlux surfaces, then --mount, --ceiling or --double-sided',
  staysDark: (share: string) =>
    `the room stays dark: no surface gets more than ${share} of the light; the luminaires hang in a cavity; see fiatlux surfaces, then --mount or --ceiling`,
  black: (share: string) =>
    `everything is black: surfaces reflect ${share} of the light, as where colours were lost on export; pass --reflectance MATERIAL=0.5 for each`,
  glassMore: (name: string, more: string) =>
    `material '${name}' and ${more} more: called glass but opaque, so it counts as a wall; where light is to pass, make it transparent (alpha BLEND)`,
  glass: (name: string) =>
    `material '${name}': called glass but opaque, so it counts as a wall; where light is to pass, make it transparent (alpha BLEND)`,
  transparent: (name: string) =>
    `material '${name}' is transparent (alpha BLEND or transmission): it is no wall, light passes it unchanged`,
  transparentMore: (name: string, more: string) =>
    `material '${name}' is transparent (alpha BLEND or transmission): it is no wall, light passes it unchanged; so are ${more} more`,
  roomOpen: (share: string, ways: string) =>
    `the room is open: ${share} of the light of its luminaires meets nothing and is lost; it leaves ${ways}`,
  backsNear: (share: string, names: string) =>
    `${share} of the light is swallowed by backs, those of ${names}: they lie close over something and hide it; cut away what is hidden, or it counts as dark`,
  backs: (share: string, names: string) =>
    `${share} of the light is swallowed by backs, those of ${names}: turn their faces, or make their material double-sided`,
  foreseenLoss: (share: string) =>
    `about ${share} of the light would be lost: it leaves the model, or meets the backs of faces; close the openings, turn the faces, or pass --double-sided`,
  outside: (area: string, names: string) =>
    `${area} m2 face the void or rest on something, no light comes there, and they are left out: ${names}`,
  shutOff: (area: string, names: string) =>
    `${area} m2 are shut off from all places for luminaires and stay dark (a sealed room, the inside of a wall): ${names}`,
  turned: (area: string, names: string) =>
    `${area} m2 have one side, which looks away from the room they enclose, and are turned: ${names}; --double-sided gives all faces two sides`,
  twoSided:
    'no ceiling looks into the room: all faces are taken as double-sided, and those that look outward are turned',
  fileLights:
    'lights and emissive materials of the file do not shine: only the luminaires that are placed do',
  fitsNowhere: (name: string) =>
    `${name} fits on no place of this room: take a smaller luminaire, or allow a larger aiming angle`,
  fitNowhere: (names: string) =>
    `${names} fit on no place of this room: take a smaller luminaire, or allow a larger aiming angle`,
  noLuminousArea: (name: string) =>
    `${name} has no luminous area, so nobody can say how it glares: take another luminaire, or ask for no glare`,
  noFloor: 'there is no floor for a working plane (--plane) to lie over',
  narrowFloor: (rim: string) =>
    `no working plane: the floor is narrower than two rims of ${rim} m; make the rim smaller (--plane-rim)`,
  stfTooLarge: 'it is larger than 8 MB',
  stfNoSection: (section: string) => `it has no section [${section}]`,
  stfNoLine: (section: string, name: string) => `[${section}] has no line ${name}=`,
  stfFewPoints: (section: string, count: string) =>
    `[${section}] has ${count} points; a room has three at least`,
  stfNoReflectance: (section: string, line: string) => `[${section}] ${line} is no reflectance`,
  stfNoNumber: (section: string, line: string) => `[${section}] ${line} is not a number`,
  stfNoNumbers: (section: string, line: string, count: string) =>
    `[${section}] ${line} is not ${count} numbers`,
  stfNotWhole: (section: string, line: string, most: string) =>
    `[${section}] ${line} is not a whole number up to ${most}`,
  planNone: 'it is no room',
  planVersion: (version: string, own: string) =>
    `it was made by another version (plan ${version}; this app reads plans up to ${own})`,
  planNumbers: 'it holds something that is no whole number, or too many',
  planMissing: 'it is missing or of another kind',
  planRange: (least: string, most: string) => `it must lie between ${least} and ${most}`,
  planMany: (most: string) => `there are more than ${most}`,
  planFewCorners: 'there are fewer than 3 corners',
  planColour: 'it is no colour such as #f4f1ea',
  planCrossed: 'the walls cross or touch each other',
  planSmall: 'the floor is smaller than 0.25 m2',
  planShortWall: 'a wall is shorter than 5 cm',
  noArrangement: (what: string, count: string) =>
    `arrangement: found no ${what} of ${count} luminaires on the free sites; change the count, give it a range, or free the arrangement`,
  noRows: (what: string, count: string, least: string) =>
    `arrangement: found no ${what} of ${count} luminaires, at least ${least} in each, on the free sites; change the count, give it a range, or free the arrangement`,
  fewSites: (count: string, free: string) =>
    `luminaires: ${count} luminaires on ${free} free sites; lower the count or exclude fewer sites`,
  roomForOnly: (found: string, count: string, apart: string) =>
    `luminaires: found room for only ${found} of ${count} luminaires ${apart} m apart; lower the count or the minimum distance`,
  roomForBodies: (found: string, count: string) =>
    `luminaires: found room for only ${found} of ${count} luminaires that do not run into each other; lower the count or take smaller ones`,
  pinnedNear: (one: string, other: string, apart: string, least: string) =>
    `luminaires: pinned sites ${one} and ${other} are ${apart} m apart, closer than the minimum distance of ${least} m`,
  pinnedMore: (pinned: string, count: string) =>
    `luminaires: ${pinned} are pinned but the count is ${count}; raise the count or unpin`,
  typesAskMore: (asked: string, count: string) =>
    `luminaires: the types ask for ${asked} together, but the count is ${count}; raise it or ask for fewer of a type`,
  typesAskFirst: (asked: string, count: string, least: string) =>
    `luminaires: the types ask for ${asked} together, but the count is ${count}; begin its range at ${least}`,
  typesAllowFewer: (allowed: string, count: string) =>
    `luminaires: the types allow ${allowed} together, but the count is ${count}; lower it or allow more of a type`,
  typesNoPlaces: (count: string) =>
    `luminaires: found no ${count} places with as many of each type as is asked for; lower the count or widen the ranges`,
  typeFitsNowhere: (which: string, type: string) =>
    `luminaires: ${which} must be of ${type}, which fits nowhere in this room`,
  alphaNoLayout: (promise: string) => `No layout found can give ${promise}: even the means fall short.`,
  alphaTwoEmpty: (promise: string) =>
    `No alpha leads to ${promise}: with a small one some patches miss it, with a larger one no layout meets the margin.`,
  alphaStopped: (promise: string) => `Stopped before an alpha was found that keeps ${promise}.`,
  alphaAtLeast: (value: string, unit: string, surface: string) =>
    `at least ${value} ${unit} on every patch of ${surface}`,
  alphaAtMost: (value: string, unit: string, surface: string) =>
    `at most ${value} ${unit} on every patch of ${surface}`,
  alphaOthers: 'The other intentions cannot all be met either: relax one of them first.',
  alphaByPatches: (value: string) =>
    `A search on the patches themselves does find such a layout, with ${value}.`,
  alphaFeasible: (which: string, value: string) =>
    `The ${which} found feasible is ${value}: ask for that, or add luminaires or flux.`,
  alphaLargest: 'largest minimum',
  alphaSmallest: 'smallest maximum',
};

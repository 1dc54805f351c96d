/**
 * What the pipeline tells with options of the command, as the page says it: with what can be done on the page. Other languages
 * say the faults as the page does from the first.
 */
import { grouped } from '../numbers.ts';
import { faults } from './faults.ts';

const luminaires = (count: string) => `${count} ${count === '1' ? 'luminaire' : 'luminaires'}`;

export const pageFaults: Partial<typeof faults> = {
  narrow: (width) => `the room is only ${width} m wide: choose the unit of the file (How it was understood)`,
  millimetres: (width) =>
    `the room is ${width} m wide: the file is probably in millimetres; choose that unit (How it was understood)`,
  centimetres: (width) =>
    `the room is ${width} m wide: the file is probably in centimetres or millimetres; choose one of these units (How it was understood)`,
  farNode: (name, metres) => `node '${name}' reaches ${metres} m from the origin; check its scale`,
  guessedUnit: (before, unit, after) =>
    `as metres the model would be ${before}: it is taken to be in ${unit}, ${after}`,
  guessedUp: (height, sizes) =>
    `with y up the model would be ${height} m high: it is taken to have z up, ${sizes}`,
  onlyPlace: (where, sizes, kept, all) =>
    `only the place around ${where} stays, ${sizes}: ${kept} of ${all} rooms, and the rest is left out`,
  tooLarge: faults.tooLarge, // the option before it is left out
  noSuchPlace: (where) =>
    `${where}: this point is not inside a room; click on a floor or a wall within the room`,
  pageManyPatches: (needed, most, patches) => faults.pageManyPatches(needed, most, grouped(patches)),
  pageManyPlaces: (needed, most, places) => faults.pageManyPlaces(needed, most, grouped(places)),
  manyCells: (patch, cells) =>
    `patches of ${patch} m need ${cells} grid cells, more than memory allows; take larger patches`,
  roomMemory: 'not enough memory for this room; take larger patches',
  lightMemory: 'not enough memory for the light; take larger patches',
  runMemory: 'not enough memory; take larger patches',
  tooLow: (count, all, mount, drop) =>
    `${count} of ${all} places on '${mount}' are left out: something is less than ${drop} m below them; hang luminaires less low`,
  noSquare: (mount, size) => `'${mount}' has no room for a whole square of ${size} m; take a closer grid`,
  nowhere: (names) =>
    `nowhere to hang luminaires: no node is marked as mount, nothing faces down over a floor, and there is no floor with free space above; choose a surface (How it was understood), such as ${names}`,
  noSite: (mount) => `no place fits on any mount (${mount}): take a closer grid, or another mount`,
  noSuchName: faults.noSuchName,
  noSuchMaterial: faults.noSuchMaterial,
  unbalanced: (share) =>
    `surfaces take up more light than the luminaires give (${share} of it): two faces probably lie on each other; remove one`,
  notSettled: (share) =>
    `reflected light has not settled (${share} is missing): light passes too many rooms; choose one of them (How it was understood)`,
  noArrangement: (what, count) =>
    `there is no ${what} of ${luminaires(count)} on the free places: change their number, give it a range, or free the arrangement`,
  noRows: (what, count, least) =>
    `there is no ${what} of ${luminaires(count)}, at least ${least} in each, on the free places: change their number, give it a range, or free the arrangement`,
  fewSites: (count, free) =>
    `${luminaires(count)} ${count === '1' ? 'has' : 'have'} ${free === '0' ? 'no free place' : `${free} free places`}: lower the number or keep fewer areas free`,
  roomForOnly: (found, count, apart) =>
    `only ${found} of ${luminaires(count)} find room ${apart} m apart: lower the number or the minimum distance`,
  roomForBodies: (found, count) =>
    `only ${found} of ${luminaires(count)} find room without running into each other: lower the number or take smaller ones`,
  pinnedNear: (_one, _other, apart, least) =>
    `two pinned luminaires hang ${apart} m apart, and at least ${least} m are asked for: unpin one or lower the minimum distance`,
  typeFitsNowhere: (which, type) => `${which} must be of ${type}, which fits nowhere in this room`,
  roomOpen: (share, ways) =>
    `the room is open: ${share} of the light of its luminaires finds no surface and is lost; it leaves ${ways}`,
  skinned: 'the file holds figures with a skeleton: they stand in their basic pose',
  backsNear: (share, names) =>
    `${names} are seen from behind and take up ${share} of the light: they lie close over something and hide it; cut away what is hidden, or it counts as dark`,
  backs: (share, names) =>
    `${names} are seen from behind and take up ${share} of the light: turn their faces, or make their material double-sided`,
  settledOnly: (share) => `reflected light is settled to ${share} only, 0.1 % is usual`,
  numbersOff: (share) =>
    `the file's numbers are off by up to ${share}: surfaces that are nearly dark are too large a part of it; choose fewer mounts (How it was understood)`,
  proposedMount: (where) => `no mount is marked: luminaires are proposed to hang on ${where}`,
  proposedPlane: (height, floor, area) =>
    `nothing is a ceiling: luminaires are proposed to hang in a plane ${height} m above '${floor}' (${area} m2)`,
  ceilingHeight: (height) => `the ceiling is ${height} m above the floor: is that so?`,
  ceilingInFeet: (height, metres) =>
    `the ceiling is ${height} m above the floor: is that so? In feet, which can be chosen under How it was understood, it would be ${metres} m`,
  lightLost:
    'nearly all light is lost: the luminaires hang outdoors or look at backs; choose other mounts, a plane, or two-sided faces (How it was understood)',
  staysDark: (share) =>
    `the room stays dark: no surface gets more than ${share} of the light; the luminaires hang in a closed hollow, as above a suspended ceiling; choose other mounts or a plane (How it was understood)`,
  black: (share) =>
    `everything is black: surfaces reflect ${share} of the light, as where colours were lost on export; enter reflectances (How it was understood)`,
  foreseenLoss: (share) =>
    `about ${share} of the light would be lost: it leaves the model, or meets the backs of faces; close the openings, turn the faces, or take all as two-sided`,
  turned: (area, names) =>
    `${area} m2 have one side, which looks away from the room they enclose, and are turned: ${names}`,
  noFloor: 'there is no floor for a working plane to lie over',
  narrowFloor: (rim) =>
    `no working plane: the floor is narrower than two rims of ${rim} m; make the rim smaller`,
};

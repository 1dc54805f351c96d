// From the plan of a room to its glTF: walls with their doors and windows, floor, ceiling, columns, furniture, the marks that
// tell the pipeline where luminaires may hang and where light is measured. The file carries its plan, so that it can be
// opened again and changed.
import { tintOf } from './colour.mjs';
import { GltfRoom } from './gltf-room.mjs';
import { ItemShapes, footprint, isColumn, itemMaterials } from './items.mjs';
import { placeCeiling } from './mounts.mjs';
import { plainMaterials } from './plain-materials.mjs';
import { packedPlan } from './plan-code.mjs';
import { areApart, distance, holds, inset, rotated, triangles } from './polygon.mjs';
import { wallName } from './room-plan.mjs';
import { Shape } from './shape.mjs';
import { door, gridFrame, panelWithHoles } from './walls.mjs';

const columnClearance = 0.02; // m between a column and whatever else reaches the ceiling
const doorFrame = 0.09; // m, of the architrave beside and above the leaf
const openingMargin = 0.02; // m of wall that stays around an opening
const paneWidth = 1.2; // m, a window's panes at most
const radians = Math.PI / 180;

/** Wall coordinates of one wall, as in walls.mjs: u along it, v up, d into the room. */
function wallFrame({ outline }, wall) {
  const [a, b] = [outline[wall], outline[(wall + 1) % outline.length]];
  const length = distance(a, b);
  const [tx, tz] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
  return { length, point: (u, v, d) => [a[0] + u * tx - d * tz, v, a[1] + u * tz + d * tx] };
}

/** What an opening takes of its wall: [u0, v0, u1, v1] m, with a door's frame. */
function openingRectangle({ kind, at, width, sill, height }) {
  return kind === 'door'
    ? [at - doorFrame, 0, at + width + doorFrame, height + doorFrame]
    : [at, sill, at + width, sill + height];
}

/** The openings of a wall that fit it and leave each other room, in their order: the others are not built. */
export function builtOpenings(plan, wall) {
  const { length } = wallFrame(plan, wall);
  const built = [];
  for (const opening of plan.openings.filter((each) => each.wall === wall)) {
    const [u0, v0, u1, v1] = openingRectangle(opening);
    const fits =
      u0 >= openingMargin && u1 <= length - openingMargin && v1 <= plan.height - openingMargin && v1 > v0;
    const isFree = built.every((other) => {
      const [o0, p0, o1, p1] = openingRectangle(other);
      return u1 + openingMargin <= o0 || o1 + openingMargin <= u0 || v1 + openingMargin <= p0 || p1 + openingMargin <= v0; // prettier-ignore
    });
    if (fits && isFree) built.push(opening);
  }
  return built;
}

/** Columns that stand clear of walls and of each other: floor and ceiling end at them. The others stand like furniture. */
export function clearColumns({ outline, items }) {
  const clear = [];
  for (const column of items.filter(isColumn)) {
    const base = footprint(column);
    if (
      holds(outline, base, columnClearance) &&
      clear.every(({ base: other }) => areApart(base, other, columnClearance))
    )
      // prettier-ignore
      clear.push({ column, base });
  }
  return clear;
}

/** Outline of the working plane, m; null where there is none, or no room for it within its rim. */
export function planeOutline({ outline, plane }) {
  return plane && inset(outline, plane.rim);
}

const shapes = new ItemShapes();

/** The room as glTF under construction. */
export function makeRoom(plan) {
  const finish = ({ colour, reflectance }) => ({ colour: tintOf(colour, reflectance), reflectance });
  const { ceiling, walls, floor } = plan.finishes;
  const room = new GltfRoom(plan.name || 'Room', {
    generator: 'Fiat Lux room maker',
    materials: {
      ...plainMaterials,
      ...itemMaterials,
      ceiling: finish(ceiling),
      walls: finish(walls),
      floor: finish(floor),
      column: finish(walls),
      rail: plainMaterials['white lacquer'],
    },
  });
  room.scene.setExtras({ fiatlux: { plan: packedPlan(plan) } });
  const columns = clearColumns(plan);
  const holes = columns.map(({ base }) => base);
  placeWalls(room, plan);
  room.place('floor', flat('floor', plan.outline, holes, 0));
  placeCeiling(room, plan, holes);
  placeItems(room, plan, columns);
  placePlanes(room, plan, holes);
  return room;
}

/** The plan as a binary glTF, the same bytes for the same plan. */
export async function glbOf(plan) {
  return makeRoom(plan).bytes();
}

/** A horizontal polygon with holes, facing up. */
function flat(material, outline, holes, y) {
  const shape = new Shape();
  for (const triangle of triangles(outline, holes))
    shape.triangle(material, triangle.map(([x, z]) => [x, y, z]).reverse());
  return shape;
}

function placeWalls(room, plan) {
  const { outline, height } = plan;
  const numbers = { window: 0, door: 0 };
  outline.forEach((_, wall) => {
    const frame = wallFrame(plan, wall);
    const openings = builtOpenings(plan, wall);
    const shape = new Shape();
    const holes = openings.map(openingRectangle);
    panelWithHoles(shape, frame, 'walls', [0, 0, frame.length, height], holes);
    room.place(wallName(plan, wall), shape);
    for (const opening of openings)
      room.place(`${opening.kind} ${++numbers[opening.kind]}`, openingShape(frame, opening), {
        fiatlux: { surface: `${opening.kind}s` },
      });
  });
}

function openingShape(frame, opening) {
  const shape = new Shape();
  const { kind, at, width, height } = opening;
  if (kind === 'door') {
    door(shape, frame, [at, 0, at + width, height], { material: 'oak board', frameMaterial: 'white lacquer', metal: 'dark steel' }); // prettier-ignore
    return shape;
  }
  const bar = Math.min(0.055, width / 6, opening.height / 6);
  const columns = Math.max(1, Math.round(width / paneWidth));
  gridFrame(shape, frame, openingRectangle(opening), {
    material: 'white lacquer', paneMaterial: 'glass', bar, at: -0.1, pane: -0.13, columns,
  }); // prettier-ignore
  return shape;
}

function placeItems(room, plan, clear) {
  const numbers = new Map();
  for (const item of plan.items) {
    const { kind, x, z, turn } = item;
    const number = (numbers.get(kind) ?? 0) + 1;
    numbers.set(kind, number);
    if (isColumn(item)) {
      const column = clear.find((each) => each.column === item);
      room.place(`${kind} ${number}`, columnShape(item, plan.height, column), {
        fiatlux: { surface: 'columns' },
      });
      continue;
    }
    for (const { shape, surface, suffix } of shapes.of(item))
      room.place(`${kind} ${number}${suffix}`, shape, {
        at: [x, 0, z],
        turn: turn * radians,
        ...(surface && { fiatlux: { surface } }),
      });
  }
}

/** A column from floor to ceiling; one that stands at a wall is closed and keeps a millimetre from both. */
function columnShape(item, height, clear) {
  const gap = clear ? 0 : 0.001;
  const ring = (y) => footprint(item).map(([x, z]) => [x, y, z]).reverse(); // prettier-ignore
  const ends = { capStart: !clear, capEnd: !clear };
  return new Shape().loft('column', [ring(gap), ring(height - gap)], ends);
}

/** m around a task area (EN 12464-1): as a plane that leaves so much out it has its grid on all of itself, without a rim. */
const surround = 0.5;

function placePlanes(room, plan, holes) {
  const outline = planeOutline(plan);
  if (outline) {
    const within = holes.filter((hole) => holds(outline, hole, columnClearance));
    const shape = flat('measuring plane', outline, within, plan.plane.height);
    room.place('working plane', shape, { fiatlux: { measure: true, border: plan.plane.rim } });
  }
  plan.tasks.forEach(({ x, z, width: w, depth: d, height, turn }, i) => {
    const corners = [[-w / 2, -d / 2], [w / 2, -d / 2], [w / 2, d / 2], [-w / 2, d / 2]]; // prettier-ignore
    const base = rotated(corners, turn).map(([cx, cz]) => [cx + x, cz + z]);
    room.place(`task area ${i + 1}`, flat('measuring plane', base, [], height), {
      fiatlux: { measure: true, border: surround },
    });
  });
}

// The ceiling of a made room and where its luminaires may hang: on all of it, in the tiles of its grid, on rails or in a
// plane below, by cords that the pipeline knows as a drop.
import { clipped, rotated, signedArea, stretchesAt, triangles } from './polygon.mjs';
import { Shape } from './shape.mjs';

export const mostTiles = 40_000;
const railHeight = 0.04; // m
const railEnd = 0.05; // m left free at either end
const gap = 0.001; // m below the ceiling

/** How many tiles a ceiling could have, whole or cut. */
export function tileCount({ outline, mount }) {
  const [columns, rows] = [0, 1].map((axis) => {
    const along = rotated(outline, -mount.turn).map((p) => p[axis]);
    return Math.ceil((Math.max(...along) - Math.min(...along)) / mount.spacing) + 1;
  });
  return columns * rows;
}

/** Hangs the ceiling into a room. holes: outlines of columns that stand clear of everything. */
export function placeCeiling(room, plan, holes) {
  const { mount, outline, height } = plan;
  const marks = { mount: true, siteSpacing: mount.spacing, siteSize: mount.luminaire };
  if (mount.kind === 'plane') marks.drop = mount.drop;
  if (mount.kind === 'tiles' && tileCount(plan) <= mostTiles) {
    const { whole, rest } = tiled(plan, holes);
    if (whole.triangles.length > 0)
      room.place('ceiling tiles', whole, { fiatlux: { surface: 'ceiling', ...marks } });
    if (rest.triangles.length > 0) room.place('ceiling edge', rest, { fiatlux: { surface: 'ceiling' } });
    return;
  }
  const shape = new Shape();
  for (const triangle of triangles(outline, holes)) shape.triangle('ceiling', facingDown(triangle, height));
  room.place('ceiling', shape, mount.kind === 'rails' ? {} : { fiatlux: marks });
  if (mount.kind !== 'rails') return;
  const rails = railsOf(plan, holes);
  if (rails.triangles.length > 0) room.place('rails', rails, { fiatlux: marks });
}

/** Points of the plan at a height, in the sense that is seen from below; the plan's own sense is that. */
const facingDown = (points, y) => points.map(([x, z]) => [x, y, z]);

/** The ceiling along a grid: whole tiles, whose union the pipeline fills with places, tile by tile; and what is cut. */
function tiled({ outline, height, mount }, holes) {
  const { spacing: edge, turn, origin } = mount;
  const [start] = rotated([origin], -turn);
  const toGrid = (points) =>
    rotated(points, -turn).map(([x, z]) => [(x - start[0]) / edge, (z - start[1]) / edge]);
  const fromGrid = (points) => rotated(points.map(([i, j]) => [i * edge + start[0], j * edge + start[1]]), turn); // prettier-ignore

  // What of each cell the ceiling covers, in pieces.
  const cells = new Map();
  for (const triangle of triangles(toGrid(outline), holes.map(toGrid))) {
    const low = (axis) => Math.floor(Math.min(...triangle.map((p) => p[axis])) + 1e-9);
    const high = (axis) => Math.ceil(Math.max(...triangle.map((p) => p[axis])) - 1e-9);
    for (let i = low(0); i < high(0); i++) {
      const strip = clipped(clipped(triangle, 0, i, 1), 0, i + 1, -1);
      for (let j = low(1); j < high(1); j++) {
        const piece = clipped(clipped(strip, 1, j, 1), 1, j + 1, -1);
        const area = signedArea(piece);
        if (area < 1e-9) continue;
        const cell = cells.get(`${i} ${j}`) ?? { i, j, area: 0, pieces: [] };
        cell.area += area;
        cell.pieces.push(piece);
        cells.set(`${i} ${j}`, cell);
      }
    }
  }

  const [whole, rest] = [new Shape(), new Shape()];
  for (const { i, j, area, pieces } of cells.values())
    if (area > 1 - 1e-4)
      whole.quad('ceiling', facingDown(fromGrid([[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]]), height)); // prettier-ignore
    else for (const piece of pieces) rest.fan('ceiling', facingDown(fromGrid(piece), height));
  return { whole, rest };
}

/** Where rails run: pieces { from, to, at } in the frame turned by the mount's angle (m along it, m across). */
export function railLines({ outline, mount }, holes) {
  const { turn, rows, luminaire: width } = mount;
  const inFrame = rotated(outline, -turn);
  const columns = holes.map((hole) => rotated(hole, -turn));
  const across = inFrame.map(([, z]) => z);
  const [low, high] = [Math.min(...across), Math.max(...across)];
  const count = Math.max(1, Math.round((high - low) / rows));
  const lines = [];
  for (let r = 0; r < count; r++) {
    const at = low + ((high - low) * (r + 0.5)) / count;
    const edges = [at - width / 2, at, at + width / 2].map((z) => stretchesAt(inFrame, 1, z));
    for (const [from, to] of edges.reduce(common)) {
      const blocked = columns.filter((column) => crossesStrip(column, at - width / 2, at + width / 2));
      for (const [a, b] of without([from + railEnd, to - railEnd], blocked))
        if (b - a >= width) lines.push({ from: a, to: b, at });
    }
  }
  return lines;
}

const common = (a, b) =>
  a.flatMap(([a0, a1]) =>
    b.map(([b0, b1]) => [Math.max(a0, b0), Math.min(a1, b1)]).filter(([low, high]) => high > low),
  );

const crossesStrip = (column, low, high) =>
  Math.max(...column.map(([, z]) => z)) > low && Math.min(...column.map(([, z]) => z)) < high;

/** A stretch without what columns stand in, and a little on either side. */
function without(stretch, columns) {
  const cuts = columns.map((column) => {
    const along = column.map(([x]) => x);
    return [Math.min(...along) - railEnd, Math.max(...along) + railEnd];
  });
  let left = [stretch];
  for (const [low, high] of cuts)
    left = left.flatMap(
      ([a, b]) =>
      high <= a || low >= b ? [[a, b]] : [[a, Math.min(b, low)], [Math.max(a, high), b]].filter(([p, q]) => q > p), // prettier-ignore
    );
  return left;
}

function railsOf(plan, holes) {
  const { mount, height } = plan;
  const shape = new Shape();
  const top = height - Math.max(gap, mount.drop);
  for (const { from, to, at } of railLines(plan, holes)) {
    const half = mount.luminaire / 2;
    const bar = new Shape().box('rail', [from, top - railHeight, at - half], [to, top, at + half]);
    shape.add(bar, ([x, y, z]) => {
      const [[px, pz]] = rotated([[x, z]], mount.turn);
      return [px, y, pz];
    });
  }
  return shape;
}

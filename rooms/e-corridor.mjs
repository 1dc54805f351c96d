// The E corridor: a spine with three arms, in cells of 0.75 m, 4 cells high. Its sizes give
// 24736 patches of 0.1875 m, 1546 clusters of 4x4 patches and a yellow wall of 704 patches.
// The luminaires hang from the spine's 258 ceiling cells.
import { armDepth, arms, cell, height, spine } from './e-corridor-plan.mjs';
import { Room } from './room.mjs';
import { Shape } from '../web/room-maker/shape.mjs';

/** Wall stretches [x, z] -> [x, z] in cells, walked with the room on the left seen from above (x right, z down). */
export function wallStretches() {
  const tip = spine.width + armDepth;
  const stretches = [
    [[0, 0], [0, spine.length]],
    [[0, spine.length], [tip, spine.length]],
  ]; // prettier-ignore
  for (const { start, width } of [...arms].reverse()) {
    const end = start + width;
    if (end < spine.length) stretches.push([[spine.width, end], [tip, end]]); // prettier-ignore
    stretches.push([[tip, end], [tip, start]]); // prettier-ignore
    stretches.push([
      [tip, start],
      [start === 0 ? 0 : spine.width, start],
    ]);
    const below = arms.findLast((arm) => arm.start < start);
    if (below) stretches.push([[spine.width, start], [spine.width, below.start + below.width]]); // prettier-ignore
  }
  return stretches;
}

/** The yellow wall is the middle arm's side wall at z = 24, seen from the arm. */
export const isYellow = ([[, z0], [, z1]]) => z0 === 24 && z1 === 24;

/** Cells of each surface; the paper's counts follow from them. */
export function cellCounts() {
  const horizontal = spine.width * spine.length + arms.reduce((sum, arm) => sum + armDepth * arm.width, 0);
  const wall = ([[x0, z0], [x1, z1]]) => (Math.abs(x1 - x0) + Math.abs(z1 - z0)) * height;
  const stretches = wallStretches();
  const sum = (list) => list.reduce((total, stretch) => total + wall(stretch), 0);
  return {
    floor: horizontal,
    ceiling: horizontal,
    'yellow wall': sum(stretches.filter(isYellow)),
    walls: sum(stretches.filter((stretch) => !isYellow(stretch))),
  };
}

/** Rectangles of the plan [x0, z0, x1, z1] in cells; the spine is cut where an arm begins or ends. */
function planRectangles() {
  const cuts = [...new Set([0, spine.length, ...arms.flatMap((a) => [a.start, a.start + a.width])])];
  cuts.sort((a, b) => a - b);
  const pieces = cuts.slice(1).map((z, i) => [0, cuts[i], spine.width, z]);
  return [...pieces, ...armRectangles()];
}

const armRectangles = () =>
  arms.map(({ start, width }) => [spine.width, start, spine.width + armDepth, start + width]);

function horizontal(material, rectangles, y, up) {
  const shape = new Shape();
  for (const [x0, z0, x1, z1] of rectangles) {
    const corners = [[x0, z1], [x1, z1], [x1, z0], [x0, z0]]; // prettier-ignore
    const points = corners.map(([x, z]) => [x * cell, y, z * cell]);
    shape.quad(material, up ? points : points.reverse());
  }
  return shape;
}

function walls(material, stretches) {
  const shape = new Shape();
  const top = height * cell;
  for (const [[x0, z0], [x1, z1]] of stretches) {
    const [a, b] = [[x0 * cell, z0 * cell], [x1 * cell, z1 * cell]]; // prettier-ignore
    shape.quad(material, [
      [a[0], 0, a[1]],
      [a[0], top, a[1]],
      [b[0], top, b[1]],
      [b[0], 0, b[1]],
    ]);
  }
  return shape;
}

export function makeRoom() {
  const total = Object.values(cellCounts()).reduce((a, b) => a + b, 0);
  if (total !== 1546) throw new Error(`the E corridor has ${total} cells instead of 1546`);

  const room = new Room('E corridor');
  const top = height * cell;
  const spineCeiling = [[0, 0, spine.width, spine.length]];
  const stretches = wallStretches();
  room.place('floor', horizontal('stone tiles', planRectangles(), 0, true), {
    fiatlux: { reflectance: 0.3 },
  });
  room.place('ceiling spine', horizontal('ceiling panels 0.75', spineCeiling, top, false), {
    fiatlux: { surface: 'ceiling', reflectance: 0.7, mount: true, siteSpacing: cell },
  });
  room.place('ceiling arms', horizontal('ceiling panels 0.75', armRectangles(), top, false), {
    fiatlux: { surface: 'ceiling', reflectance: 0.7 },
  });
  room.place('yellow wall', walls('yellow plaster', stretches.filter(isYellow)), {
    fiatlux: { reflectance: 0.5 },
  });
  room.place(
    'walls',
    walls(
      'grey plaster',
      stretches.filter((stretch) => !isYellow(stretch)),
    ),
    {
      fiatlux: { surface: 'walls', reflectance: 0.5 },
    },
  );
  return room;
}

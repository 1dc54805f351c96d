// Furniture of the sample rooms: closed solids that stand 1 mm above the floor and 1 mm apart, so that no ray
// enters a piece. Each maker returns shapes around the origin, front towards +z, feet on y = 0.
import { Shape, chain, leaned, moved, turned } from './shape.mjs';

const gap = 0.001; // m

/**
 * A table: { top, body }. The top is only the upward face of the board, a surface of its own;
 * the body closes the board and carries it on two frames of square tube.
 */
export function table(width, depth, height, { board, legs, thickness = 0.025, inset = 0.06, tube = 0.045 }) {
  const [x, z] = [width / 2, depth / 2];
  const top = new Shape().quad(board, [[-x, height, z], [x, height, z], [x, height, -z], [-x, height, -z]]); // prettier-ignore
  const body = new Shape().box(board, [-x, height - thickness, -z], [x, height, z], '+y');
  const under = height - thickness - gap;
  for (const side of [-1, 1]) {
    const near = side * (x - inset);
    const [x0, x1] = [Math.min(near, near - side * tube), Math.max(near, near - side * tube)];
    for (const end of [-1, 1]) {
      const far = end * (z - inset);
      body.box(
        legs,
        [x0, gap, Math.min(far, far - end * tube)],
        [x1, under - tube, Math.max(far, far - end * tube)],
      );
    }
    body.box(legs, [x0, under - tube + gap, -z + inset], [x1, under, z - inset]);
  }
  return { top, body };
}

/** A swivel chair on a five-star base. */
export function swivelChair(fabric, plastic) {
  const chair = new Shape();
  for (let i = 0; i < 5; i++) {
    const spoke = turned((2 * Math.PI * i) / 5 + 0.3);
    const arm = [[0.045, 0.1, 0], [0.3, 0.07, 0]]; // prettier-ignore
    chair.add(new Shape().tube(plastic, arm, [0.024, 0.013], { segments: 4 }), spoke);
    chair.add(new Shape().rod(plastic, [0.3, 0.028, -0.022], [0.3, 0.028, 0.022], 0.027, 6), spoke);
  }
  chair.lathe(plastic, [[0.04, 0.075], [0.04, 0.2], [0.028, 0.205], [0.028, 0.4]], 12); // prettier-ignore
  chair.box(plastic, [-0.13, 0.401, -0.12], [0.13, 0.425, 0.12]);
  chair.cushion(fabric, [0.48, 0.07, 0.46], 0.426, 0.1, 0.025, 2);
  // note: the cushion is made lying; leaning it by a quarter turn stands it up with its upper side to +z
  const back = new Shape().cushion(fabric, [0.45, 0.055, 0.54], 0, 0.1, 0.02, 2);
  chair.add(back, chain(leaned(Math.PI / 2 - 0.14), moved(0, 0.86, -0.235)));
  const spine = [[0, 0.41, -0.125], [0, 0.43, -0.235], [0, 0.72, -0.258]]; // prettier-ignore
  chair.tube(plastic, spine, 0.018, { segments: 4 });
  const rest = new Shape().cushion(plastic, [0.07, 0.025, 0.24], 0.655, 0.03, 0.006, 1);
  for (const side of [-1, 1]) {
    chair.add(rest, moved(side * 0.285, 0, -0.01));
    const bracket = [[side * 0.132, 0.412, -0.01], [side * 0.285, 0.43, -0.01], [side * 0.285, 0.654, -0.01]]; // prettier-ignore
    chair.tube(plastic, bracket, 0.012, { segments: 4 });
  }
  return chair;
}

/** A shell chair on four splayed legs. */
export function shellChair(seat, legs, scaleBy = 1) {
  const chair = new Shape();
  const seatHeight = 0.44 * scaleBy;
  chair.cushion(seat, [0.42 * scaleBy, 0.022, 0.4 * scaleBy], seatHeight, 0.09, 0.006, 2);
  const back = new Shape().cushion(seat, [0.4 * scaleBy, 0.018, 0.24 * scaleBy], 0, 0.07, 0.005, 2);
  chair.add(back, chain(leaned(Math.PI / 2 - 0.2), moved(0, seatHeight + 0.29 * scaleBy, -0.235 * scaleBy)));
  for (const side of [-1, 1]) {
    const x = side * 0.15 * scaleBy;
    const stay = [[x, seatHeight - 0.013, -0.1], [x, seatHeight - 0.005, -0.215 * scaleBy - 0.01], [x, seatHeight + 0.34 * scaleBy, -0.285 * scaleBy]]; // prettier-ignore
    chair.tube(legs, stay, 0.01, { segments: 6 });
    for (const end of [-1, 1]) {
      const foot = [side * 0.205 * scaleBy, gap, end * 0.2 * scaleBy];
      chair.tube(legs, [foot, [side * 0.13 * scaleBy, seatHeight - gap, end * 0.13 * scaleBy]], [0.011, 0.014], { segments: 8 }); // prettier-ignore
    }
  }
  return chair;
}

/** A monitor on a foot; its screen looks towards +z, its foot stands on y = 0. */
export function monitor(screen, plastic, width = 0.56, height = 0.33) {
  const shape = new Shape();
  shape.cushion(plastic, [0.24, 0.012, 0.18], gap, 0.03, 0.003, 1);
  shape.box(plastic, [-0.025, 0.014, -0.05], [0.025, 0.3, -0.036]);
  const [x, y0, y1, z] = [width / 2, 0.13, 0.13 + height, 0.008];
  shape.box(plastic, [-x, y0, -0.035], [x, y1, z], '+z');
  const rim = 0.009;
  const [a, b, c] = [x - rim, y0 + rim, y1 - rim];
  for (const [x0, yl, x1, yh] of [[-x, y0, x, b], [-x, c, x, y1], [-x, b, -a, c], [a, b, x, c]]) // prettier-ignore
    shape.quad(plastic, [[x0, yl, z], [x1, yl, z], [x1, yh, z], [x0, yh, z]]); // prettier-ignore
  return shape.quad(screen, [[-a, b, z], [a, b, z], [a, c, z], [-a, c, z]]); // prettier-ignore
}

/** A keyboard and a mouse on a desk, in front of a monitor at the origin. */
export function keyboardAndMouse(plastic) {
  const shape = new Shape().cushion(plastic, [0.43, 0.014, 0.13], gap, 0.015, 0.004, 1);
  return shape.add(
    new Shape().cushion(plastic, [0.06, 0.028, 0.1], gap, 0.028, 0.009, 1),
    moved(0.31, 0, 0.01),
  );
}

/** A cupboard on a plinth frame of legs, with doors or drawers drawn by their joints. Back on z = 0, front at depth. */
export function cupboard(
  [width, height, depth],
  { carcass, front, legs, columns = 2, rows = 1, legHeight = 0.1 },
) {
  const shape = new Shape();
  const half = width / 2;
  for (const x of [-half + 0.05, half - 0.05])
    for (const z of [0.05, depth - 0.05])
      shape.box(legs, [x - 0.018, gap, z - 0.018], [x + 0.018, legHeight - gap, z + 0.018]);
  shape.box(carcass, [-half, legHeight, 0], [half, height, depth - 0.02]);
  const [w, h] = [(width - 0.004) / columns, (height - legHeight - 0.004) / rows];
  for (let i = 0; i < columns; i++)
    for (let j = 0; j < rows; j++) {
      const [x, y] = [-half + 0.002 + i * w, legHeight + 0.002 + j * h];
      shape.box(front, [x + 0.002, y + 0.002, depth - 0.019], [x + w - 0.002, y + h - 0.002, depth]);
      const grip =
        rows > 1 ? [x + w / 2 - 0.06, y + h - 0.06] : [i % 2 ? x + 0.035 : x + w - 0.047, y + h / 2 - 0.06];
      const size = rows > 1 ? [0.12, 0.012] : [0.012, 0.12];
      shape.box(legs, [grip[0], grip[1], depth + gap], [grip[0] + size[0], grip[1] + size[1], depth + 0.018]);
    }
  return shape;
}

/** Open shelves with books; back on z = 0. colours: materials of the spines; random: see random.mjs. */
export function bookcase([width, height, depth], { board, colours, random, shelves = 4, legHeight = 0.06 }) {
  const shape = new Shape();
  const [half, t] = [width / 2, 0.022];
  for (const side of [-1, 1]) {
    const x = side > 0 ? half - t : -half;
    shape.box(board, [x, gap, 0], [x + t, height, depth]);
  }
  const pitch = (height - t - legHeight) / shelves;
  for (let i = 0; i <= shelves; i++) {
    const y = legHeight + i * pitch;
    shape.box(board, [-half + t + gap, y, 0.008], [half - t - gap, y + t, depth - 0.004]);
    if (i === shelves) break;
    let x = -half + t + 0.01;
    const end = half - t - random.between(0.02, 0.35) * width;
    while (x < end - 0.06) {
      const [w, h] = [random.between(0.025, 0.055), pitch * random.between(0.6, 0.82)];
      shape.box(
        random.pick(colours),
        [x, y + t + gap, 0.03],
        [x + w, y + t + h, depth - random.between(0.03, 0.06)],
      );
      x += w + 0.002;
    }
  }
  shape.box(board, [-half + t + gap, legHeight + t + gap, gap], [half - t - gap, height - t - gap, 0.007]);
  return shape;
}

/** A round table on a column; { top, body } as table(). */
export function roundTable(radius, height, { board, metal, segments = 32 }) {
  const ring = Array.from({ length: segments }, (_, i) => {
    const angle = (2 * Math.PI * i) / segments;
    return [radius * Math.cos(angle), height, -radius * Math.sin(angle)];
  });
  const top = new Shape().fan(board, ring);
  const lower = ring.map(([x, , z]) => [x, height - 0.025, z]);
  const body = new Shape().loft(board, [lower, ring], { capEnd: false });
  body.lathe(metal, [[0.3, gap], [0.3, 0.012], [0.05, 0.03], [0.035, 0.06], [0.035, height - 0.06], [0.16, height - 0.027]], 24); // prettier-ignore
  return { top, body };
}

/** A sofa: seat, back, arms and cushions over short legs. */
export function sofa(width, fabric, accent, legs) {
  const shape = new Shape();
  const arm = 0.14;
  const inner = width - 2 * arm - 2 * gap;
  for (const x of [-width / 2 + 0.1, width / 2 - 0.1])
    for (const z of [-0.34, 0.34]) shape.rod(legs, [x, gap, z], [x, 0.139, z], 0.02);
  shape.add(new Shape().cushion(fabric, [width, 0.14, 0.82], 0.14, 0.05, 0.02));
  for (const side of [-1, 1]) {
    shape.add(new Shape().cushion(fabric, [arm, 0.33, 0.82], 0.281, 0.05, 0.03), moved(side * (width / 2 - arm / 2), 0, 0)); // prettier-ignore
    shape.add(new Shape().cushion(fabric, [inner / 2 - gap, 0.15, 0.6], 0.281, 0.05, 0.035), moved((side * inner) / 4, 0, 0.1)); // prettier-ignore
  }
  shape.add(new Shape().cushion(fabric, [inner, 0.52, 0.18], 0.281, 0.05, 0.04), moved(0, 0, -0.31));
  const pillow = new Shape().cushion(accent, [0.42, 0.13, 0.42], 0, 0.09, 0.06);
  const stand = chain(leaned(Math.PI / 2 - 0.3), moved(-inner / 2 + 0.26, 0.665, -0.15));
  return shape.add(pillow, stand);
}

/** A bench of one thick board on two cheeks. */
export function bench(width, depth, height, board, legs) {
  const shape = new Shape().box(
    board,
    [-width / 2, height - 0.07, -depth / 2],
    [width / 2, height, depth / 2],
  );
  for (const side of [-1, 1]) {
    const x = side * (width / 2 - 0.25);
    shape.box(legs, [x - 0.03, gap, -depth / 2 + 0.05], [x + 0.03, height - 0.07 - gap, depth / 2 - 0.05]);
  }
  return shape;
}

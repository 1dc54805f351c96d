// The shell of a rectangular room [0, width] x [0, height] x [0, depth], seen from inside, and what is let into it.
// Pictures, doors and windows are cut into the walls, so that no patch of wall hides behind them.
import { Shape } from './shape.mjs';

/** Point of wall coordinates: u to the right and v up as seen from the room, d from the wall into the room (m). */
export function wallFrames(width, depth) {
  return {
    north: { length: width, point: (u, v, d) => [u, v, d] },
    south: { length: width, point: (u, v, d) => [width - u, v, depth - d] },
    west: { length: depth, point: (u, v, d) => [d, v, depth - u] },
    east: { length: depth, point: (u, v, d) => [width - d, v, u] },
  };
}

/** One flat rectangle [u0, v0, u1, v1] at depth d; uvs: the whole picture once, upright. */
export function panel(shape, frame, material, [u0, v0, u1, v1], d = 0, wholePicture = false) {
  const corners = [
    frame.point(u0, v0, d),
    frame.point(u1, v0, d),
    frame.point(u1, v1, d),
    frame.point(u0, v1, d),
  ];
  shape.quad(material, corners, wholePicture ? [[0, 1], [1, 1], [1, 0], [0, 0]] : null); // prettier-ignore
}

/** A flat rectangle with rectangular holes, cut without T-junctions inside it. */
export function panelWithHoles(shape, frame, material, rectangle, holes, d = 0) {
  const cutsOf = (low, high) =>
    [...new Set([rectangle[low], rectangle[high], ...holes.flatMap((hole) => [hole[low], hole[high]])])]
      .filter((cut) => cut >= rectangle[low] && cut <= rectangle[high])
      .sort((a, b) => a - b);
  const [us, vs] = [cutsOf(0, 2), cutsOf(1, 3)];
  const covered = (u, v) => holes.some(([u0, v0, u1, v1]) => u > u0 && u < u1 && v > v0 && v < v1);
  for (let i = 0; i + 1 < us.length; i++)
    for (let j = 0; j + 1 < vs.length; j++)
      if (!covered((us[i] + us[i + 1]) / 2, (vs[j] + vs[j + 1]) / 2))
        panel(shape, frame, material, [us[i], vs[j], us[i + 1], vs[j + 1]], d);
}

/**
 * The four sides that join a rectangle's outline at depth `from` with the same outline at depth `to`.
 * They face away from the rectangle where it stands out (to > from) and into the recess where it lies back.
 */
export function sides(shape, frame, material, [u0, v0, u1, v1], from, to) {
  const { point } = frame;
  const side = (ua, va, ub, vb) =>
    shape.quad(material, [point(ua, va, from), point(ub, vb, from), point(ub, vb, to), point(ua, va, to)]);
  side(u0, v0, u1, v0);
  side(u1, v0, u1, v1);
  side(u1, v1, u0, v1);
  side(u0, v1, u0, v0);
}

/**
 * A frame with columns x rows panes in the wall: the frame stands at depth `at`, its panes at depth `pane`.
 * bar: width of the frame's members (m); paneMaterial may be left out when the caller fills the panes.
 * Returns the rectangles of the panes.
 */
export function gridFrame(
  shape,
  frame,
  rectangle,
  { material, paneMaterial, bar, at, pane, columns = 1, rows = 1 },
) {
  const [u0, v0, u1, v1] = rectangle;
  const paneWidth = (u1 - u0 - bar * (columns + 1)) / columns;
  const paneHeight = (v1 - v0 - bar * (rows + 1)) / rows;
  const panes = [];
  for (let i = 0; i < columns; i++)
    for (let j = 0; j < rows; j++) {
      const [u, v] = [u0 + bar + i * (paneWidth + bar), v0 + bar + j * (paneHeight + bar)];
      panes.push([u, v, u + paneWidth, v + paneHeight]);
    }
  sides(shape, frame, material, rectangle, 0, at);
  panelWithHoles(shape, frame, material, rectangle, panes, at);
  for (const rect of panes) {
    sides(shape, frame, material, rect, at, pane);
    if (paneMaterial) panel(shape, frame, paneMaterial, rect, pane);
  }
  return panes;
}

/** A door leaf set back in the wall, with a flush architrave; rectangle: the leaf. Returns the outline with architrave. */
export function door(shape, frame, [u0, , u1, top], { material, frameMaterial, metal, architrave = 0.09 }) {
  const outline = [u0 - architrave, 0, u1 + architrave, top + architrave];
  const leaf = [u0, 0, u1, top];
  panelWithHoles(shape, frame, frameMaterial, outline, [leaf]);
  sides(shape, frame, frameMaterial, leaf, 0, -0.06);
  panel(shape, frame, material, leaf, -0.06);
  const knob = u1 - 0.09;
  shape.rod(metal, frame.point(knob, 1.05, -0.059), frame.point(knob, 1.05, -0.005), 0.011);
  shape.rod(metal, frame.point(knob + 0.01, 1.05, 0.007), frame.point(knob - 0.12, 1.05, 0.007), 0.01);
  return outline;
}

/** A wall with its openings cut out, above a flush skirting board that the openings interrupt. */
export function wall(
  shape,
  skirtingShape,
  frame,
  height,
  openings,
  { material, skirting, skirtingHeight = 0.09 },
) {
  panelWithHoles(shape, frame, material, [0, skirtingHeight, frame.length, height], openings);
  const low = openings.filter((opening) => opening[1] < skirtingHeight);
  panelWithHoles(skirtingShape, frame, skirting, [0, 0, frame.length, skirtingHeight], low);
}

/** A horizontal rectangle, facing up or down. */
export function slab(material, [x0, z0, x1, z1], y, facing = 'up') {
  const corners = [[x0, y, z1], [x1, y, z1], [x1, y, z0], [x0, y, z0]]; // prettier-ignore
  return new Shape().quad(material, facing === 'up' ? corners : corners.reverse());
}

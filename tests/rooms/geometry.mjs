// Measures of triangle soups for the tests of the sample rooms.
// A triangle is three points [x, y, z] in metres, counter-clockwise seen from its front.
import { cross, dot, length, scale, subtract, unit } from '../../web/room-maker/shape.mjs';

const grid = 1e-4; // m, points closer than this are one
const snapped = (p) => p.map((c) => Math.round(c / grid + 0.137));

export const areaOf = ([a, b, c]) => length(cross(subtract(b, a), subtract(c, a))) / 2;
export const normalOf = ([a, b, c]) => unit(cross(subtract(b, a), subtract(c, a)));

/** Volume enclosed by outward-facing triangles, by the divergence theorem; negative when they face inwards. */
export const volumeOf = (triangles) => triangles.reduce((sum, [a, b, c]) => sum + dot(a, cross(b, c)), 0) / 6;

/**
 * Metres of edge that no neighbour closes. Every edge must be walked once in each direction; where a long edge
 * meets several short ones on a line along an axis, their stretches are compared instead.
 */
export function openEdgeLength(triangles) {
  const net = new Map();
  for (const triangle of triangles) {
    const points = triangle.map(snapped);
    points.forEach((from, i) => {
      const to = points[(i + 1) % 3];
      const [key, back] = [`${from}|${to}`, `${to}|${from}`];
      if (net.has(back)) change(net, back, -1, from, to);
      else change(net, key, 1, from, to);
    });
  }

  let open = 0;
  const lines = new Map();
  for (const { count, from, to } of net.values()) {
    const axes = [0, 1, 2].filter((axis) => from[axis] !== to[axis]);
    if (axes.length !== 1) {
      open += count * length(subtract(to, from)) * grid;
      continue;
    }
    const axis = axes[0];
    const line = `${axis}:${from.filter((_, i) => i !== axis)}`;
    if (!lines.has(line)) lines.set(line, []);
    lines.get(line).push([from[axis], count], [to[axis], -count]);
  }
  for (const ends of lines.values()) {
    ends.sort((a, b) => a[0] - b[0]);
    let running = 0;
    ends.forEach(([at, step], i) => {
      if (i > 0) open += Math.abs(running) * (at - ends[i - 1][0]) * grid;
      running += step;
    });
  }
  return open;
}

function change(net, key, step, from, to) {
  const entry = net.get(key) ?? { count: 0, from, to };
  entry.count += step;
  if (entry.count === 0) net.delete(key);
  else net.set(key, entry);
}

const boxOf = (points) => [0, 1, 2].map((axis) => { const at = points.map((p) => p[axis]); return [Math.min(...at), Math.max(...at)]; }); // prettier-ignore
const meet = (a, b) => a.every(([low, high], axis) => low < b[axis][1] - grid && b[axis][0] < high - grid);

/** Whether a stretch from `from` to `to` goes through a triangle, well within both. */
function pierces(from, to, [a, b, c]) {
  const [along, u, v] = [subtract(to, from), subtract(b, a), subtract(c, a)];
  const across = cross(along, v);
  const determinant = dot(u, across);
  if (Math.abs(determinant) < 1e-12) return false;
  const start = subtract(from, a);
  const s = dot(start, across) / determinant;
  const q = cross(start, u);
  const t = dot(along, q) / determinant;
  const at = dot(v, q) / determinant;
  const inside = 1e-4;
  return s > inside && t > inside && s + t < 1 - inside && at > inside && at < 1 - inside;
}

/** Pairs of names whose triangles go through one another. `objects`: { name, triangles } each. */
export function crossings(objects) {
  const boxed = objects.map(({ name, triangles }) => {
    const parts = triangles.map((points) => ({ points, box: boxOf(points) }));
    return { name, parts, box: boxOf(triangles.flat()) };
  });
  const edges = ([a, b, c]) => [[a, b], [b, c], [c, a]]; // prettier-ignore
  const goThrough = (a, b) => edges(a).some(([p, q]) => pierces(p, q, b)) || edges(b).some(([p, q]) => pierces(p, q, a)); // prettier-ignore
  const found = [];
  boxed.forEach((one, i) => {
    for (const other of boxed.slice(i + 1)) {
      if (!meet(one.box, other.box)) continue;
      const near = other.parts.filter(({ box }) => meet(box, one.box));
      const isCrossed = one.parts.some((a) => meet(a.box, other.box) && near.some((b) => meet(a.box, b.box) && goThrough(a.points, b.points))); // prettier-ignore
      if (isCrossed) found.push(`${one.name} and ${other.name}`);
    }
  });
  return found;
}

/** Square metres in which two triangles lie in one plane over one another, whichever way they face. */
export function doubleSurfaceArea(triangles) {
  const planes = new Map();
  for (const triangle of triangles) {
    let normal = normalOf(triangle);
    const leading = normal.find((c) => Math.abs(c) > 1e-3);
    if (leading < 0) normal = scale(normal, -1);
    const key = [
      ...normal.map((c) => Math.round(c * 500)),
      Math.round(dot(normal, triangle[0]) / 2e-4),
    ].join();
    if (!planes.has(key)) planes.set(key, { normal, members: [] });
    planes.get(key).members.push(triangle);
  }
  let sum = 0;
  for (const { normal, members } of planes.values()) {
    const flat = members.map((triangle) => flattened(triangle, normal));
    for (let i = 0; i < flat.length; i++)
      for (let j = i + 1; j < flat.length; j++) {
        const area = overlap(flat[i], flat[j]);
        if (area > 1e-6) sum += area;
      }
  }
  return sum;
}

function flattened(triangle, normal) {
  const side = unit(cross(normal, Math.abs(normal[1]) > 0.9 ? [1, 0, 0] : [0, 1, 0]));
  const up = cross(normal, side);
  const flat = triangle.map((p) => [dot(p, side), dot(p, up)]);
  return signedArea(flat) < 0 ? flat.reverse() : flat;
}

const signedArea = (polygon) =>
  polygon.reduce((sum, [x, y], i) => {
    const [nextX, nextY] = polygon[(i + 1) % polygon.length];
    return sum + (x * nextY - nextX * y) / 2;
  }, 0);

/** Area common to two convex polygons: one is clipped by the edges of the other. */
function overlap(subject, clip) {
  for (const axis of [0, 1]) {
    const [a, b] = [subject.map((p) => p[axis]), clip.map((p) => p[axis])];
    if (Math.max(...a) <= Math.min(...b) || Math.max(...b) <= Math.min(...a)) return 0;
  }
  let polygon = subject;
  clip.forEach(([x0, y0], i) => {
    const [x1, y1] = clip[(i + 1) % clip.length];
    const inside = ([x, y]) => (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0);
    const next = [];
    polygon.forEach((p, k) => {
      const q = polygon[(k + 1) % polygon.length];
      const [dp, dq] = [inside(p), inside(q)];
      if (dp >= 0) next.push(p);
      if (dp >= 0 !== dq >= 0) {
        const t = dp / (dp - dq);
        next.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
      }
    });
    polygon = next;
  });
  return polygon.length < 3 ? 0 : signedArea(polygon);
}

// Plane geometry of outlines: simple polygons as lists of corners [x, z] in metres.
// Seen from above (x to the right, z towards the viewer) an outline runs clockwise: its signed area is positive.
import earcut from 'earcut';

const subtract = ([ax, az], [bx, bz]) => [ax - bx, az - bz];
const cross = ([ax, az], [bx, bz]) => ax * bz - az * bx;

export const distance = (a, b) => Math.hypot(b[0] - a[0], b[1] - a[1]);

/** m2, positive for an outline in its usual sense. */
export function signedArea(polygon) {
  let twice = 0;
  polygon.forEach((a, i) => (twice += cross(a, polygon[(i + 1) % polygon.length])));
  return twice / 2;
}

/** Whether a point lies inside (on the outline: undecided). */
export function contains(polygon, [x, z]) {
  let inside = false;
  polygon.forEach(([ax, az], i) => {
    const [bx, bz] = polygon[(i + 1) % polygon.length];
    if (az > z !== bz > z && x < ax + ((z - az) / (bz - az)) * (bx - ax)) inside = !inside;
  });
  return inside;
}

/** Distance of a point from the outline, m. */
export function distanceToOutline(polygon, p) {
  return Math.min(
    ...polygon.map((a, i) => {
      const along = subtract(polygon[(i + 1) % polygon.length], a);
      const [px, pz] = subtract(p, a);
      const squared = along[0] ** 2 + along[1] ** 2 || 1;
      const t = Math.min(1, Math.max(0, (px * along[0] + pz * along[1]) / squared));
      return Math.hypot(px - t * along[0], pz - t * along[1]);
    }),
  );
}

/** Whether two stretches cross or touch. */
function meet(a, b, c, d) {
  const side = (p, q, r) => Math.sign(cross(subtract(q, p), subtract(r, p)));
  const [s1, s2, s3, s4] = [side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b)];
  if (s1 !== s2 && s3 !== s4) return true;
  const on = (p, q, r, s) => s === 0 && distance(p, r) + distance(r, q) - distance(p, q) < 1e-9;
  return on(a, b, c, s1) || on(a, b, d, s2) || on(c, d, a, s3) || on(c, d, b, s4);
}

/** Whether no two walls cross or touch, but for neighbours at their common corner. */
export function isSimple(polygon) {
  const count = polygon.length;
  for (let i = 0; i < count; i++)
    for (let j = i + 1; j < count; j++) {
      const [a, b] = [polygon[i], polygon[(i + 1) % count]];
      const [c, d] = [polygon[j], polygon[(j + 1) % count]];
      const isNext = j === i + 1;
      const isBefore = (j + 1) % count === i;
      if (!isNext && !isBefore) {
        if (meet(a, b, c, d)) return false;
      } else {
        // neighbours must not fold back onto each other
        const [corner, before, after] = isNext ? [b, a, d] : [a, b, c];
        const [u, w] = [subtract(before, corner), subtract(after, corner)];
        if (Math.abs(cross(u, w)) < 1e-9 && u[0] * w[0] + u[1] * w[1] > 0) return false;
      }
    }
  return true;
}

/** Whether polygon b lies wholly inside a, at least `clearance` m from its outline. */
export function holds(a, b, clearance = 0) {
  const clear = (from, to) => from.every((p) => distanceToOutline(to, p) >= clearance);
  if (!b.every((p) => contains(a, p)) || !clear(b, a) || !clear(a, b)) return false;
  return !cross2(a, b);
}

/** Whether two polygons lie apart by at least `clearance` m. */
export function areApart(a, b, clearance = 0) {
  if (a.some((p) => contains(b, p)) || b.some((p) => contains(a, p)) || cross2(a, b)) return false;
  return [...a.map((p) => distanceToOutline(b, p)), ...b.map((p) => distanceToOutline(a, p))].every(
    (each) => each >= clearance,
  );
}

const cross2 = (a, b) =>
  a.some((p, i) => b.some((q, j) => meet(p, a[(i + 1) % a.length], q, b[(j + 1) % b.length])));

/**
 * The outline drawn in by `by` m; null where walls would vanish or meet: the room is too narrow for it.
 */
export function inset(polygon, by) {
  if (by === 0) return polygon.map((p) => [...p]);
  const count = polygon.length;
  const lines = polygon.map((a, i) => {
    const b = polygon[(i + 1) % count];
    const length = distance(a, b);
    const [tx, tz] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    return { at: [a[0] - tz * by, a[1] + tx * by], along: [tx, tz] };
  });
  const corners = lines.map((line, i) => {
    const before = lines[(i + count - 1) % count];
    const turn = cross(before.along, line.along);
    if (Math.abs(turn) < 1e-9) return line.at;
    const t = cross(subtract(line.at, before.at), line.along) / turn;
    return [before.at[0] + t * before.along[0], before.at[1] + t * before.along[1]];
  });
  const runsOn = corners.every((corner, i) => {
    const [dx, dz] = subtract(corners[(i + 1) % count], corner);
    return dx * lines[i].along[0] + dz * lines[i].along[1] > 1e-6;
  });
  return runsOn && isSimple(corners) && signedArea(corners) > 0 ? corners : null;
}

/** Triangles (three corners each, in the sense of the outline) of a polygon with holes. */
export function triangles(polygon, holes = []) {
  const corners = [polygon, ...holes].flat();
  const starts = [];
  let at = polygon.length;
  for (const hole of holes) {
    starts.push(at);
    at += hole.length;
  }
  const indices = earcut(corners.flat(), starts);
  const found = [];
  for (let i = 0; i < indices.length; i += 3) {
    const triangle = [corners[indices[i]], corners[indices[i + 1]], corners[indices[i + 2]]];
    const area = signedArea(triangle);
    if (Math.abs(area) > 1e-12) found.push(area > 0 ? triangle : triangle.reverse());
  }
  return found;
}

/** The part of a convex polygon with sign * (p[axis] - at) >= 0. */
export function clipped(polygon, axis, at, sign) {
  const kept = [];
  polygon.forEach((a, i) => {
    const b = polygon[(i + 1) % polygon.length];
    const [da, db] = [sign * (a[axis] - at), sign * (b[axis] - at)];
    if (da >= 0) kept.push(a);
    if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
      const t = da / (da - db);
      kept.push([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]);
    }
  });
  return kept.length < 3 ? [] : kept;
}

/** Stretches [from, to] of the line p[axis] = at that lie inside, along the other axis. */
export function stretchesAt(polygon, axis, at) {
  const cuts = [];
  polygon.forEach((a, i) => {
    const b = polygon[(i + 1) % polygon.length];
    if (a[axis] > at === b[axis] > at) return;
    const t = (at - a[axis]) / (b[axis] - a[axis]);
    cuts.push(a[1 - axis] + t * (b[1 - axis] - a[1 - axis]));
  });
  cuts.sort((p, q) => p - q);
  const stretches = [];
  for (let i = 0; i + 1 < cuts.length; i += 2) stretches.push([cuts[i], cuts[i + 1]]);
  return stretches;
}

/** Points turned by degrees about the origin: counter-clockwise as seen from above. */
export function rotated(points, degrees) {
  if (degrees === 0) return points.map((p) => [...p]);
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  return points.map(([x, z]) => [c * x + s * z, -s * x + c * z]);
}

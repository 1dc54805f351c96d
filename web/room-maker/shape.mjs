// Triangles of one object, grouped by material, and the solids that furniture is made of.
// Metres, y up, counter-clockwise front faces; solids are closed and face outwards.
// A texture coordinate is given with the face, or projected along the face's main axis in metres.

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length = (a) => Math.hypot(a[0], a[1], a[2]);
export const unit = (a) => scale(a, 1 / length(a));

/** Point maps for Shape.add; each keeps the orientation. */
export const moved = (x, y, z) => (p) => [p[0] + x, p[1] + y, p[2] + z];
export const turned = (angle) => {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return (p) => [c * p[0] + s * p[2], p[1], -s * p[0] + c * p[2]];
};
/** Leans about the x axis: positive angles take y towards z. */
export const leaned = (angle) => {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return (p) => [p[0], c * p[1] - s * p[2], s * p[1] + c * p[2]];
};
export const chain =
  (...maps) =>
  (p) =>
    maps.reduce((q, map) => map(q), p);

/** Points of a circle in the xz plane, counter-clockwise seen from above. */
export function circle(radius, y, segments, center = [0, 0]) {
  return Array.from({ length: segments }, (_, i) => {
    const angle = (2 * Math.PI * i) / segments;
    return [center[0] + radius * Math.cos(angle), y, center[1] - radius * Math.sin(angle)];
  });
}

/** A rectangle with round corners in the xz plane, centred, counter-clockwise seen from above. */
export function roundedRectangle(width, depth, radius, y, cornerSegments = 3) {
  const points = [];
  for (let corner = 0; corner < 4; corner++) {
    const cx = (width / 2 - radius) * (corner === 0 || corner === 3 ? 1 : -1);
    const cz = (depth / 2 - radius) * (corner < 2 ? -1 : 1);
    for (let i = 0; i <= cornerSegments; i++) {
      const angle = (Math.PI / 2) * (corner + i / cornerSegments);
      points.push([cx + radius * Math.cos(angle), y, cz - radius * Math.sin(angle)]);
    }
  }
  return points;
}

export class Shape {
  /** @type {{material: string, points: number[][], uvs: number[][] | null}[]} triangles */
  triangles = [];

  triangle(material, points, uvs = null) {
    const normal = cross(subtract(points[1], points[0]), subtract(points[2], points[0]));
    if (length(normal) > 1e-10) this.triangles.push({ material, points, uvs });
    return this;
  }

  /** A planar quadrilateral a, b, c, d. */
  quad(material, [a, b, c, d], uvs = null) {
    this.triangle(material, [a, b, c], uvs && [uvs[0], uvs[1], uvs[2]]);
    return this.triangle(material, [a, c, d], uvs && [uvs[0], uvs[2], uvs[3]]);
  }

  /** An axis-parallel block; open: faces to leave out, a string such as '+y' or '-y +z'. */
  box(material, [x0, y0, z0], [x1, y1, z1], open = '') {
    const faces = {
      '-x': [[x0, y0, z0], [x0, y0, z1], [x0, y1, z1], [x0, y1, z0]],
      '+x': [[x1, y0, z1], [x1, y0, z0], [x1, y1, z0], [x1, y1, z1]],
      '-y': [[x0, y0, z0], [x1, y0, z0], [x1, y0, z1], [x0, y0, z1]],
      '+y': [[x0, y1, z1], [x1, y1, z1], [x1, y1, z0], [x0, y1, z0]],
      '-z': [[x1, y0, z0], [x0, y0, z0], [x0, y1, z0], [x1, y1, z0]],
      '+z': [[x0, y0, z1], [x1, y0, z1], [x1, y1, z1], [x0, y1, z1]],
    }; // prettier-ignore
    for (const [side, corners] of Object.entries(faces))
      if (!open.includes(side)) this.quad(material, corners);
    return this;
  }

  /**
   * A skin over rings of equally many points, each counter-clockwise seen from where the rings lead to.
   * Ends are closed by fans; loop: the last ring joins the first instead.
   */
  loft(material, rings, { loop = false, capStart = true, capEnd = true } = {}) {
    const count = rings[0].length;
    const spans = loop ? rings.length : rings.length - 1;
    for (let i = 0; i < spans; i++) {
      const [low, high] = [rings[i], rings[(i + 1) % rings.length]];
      for (let j = 0; j < count; j++) {
        const k = (j + 1) % count;
        this.quad(material, [low[j], low[k], high[k], high[j]]);
      }
    }
    if (!loop && capStart) this.fan(material, [...rings[0]].reverse());
    if (!loop && capEnd) this.fan(material, rings[rings.length - 1]);
    return this;
  }

  /** A flat convex polygon, as triangles around its first point. */
  fan(material, points) {
    for (let i = 1; i + 1 < points.length; i++)
      this.triangle(material, [points[0], points[i], points[i + 1]]);
    return this;
  }

  /** A solid of revolution about the vertical through center; profile: [radius, y] from below to above. */
  lathe(material, profile, segments = 16, center = [0, 0]) {
    return this.loft(
      material,
      profile.map(([radius, y]) => circle(radius, y, segments, center)),
    );
  }

  /** A round rod from one point to another. */
  rod(material, from, to, radius, segments = 8) {
    return this.tube(material, [from, to], radius, { segments });
  }

  /** A round tube along a path; radius: a number, or one a point; loop: the ends meet. */
  tube(material, path, radius, { segments = 8, loop = false } = {}) {
    const frames = carriedFrames(path, loop);
    const rings = path.map((point, i) => {
      const r = Array.isArray(radius) ? radius[i] : radius;
      const { side, up } = frames[i];
      return Array.from({ length: segments }, (_, j) => {
        const angle = (2 * Math.PI * j) / segments;
        return add(point, add(scale(side, r * Math.cos(angle)), scale(up, r * Math.sin(angle))));
      });
    });
    return this.loft(material, rings, { loop });
  }

  /** A block with round corners in plan and softened edges, centred in x and z, standing on y. */
  cushion(material, [width, height, depth], y, radius, bevel, cornerSegments = 3) {
    const ring = (inset, at) =>
      roundedRectangle(
        width - 2 * inset,
        depth - 2 * inset,
        Math.max(radius - inset, 0.001),
        at,
        cornerSegments,
      );
    const rings = [ring(bevel, y), ring(bevel * 0.3, y + bevel * 0.3), ring(0, y + bevel)];
    rings.push(
      ring(0, y + height - bevel),
      ring(bevel * 0.3, y + height - bevel * 0.3),
      ring(bevel, y + height),
    );
    return this.loft(material, rings);
  }

  /** Takes over another shape's triangles through a point map. */
  add(other, map = (p) => p) {
    for (const { material, points, uvs } of other.triangles) this.triangle(material, points.map(map), uvs);
    return this;
  }
}

/** Two directions across a path at each point, carried along it without twist; on a loop the rest is spread out. */
function carriedFrames(path, loop) {
  const last = path.length - 1;
  const along = path.map((point, i) => {
    const before = path[i - 1] ?? (loop ? path[last] : point);
    const after = path[i + 1] ?? (loop ? path[0] : point);
    return unit(subtract(after, before));
  });
  const across = (direction, i) => unit(subtract(direction, scale(along[i], dot(direction, along[i]))));
  const sides = [across(Math.abs(along[0][1]) > 0.9 ? [1, 0, 0] : [0, 1, 0], 0)];
  for (let i = 1; i <= last; i++) sides.push(across(sides[i - 1], i));
  const back = across(sides[last], 0);
  const rest = loop ? Math.atan2(dot(sides[0], cross(along[0], back)), dot(sides[0], back)) : 0;
  return sides.map((carried, i) => {
    const angle = (rest * i) / path.length;
    const side = add(scale(carried, Math.cos(angle)), scale(cross(along[i], carried), Math.sin(angle)));
    return { side, up: cross(along[i], side) };
  });
}

/**
 * Vertex arrays of one material of a shape, shared where position, normal and texture coordinate agree.
 * Normals are averaged over neighbours that turn by less than creaseDegrees; tile: texture size in metres.
 */
export function vertexArrays(triangles, tile, creaseDegrees = 50) {
  const creaseCosine = Math.cos((creaseDegrees * Math.PI) / 180);
  const key = (p) => p.map((c) => Math.round(c * 1e5)).join();
  const faceNormals = triangles.map(({ points: [a, b, c] }) => cross(subtract(b, a), subtract(c, a)));
  const facesAt = new Map();
  triangles.forEach(({ points }, face) => {
    for (const k of new Set(points.map(key))) facesAt.set(k, [...(facesAt.get(k) ?? []), face]);
  });

  const [positions, normals, uvs, indices] = [[], [], [], []];
  const known = new Map();
  triangles.forEach((triangle, face) => {
    const own = unit(faceNormals[face]);
    triangle.points.forEach((point, corner) => {
      let sum = [0, 0, 0];
      for (const other of facesAt.get(key(point)))
        if (dot(own, unit(faceNormals[other])) > creaseCosine) sum = add(sum, faceNormals[other]);
      const normal = unit(sum);
      const uv = triangle.uvs ? triangle.uvs[corner] : projected(point, own, tile);
      const name = `${key(point)};${normal.map((c) => c.toFixed(4))};${uv.map((c) => c.toFixed(5))}`;
      if (!known.has(name)) {
        known.set(name, positions.length / 3);
        positions.push(...point);
        normals.push(...normal);
        uvs.push(...uv);
      }
      indices.push(known.get(name));
    });
  });
  return { positions, normals, uvs, indices };
}

function projected(point, normal, [tileU, tileV]) {
  const [x, y, z] = normal.map(Math.abs);
  const [u, v] =
    y >= x && y >= z ? [point[0], point[2]] : x >= z ? [point[2], -point[1]] : [point[0], -point[1]];
  return [u / tileU, v / tileV];
}

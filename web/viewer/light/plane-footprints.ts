/**
 * What lies over measuring planes, as a map seen from above of the heights that planes have there (up to four, the lowest
 * first): furniture gives way where it would hide what is read on a plane, and stays everywhere else.
 */
import {
  DataTexture,
  FloatType,
  NearestFilter,
  Ray,
  RGBAFormat,
  Vector3,
  Vector4,
  type Box3,
  type Mesh,
  type Texture,
} from 'three';

const cells = 256; // along each side of the map
const levels = 4;
const none = 1e9; // m: no plane is as high
const alike = 0.05; // m: planes of one height
const flat = 0.05; // m: a plane that is no flatter is not seen from above
const given = 0.06; // m under a plane: so far down furniture gives way
const storey = 2; // m over it
const underfoot = 0.1; // m over the floor: nothing hides a lower plane but what stands on it

/** In GLSL: whether a place lies from `below` (m) under a plane to a storey over it; without, where furniture gives way. */
export const overPlaneShader = /* glsl */ `
uniform highp sampler2D planeHeights;
uniform vec4 planeFrame; // m: low x, low z; cells a metre along x and z
bool isOverPlane(vec3 place, float below) {
  vec2 at = (place.xz - planeFrame.xy) * planeFrame.zw;
  if (any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, vec2(${cells}.0)))) return false;
  vec4 over = place.y - texelFetch(planeHeights, ivec2(at), 0);
  vec4 isOver = step(vec4(-below), over) * step(over, vec4(${storey.toFixed(1)}));
  return dot(isOver, vec4(1.0)) > 0.5;
}
bool isOverPlane(vec3 place) { return isOverPlane(place, ${given.toFixed(2)}); }
`;

interface Footprints {
  readonly heights: Float32Array<ArrayBuffer>; // four a cell
  readonly frame: [number, number, number, number];
}

/** Of the shader. */
export const planeUniforms = () => ({
  planeHeights: { value: null as Texture | null },
  planeFrame: { value: new Vector4() },
});

export type PlaneUniforms = ReturnType<typeof planeUniforms>;

export class PlaneFootprints {
  #uniforms: PlaneUniforms;
  #shown = '';
  #map: Footprints = { heights: new Float32Array(0), frame: [0, 0, -1, -1] };

  constructor(uniforms: PlaneUniforms) {
    this.#uniforms = uniforms;
  }

  /** The planes that are drawn, in a room whose floor is at a height (m). */
  set(planes: readonly Mesh[], floor: number): void {
    const shown = planes.map(({ uuid }) => uuid).join();
    if (shown === this.#shown) return;
    this.#shown = shown;
    this.#uniforms.planeHeights.value?.dispose();
    this.#map = heightsOf(planes.map(cornersOf), floor);
    const { heights, frame } = this.#map;
    this.#uniforms.planeFrame.value.fromArray(frame);
    const texture = new DataTexture(heights, cells, cells, RGBAFormat, FloatType);
    texture.minFilter = texture.magFilter = NearestFilter;
    texture.needsUpdate = true;
    this.#uniforms.planeHeights.value = texture;
  }

  /** Those of some pieces of furniture (their boxes) that stand beside all planes, and hide what is behind them. */
  beside(boxes: readonly Box3[]): Box3[] {
    return boxes.filter(({ min, max }) => {
      const middle = [(min.x + max.x) / 2, (min.z + max.z) / 2] as const;
      const places = [[min.x, min.z], [max.x, min.z], [min.x, max.z], [max.x, max.z], middle] as const; // prettier-ignore
      return !places.some(([x, z]) => isPlaneAt(this.#map, x, z));
    });
  }

  /** Whether a place lies where furniture gives way. */
  isGiven(place: Vector3): boolean {
    return isOverPlane(this.#map, place);
  }

  dispose(): void {
    this.#uniforms.planeHeights.value?.dispose();
  }
}

/** Of the planes at a place of the map. */
function heightsAt({ heights, frame }: Footprints, x: number, z: number): Float32Array {
  const [column, row] = [Math.floor((x - frame[0]) * frame[2]), Math.floor((z - frame[1]) * frame[3])];
  if (column < 0 || row < 0 || column >= cells || row >= cells) return new Float32Array(0);
  const first = levels * (row * cells + column);
  return heights.subarray(first, first + levels);
}

/** Whether a plane lies at a place of the map. */
export function isPlaneAt(map: Footprints, x: number, z: number): boolean {
  return heightsAt(map, x, z).some((height) => height < none);
}

/** As the shader has it. */
export function isOverPlane(map: Footprints, { x, y, z }: Vector3): boolean {
  return heightsAt(map, x, z).some((height) => y - height >= -given && y - height <= storey);
}

/** Whether something stands between an eye and a place. */
export function isBehind(boxes: readonly Box3[], eye: Vector3, place: Vector3): boolean {
  const ray = new Ray(eye, place.clone().sub(eye).normalize());
  const met = new Vector3();
  return boxes.some((box) => {
    const hit = ray.intersectBox(box, met);
    return hit !== null && hit.distanceTo(eye) < place.distanceTo(eye) - alike;
  });
}

/** Corners of triangles in the room, xyz each. */
function cornersOf({ geometry, matrixWorld }: Mesh): Float32Array {
  const position = geometry.getAttribute('position');
  const count = geometry.index?.count ?? position.count;
  const corners = new Float32Array(3 * count);
  const point = new Vector3();
  for (let i = 0; i < count; i++)
    point
      .fromBufferAttribute(position, geometry.index?.getX(i) ?? i)
      .applyMatrix4(matrixWorld)
      .toArray(corners, 3 * i);
  return corners;
}

/** The map of planes (corners of their triangles): four heights a cell, and the frame of the shader. */
export function heightsOf(planes: readonly Float32Array[], floor: number): Footprints {
  const heights = new Float32Array(levels * cells * cells).fill(none);
  const level = planes
    .map((corners) => ({ corners, low: least(corners, 1), high: most(corners, 1) }))
    .filter(({ low, high }) => high - low < flat && low > floor + underfoot)
    .sort((a, b) => a.low - b.low);
  const bound = (end: (corners: Float32Array, axis: number) => number, axis: number) =>
    level.map(({ corners }) => end(corners, axis));
  const [x, z] = [Math.min(...bound(least, 0)), Math.min(...bound(least, 2))];
  const [farX, farZ] = [Math.max(...bound(most, 0)), Math.max(...bound(most, 2))];
  if (level.length === 0) return { heights, frame: [0, 0, -1, -1] };
  const [alongX, alongZ] = [cells / (farX - x || 1), cells / (farZ - z || 1)];
  let [channel, last] = [-1, -Infinity];
  for (const { corners, low } of level) {
    if (low > last + alike) [channel, last] = [Math.min(channel + 1, levels - 1), low];
    for (let at = 0; at + 8 < corners.length; at += 9) {
      const points = [0, 3, 6].map((i): [number, number] => [
        (corners[at + i]! - x) * alongX,
        (corners[at + i + 2]! - z) * alongZ,
      ]);
      forEachCell(points, (cell) => (heights[levels * cell + channel] = low));
    }
  }
  return { heights, frame: [x, z, alongX, alongZ] };
}

function least(corners: Float32Array, axis: number): number {
  let low = Infinity;
  for (let i = axis; i < corners.length; i += 3) low = Math.min(low, corners[i]!);
  return low;
}

function most(corners: Float32Array, axis: number): number {
  let high = -Infinity;
  for (let i = axis; i < corners.length; i += 3) high = Math.max(high, corners[i]!);
  return high;
}

/** Calls for every cell whose middle lies in a triangle of the map. */
function forEachCell(points: readonly (readonly [number, number])[], mark: (cell: number) => void): void {
  const [a, b, c] = points as [[number, number], [number, number], [number, number]];
  const side = (p: readonly number[], q: readonly number[], x: number, z: number) =>
    (q[0]! - p[0]!) * (z - p[1]!) - (q[1]! - p[1]!) * (x - p[0]!);
  const range = (axis: 0 | 1): [number, number] => [
    Math.max(0, Math.floor(Math.min(a[axis], b[axis], c[axis]))),
    Math.min(cells - 1, Math.ceil(Math.max(a[axis], b[axis], c[axis]))),
  ];
  const [[fromX, toX], [fromZ, toZ]] = [range(0), range(1)];
  for (let z = fromZ; z <= toZ; z++)
    for (let x = fromX; x <= toX; x++) {
      const sides = [
        side(a, b, x + 0.5, z + 0.5),
        side(b, c, x + 0.5, z + 0.5),
        side(c, a, x + 0.5, z + 0.5),
      ];
      if (sides.every((s) => s >= 0) || sides.every((s) => s <= 0)) mark(z * cells + x);
    }
}

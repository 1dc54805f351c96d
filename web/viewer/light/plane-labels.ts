/**
 * Numbers over the measuring planes of a false-colour picture: readings in lux on a grid whose step follows the scale
 * of the picture, and levels on isolux lines. Drawn flat over the 3D picture, so that they stay sharp and upright.
 */
import { PerspectiveCamera, Vector3, type Box3, type Camera } from 'three';
import type { SceneInfo } from '../../document/types.ts';
import type { TagPlace } from '../types.ts';
import { formatLight } from './false-color.ts';
import { isoluxLevels } from './isolux.ts';
import { isBehind } from './plane-footprints.ts';
import { crossings, gridPatches, neighbours, type Plane, type Reading } from './plane-readings.ts';

const steps = [0.25, 0.5, 1, 2, 4, 8]; // m
const apart = { wide: 46, high: 24 }; // px between readings
const text = { wide: 38, high: 16 }; // px, about, with some air beside a tag
const sameLevel = 170; // px between two names of one level

/** What is known of a plane, made when it is first shown. */
interface Known {
  readonly plane: Plane;
  readonly pairs: readonly (readonly [number, number])[];
  readonly grids: Map<number, readonly number[]>;
}

interface Placed {
  readonly x: number;
  readonly y: number;
  readonly text: string;
  readonly isLevel: boolean;
}

/** Whether a number would lie under a tag or read as one with it. */
export function isAtTag(tags: readonly TagPlace[], { x, y }: { x: number; y: number }): boolean {
  return tags.some(
    (tag) =>
      Math.abs(tag.x - x) < (tag.wide + text.wide) / 2 && Math.abs(tag.y - y) < (tag.high + text.high) / 2,
  );
}

export class PlaneLabels {
  readonly canvas = document.createElement('canvas');
  #scene: SceneInfo | null = null;
  #planes = new Map<number, Known>(); // by leaf surface
  #drawn = false;
  #tags: readonly TagPlace[] = [];
  #before: readonly Box3[] = [];
  #point = new Vector3();

  constructor(labels: HTMLElement) {
    this.canvas.className = 'plane-labels';
    labels.prepend(this.canvas);
  }

  setScene(scene: SceneInfo | null): void {
    this.#scene = scene;
    this.#planes.clear();
  }

  /**
   * Numbers for the planes in `surfaces` (leaves), seen by `camera`, beside the `tags` and not on what stands `before` a
   * plane; what is not wanted is not drawn.
   */
  draw(
    camera: Camera,
    size: { readonly width: number; readonly height: number; readonly ratio: number },
    light: Float32Array | null,
    surfaces: readonly number[],
    wanted: { readonly values: boolean; readonly levels: boolean },
    tags: readonly TagPlace[],
    before: readonly Box3[],
  ): void {
    this.#tags = tags;
    this.#before = before;
    const isWanted = light !== null && surfaces.length > 0 && (wanted.values || wanted.levels);
    if (!isWanted && !this.#drawn) return;
    const context = this.#clear(size);
    this.#drawn = isWanted;
    if (!isWanted || !context) return;
    const placed: Placed[] = [];
    for (const surface of surfaces) {
      const known = this.#known(surface);
      if (!known) continue;
      // The grid is read as a whole; a line can be named at another place.
      if (wanted.values) this.#placeValues(known, camera, size, light, placed);
      if (wanted.levels) this.#placeLevels(known, camera, size, light, placed);
    }
    for (const label of placed) paint(context, label);
  }

  dispose(): void {
    this.canvas.remove();
  }

  #clear({ width, height, ratio }: { width: number; height: number; ratio: number }) {
    const [wide, high] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (this.canvas.width !== wide || this.canvas.height !== high)
      [this.canvas.width, this.canvas.height] = [wide, high];
    const context = this.canvas.getContext('2d');
    context?.setTransform(ratio, 0, 0, ratio, 0, 0);
    context?.clearRect(0, 0, width, height);
    return context;
  }

  #known(surface: number): Known | null {
    const scene = this.#scene;
    if (!scene) return null;
    let known = this.#planes.get(surface);
    if (!known) {
      const patches: number[] = [];
      for (let row = scene.patches; row < scene.patches + scene.receivers; row++)
        if (scene.surfaceOfPatch[row] === surface) patches.push(row);
      if (patches.length === 0) return null;
      const plane = { patches, center: scene.patchCenter, area: scene.patchArea };
      known = { plane, pairs: neighbours(plane), grids: new Map() };
      this.#planes.set(surface, known);
    }
    return known;
  }

  #placeValues(known: Known, camera: Camera, size: Size, light: Float32Array, placed: Placed[]): void {
    const { plane, grids } = known;
    const scale = this.#pixelsPerMetre(plane, camera, size);
    const step = steps.find((metres) => metres * scale >= apart.wide) ?? steps.at(-1)!;
    let grid = grids.get(step);
    if (!grid) grids.set(step, (grid = gridPatches(plane, step)));
    for (const patch of grid) {
      const at = this.#project(plane.center.subarray(3 * patch, 3 * patch + 3), camera, size);
      if (!at || isAtTag(this.#tags, at) || isNear(placed, at, apart.wide, apart.high)) continue;
      placed.push({ ...at, text: formatLight(rounded(light[patch]!)), isLevel: false });
    }
  }

  #placeLevels(known: Known, camera: Camera, size: Size, light: Float32Array, placed: Placed[]): void {
    const levels = new Map<number, { x: number; y: number }[]>();
    for (const { point, value } of crossings(known.plane, known.pairs, light, isoluxLevels) as Reading[]) {
      const at = this.#project(point, camera, size);
      const others = levels.get(value) ?? [];
      if (!at || isAtTag(this.#tags, at)) continue;
      if (isNear(others, at, sameLevel, sameLevel) || isNear(placed, at, apart.wide, apart.high)) continue;
      levels.set(value, [...others, at]);
      placed.push({ ...at, text: formatLight(value), isLevel: true });
    }
  }

  #pixelsPerMetre({ patches, center }: Plane, camera: Camera, size: Size): number {
    const middle = patches[patches.length >> 1]!;
    const [x, y, z] = center.subarray(3 * middle, 3 * middle + 3) as unknown as [number, number, number];
    const here = this.#project([x, y, z], camera, size, true)!;
    const reach = [
      [x + 1, y, z],
      [x, y, z + 1],
    ].map((point) => this.#project(point, camera, size, true)!);
    return Math.max(1, ...reach.map((there) => Math.hypot(there.x - here.x, there.y - here.y)));
  }

  /** From above nothing that is drawn hides a plane. */
  #isHidden(camera: Camera): boolean {
    return camera instanceof PerspectiveCamera && isBehind(this.#before, camera.position, this.#point);
  }

  #project(
    point: ArrayLike<number>,
    camera: Camera,
    { width, height }: Size,
    anywhere = false,
  ): { x: number; y: number } | null {
    this.#point.set(point[0]!, point[1]!, point[2]!);
    if (!anywhere && this.#isHidden(camera)) return null;
    this.#point.project(camera);
    const { x, y, z } = this.#point;
    if (!anywhere && (Math.abs(z) > 1 || Math.abs(x) > 1 || Math.abs(y) > 1)) return null;
    return { x: (0.5 + 0.5 * x) * width, y: (0.5 - 0.5 * y) * height };
  }
}

interface Size {
  readonly width: number;
  readonly height: number;
}

/** As precise as a reading is: whole lux, tens from 1000 on. */
const rounded = (lux: number): number =>
  lux >= 1000 ? 10 * Math.round(lux / 10) : lux >= 10 ? Math.round(lux) : lux;

const isNear = (
  placed: readonly { readonly x: number; readonly y: number }[],
  at: { readonly x: number; readonly y: number },
  wide: number,
  high: number,
): boolean => placed.some(({ x, y }) => Math.abs(x - at.x) < wide && Math.abs(y - at.y) < high);

function paint(context: CanvasRenderingContext2D, { x, y, text, isLevel }: Placed): void {
  context.font = `${isLevel ? 600 : 500} 11px system-ui, sans-serif`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  if (isLevel) {
    const half = context.measureText(text).width / 2 + 4;
    context.fillStyle = 'rgb(255 255 255 / 88%)';
    context.beginPath();
    context.roundRect(x - half, y - 8, 2 * half, 16, 4);
    context.fill();
    context.fillStyle = '#111';
  } else {
    context.lineWidth = 3;
    context.lineJoin = 'round';
    context.strokeStyle = 'rgb(0 0 0 / 55%)';
    context.strokeText(text, x, y);
    context.fillStyle = '#fff';
  }
  context.fillText(text, x, y);
}

/**
 * The light near contacts on the screen: the room's triangles go to a worker some time after the first picture, and what
 * comes back is laid on the meshes as lattices (contact/openness.ts) that the light material reads; the shadows of luminaires
 * (contact/shadows.ts) come whenever a layout rests. No number changes. The mark 'contacts lit' says that both are there.
 */
import {
  BufferAttribute,
  DataTexture,
  NearestFilter,
  RedFormat,
  UnsignedByteType,
  Vector3,
  type BufferGeometry,
  type Texture,
} from 'three';
import type { SceneInfo } from '../../document/types.ts';
import type { SharedUniforms } from '../light/light-material.ts';
import { LightTexture } from '../light/light-texture.ts';
import type { LitMesh } from '../room/room-mesh.ts';
import { floatsOf } from '../room/attribute-numbers.ts';
import { breaths } from '../stage/breath.ts';
import { reducedMotion, type FrameLoop } from '../stage/frame-loop.ts';
import type { Solid, SolidPart } from './lattice.ts';
import type { ClosedGaps } from './narrow-gaps.ts';
import type { Openness } from './openness.ts';
import type { LuminaireLight } from '../types.ts';
import type { ShadowsCast } from './shadows.ts';
import type { ContactAnswer, ContactQuestion } from './worker.ts';

const mark = 'contacts lit';
const calm = 3000; // ms without new light, before anything is worked out: nothing is to wait for it
const rest = 400; // ms without another layout, before its shadows are cast
const blending = 600; // ms in which what was found comes
const leaving = 150; // ms in which shadows of another layout go
export const tableWidth = 1024; // of the texture of values: the shader splits a place by shift and mask

interface Textures {
  readonly values: Texture;
  readonly means: LightTexture;
  readonly shadows: LightTexture;
  readonly meanShadows: LightTexture;
  readonly arriving: LightTexture;
}

export class ContactLight {
  #loop: FrameLoop;
  #uniforms: SharedUniforms;
  #lights: () => readonly LuminaireLight[];
  #worker: Worker | null = null;
  #begin: (() => void) | null = null; // what waits for a calm moment
  #timer: ReturnType<typeof setTimeout> | undefined;
  #textures: Textures | null = null;
  #layout = ''; // that the shadows are of, or will be
  #turn = 0;
  #isShaded = false; // the shadows are those of the layout
  #drawn = 0; // ms, when a step of a blend was drawn last

  /** `lights`: the luminaires as they hang. */
  constructor(loop: FrameLoop, uniforms: SharedUniforms, lights: () => readonly LuminaireLight[]) {
    this.#loop = loop;
    this.#uniforms = uniforms;
    this.#lights = lights;
  }

  /** Another room, which is drawn already, or none. */
  setRoom(lit: readonly LitMesh[], scene: SceneInfo | null): void {
    this.#end();
    if (!scene) return;
    const solids = lit.filter(({ measuring }) => !measuring);
    this.#begin = () => void this.#open(solids, scene);
    this.wait();
  }

  /** Somebody is at work: what has not begun yet waits until they rest. */
  wait(): void {
    if (!this.#begin) return;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(this.#begin, calm);
  }

  /** Luminaires hang or shine otherwise: `layout` says how. Their old shadows go, the new ones come when that rests. */
  setLayout(layout: string): void {
    if (layout === this.#layout) return;
    this.#layout = layout;
    this.#turn++;
    if (!this.#textures) return;
    performance.clearMarks(mark);
    this.#isShaded = false;
    this.#blendOn();
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#cast(), rest);
  }

  /** Forgets what was uploaded (the context is lost); the next frame uploads it anew. */
  release(): void {
    const { values, ...light } = this.#textures ?? {};
    values?.dispose();
    for (const each of Object.values(light)) each?.dispose();
  }

  dispose(): void {
    this.#end();
  }

  /** In short tasks, as what comes back is laid: none of it is waited for. */
  async #open(solids: readonly LitMesh[], scene: SceneInfo): Promise<void> {
    const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module', name: 'contacts' });
    this.#worker = worker;
    this.#begin = null;
    worker.onerror = () => this.#stop(); // the picture does without
    worker.onmessage = ({ data }: MessageEvent<ContactAnswer>) => {
      if ('openness' in data) void this.#lay(worker, solids, data.openness, data.gaps);
      else if (data.turn === this.#turn) this.#shade(data.shadows);
    };
    const rested = breaths();
    const parts: SolidPart[] = [];
    for (const solid of solids) {
      parts.push(partOf(solid, scene));
      await rested();
      if (this.#worker !== worker) return;
    }
    const room = { parts, ...patchesOf(scene) };
    await rested();
    if (this.#worker === worker) this.#ask({ room }, buffersOf(room));
  }

  /** `transfer`: what the worker takes over. */
  #ask(question: ContactQuestion, transfer: Transferable[] = []): void {
    this.#worker?.postMessage(question, transfer);
  }

  async #lay(
    worker: Worker,
    solids: readonly LitMesh[],
    found: Pick<Openness, 'tiles' | 'values' | 'means'>,
    gaps: readonly ClosedGaps[],
  ): Promise<void> {
    const rested = breaths();
    for (const [i, { mesh }] of solids.entries()) {
      closeGaps(mesh, gaps[i]!);
      layTiles(mesh.geometry, found.tiles[i]!);
      await rested();
      if (this.#worker !== worker) return;
    }
    const means = new LightTexture(found.means.length);
    means.set(found.means);
    const textures = {
      values: valuesTexture(found.values),
      means,
      shadows: new LightTexture(found.values.length),
      meanShadows: new LightTexture(found.means.length),
      arriving: new LightTexture(found.means.length),
    };
    this.#textures = textures;
    this.#uniforms.opennessTexture.value = textures.values;
    this.#uniforms.meanOpennessTexture.value = means.texture;
    this.#uniforms.shadowTexture.value = textures.shadows.texture;
    this.#uniforms.meanShadowTexture.value = textures.meanShadows.texture;
    this.#uniforms.arrivingTexture.value = textures.arriving.texture;
    this.#blendOn();
    this.#cast();
  }

  #cast(): void {
    this.#ask({ lights: this.#lights(), turn: this.#turn });
  }

  #shade({ values, means, arriving }: ShadowsCast): void {
    this.#textures?.shadows.set(values);
    this.#textures?.meanShadows.set(means);
    this.#textures?.arriving.set(arriving);
    this.#isShaded = true;
    performance.mark(mark);
    this.#blendOn();
  }

  #blendOn(): void {
    this.#drawn = 0;
    if (reducedMotion()) this.#step(Infinity);
    else this.#loop.animate(this.#blend);
    this.#loop.invalidate();
  }

  #blend = (now: number): boolean => {
    const passed = this.#drawn === 0 ? 16 : now - this.#drawn;
    this.#drawn = now;
    return this.#step(passed);
  };

  /** Whether there is more to come. */
  #step(passed: number): boolean {
    const { contact, shade } = this.#uniforms;
    contact.value = Math.min(1, contact.value + passed / blending);
    shade.value = this.#isShaded
      ? Math.min(1, shade.value + passed / blending)
      : Math.max(0, shade.value - passed / leaving);
    return contact.value < 1 || shade.value !== Number(this.#isShaded);
  }

  #stop(): void {
    clearTimeout(this.#timer);
    this.#worker?.terminate();
    this.#worker = this.#begin = null;
  }

  #end(): void {
    this.#stop();
    performance.clearMarks(mark);
    this.#loop.cancel(this.#blend);
    this.release();
    this.#textures = null;
    this.#isShaded = false;
    const { contact, shade, ...textures } = this.#uniforms;
    for (const name of [
      'opennessTexture',
      'meanOpennessTexture',
      'shadowTexture',
      'meanShadowTexture',
      'arrivingTexture',
    ] as const)
      textures[name].value = null;
    contact.value = shade.value = 0;
  }
}

function patchesOf({ patches, patchArea, patchCenter }: SceneInfo): Omit<Solid, 'parts'> {
  const areas = patchArea.slice(0, patches).sort();
  return { patchCenter: patchCenter.slice(0, 3 * patches), edge: Math.sqrt(areas[areas.length >> 1] ?? 0) };
}

/** What a room's numbers are kept in. */
const buffersOf = ({ parts, patchCenter }: Solid): ArrayBufferLike[] =>
  [
    patchCenter,
    ...parts.flatMap((part) => [part.index, part.positions, part.normals, part.patches, part.weights]),
  ].map(({ buffer }) => buffer);

/** The triangles of a mesh that carries light, in the room's coordinates; copies. */
function partOf({ mesh, surface }: LitMesh, { surfaces }: SceneInfo): SolidPart {
  const { geometry, matrixWorld } = mesh;
  const position = geometry.getAttribute('position');
  return {
    index: geometry.index ? new Uint32Array(geometry.index.array) : upTo(position.count),
    positions: floatsOf(position.clone().applyMatrix4(matrixWorld), 3),
    normals: floatsOf(geometry.getAttribute('normal').clone().transformDirection(matrixWorld), 3),
    patches: floatsOf(geometry.getAttribute('_patches'), 4),
    weights: floatsOf(geometry.getAttribute('_weights'), 4),
    reflectance: surfaces[surface]?.reflectance ?? 0.5,
  };
}

/** 0, 1, ... */
function upTo(count: number): Uint32Array<ArrayBuffer> {
  const numbers = new Uint32Array(count);
  for (let i = 0; i < count; i++) numbers[i] = i;
  return numbers;
}

/** Draws a mesh as its narrow gaps are closed. */
export function closeGaps(
  { geometry, matrixWorld }: LitMesh['mesh'],
  { vertices, positions, hidden }: ClosedGaps,
): void {
  const attribute = geometry.getAttribute('position');
  const toMesh = matrixWorld.clone().invert();
  const at = new Vector3();
  vertices.forEach((vertex, i) => {
    at.fromArray(positions, 3 * i).applyMatrix4(toMesh);
    attribute.setXYZ(vertex, at.x, at.y, at.z);
  });
  attribute.needsUpdate = true;
  const { index } = geometry;
  if (!index) return;
  // Triangles keep their order: one that is not drawn is a point.
  for (const t of hidden) index.set([index.getX(3 * t), index.getX(3 * t), index.getX(3 * t)], 3 * t);
  index.needsUpdate = true;
}

/**
 * Gives every triangle with a lattice three corners of its own, behind the vertices that are there: the triangles keep
 * their order. `_lattice` of a corner: the first value and the cells along an edge (0: none), and where the corner is.
 */
export function layTiles(geometry: BufferGeometry, tile: Uint32Array): void {
  const before = geometry.getAttribute('position').count;
  const index = geometry.index ? new Uint32Array(geometry.index.array) : upTo(before);
  let tiled = 0; // triangles
  for (let t = 0; 3 * t < index.length; t++) if (tile[2 * t + 1]! > 0) tiled++;
  if (tiled === 0) return;
  const taken = new Uint32Array(3 * tiled); // the vertex that each new one repeats
  const lattice = new Float32Array(4 * (before + taken.length));
  for (let t = 0, next = 0; 3 * t < index.length; t++) {
    const [first, cells] = [tile[2 * t]!, tile[2 * t + 1]!];
    for (let corner = 0; cells > 0 && corner < 3; corner++, next++) {
      lattice.set([first, cells, Number(corner === 1), Number(corner === 2)], 4 * (before + next));
      taken[next] = index[3 * t + corner]!;
      index[3 * t + corner] = before + next;
    }
  }
  const longer = Object.entries(geometry.attributes).map(([name, attribute]) => {
    const { array, itemSize, normalized } = attribute as BufferAttribute;
    const more = new (array.constructor as new (length: number) => typeof array)(
      itemSize * (before + taken.length),
    );
    more.set(array);
    for (let i = 0, to = itemSize * before; i < taken.length; i++)
      for (let c = 0; c < itemSize; c++) more[to++] = array[itemSize * taken[i]! + c]!;
    return [name, new BufferAttribute(more, itemSize, normalized)] as const;
  });
  geometry.dispose();
  for (const [name, attribute] of longer) geometry.setAttribute(name, attribute);
  geometry.setAttribute('_lattice', new BufferAttribute(lattice, 4));
  geometry.setIndex(new BufferAttribute(index, 1));
}

function valuesTexture(values: Uint8Array): DataTexture {
  const rows = Math.max(1, Math.ceil(values.length / tableWidth));
  const padded = new Uint8Array(rows * tableWidth);
  padded.set(values);
  const texture = new DataTexture(padded, tableWidth, rows, RedFormat, UnsignedByteType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.generateMipmaps = false;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}

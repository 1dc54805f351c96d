/**
 * A glTF in one plain binary file, as the picture and the builder read it: siblings taken in, Draco and meshopt decoded,
 * pictures that only browsers read made PNG. Only what is needed is decoded; what is broken is left to the builder, which
 * says what is wrong.
 */
import type { DracoModule } from 'draco3dgltf/draco_decoder_gltf_nodejs.js';
import { readContainer, writeGlb } from '../../document/gltf-container.ts';

type Bytes = Uint8Array<ArrayBuffer>;

/** What decodes, fetched when it is first asked for. */
export interface Codecs {
  draco(): Promise<DracoModule>;
  meshopt(): Promise<{
    decodeGltfBuffer(
      target: Uint8Array,
      count: number,
      size: number,
      source: Uint8Array,
      mode: string,
      filter?: string,
    ): void;
  }>;
  /** null where the browser cannot read the picture. */
  png(picture: Bytes, mimeType: string): Promise<Bytes | null>;
}

const [draco, meshopt] = ['KHR_draco_mesh_compression', 'EXT_meshopt_compression'];
const browserPictures = ['EXT_texture_webp', 'EXT_texture_avif'];
const mostBytes = 256 << 20; // as the builder accepts them

/** Whether a file's JSON speaks of anything that has to be done here. */
export function needsUnpacking(bytes: Bytes): boolean {
  const { text } = readContainer(bytes);
  return [draco, meshopt, ...browserPictures, '"uri"'].some((word) => text.includes(word!));
}

/** Those parts of a glTF's JSON that are touched; all of it is a stranger's. */
interface Gltf {
  buffers?: { uri?: string; byteLength: number }[];
  bufferViews?: View[];
  accessors?: Accessor[];
  images?: { uri?: string; bufferView?: number; mimeType?: string }[];
  textures?: { source?: number; extensions?: Record<string, { source?: number }> }[];
  meshes?: { primitives: Primitive[] }[];
  extensionsUsed?: string[];
  extensionsRequired?: string[];
}
interface View {
  buffer: number;
  byteOffset?: number;
  byteLength: number;
  extensions?: { [meshopt: string]: Packed };
}
interface Packed extends View {
  byteStride: number;
  count: number;
  mode: string;
  filter?: string;
}
interface Accessor {
  bufferView?: number;
  componentType: number;
  count: number;
  type: string;
}
interface Primitive {
  attributes: Record<string, number>;
  indices?: number;
  mode?: number;
  extensions?: { [draco: string]: { bufferView: number; attributes: Record<string, number> } };
}

/** What the decoders say no to: the builder, which has none, would only say that the mesh is compressed. */
export class DamagedMesh extends Error {
  constructor() {
    super('a compressed mesh is damaged');
  }
}

/**
 * Throws where the file is not as it should be, or a buffer is missing: DamagedMesh where that is said of something
 * compressed. A picture that is missing stays so.
 */
export async function plainGlb(
  file: Bytes,
  siblings: ReadonlyMap<string, Bytes>,
  codecs: Codecs,
): Promise<Bytes> {
  const { text, bin } = readContainer(file);
  const gltf = JSON.parse(text) as Gltf;
  const sources = (gltf.buffers ?? []).map(({ uri }, index) =>
    uri === undefined ? (index === 0 ? bin : null) : bytesBehind(uri, siblings),
  );
  const parts = new Parts();
  await takeViews(gltf, sources, parts, codecs);
  await takePictures(gltf, siblings, parts, codecs);
  await takeDraco(gltf, parts, codecs);
  const isDone = (name: string) => ![draco, meshopt, ...browserPictures].includes(name);
  if (gltf.extensionsUsed) gltf.extensionsUsed = gltf.extensionsUsed.filter(isDone);
  if (gltf.extensionsRequired) gltf.extensionsRequired = gltf.extensionsRequired.filter(isDone);
  gltf.bufferViews = parts.views;
  const all = parts.bytes();
  gltf.buffers = [{ byteLength: all.length }];
  return writeGlb(gltf, all);
}

/** The new file's bytes, view by view. */
class Parts {
  readonly views: View[] = [];
  readonly #parts: Uint8Array[] = [];
  #end = 0;

  /** The view's index; `rest` is what the old view said beside its place. */
  add(part: Uint8Array, rest: object = {}): number {
    if (this.#end + part.length > mostBytes) throw new Error('it unpacks to too much');
    this.views.push({ ...rest, buffer: 0, byteOffset: this.#end, byteLength: part.length });
    this.#parts.push(part);
    this.#end += Math.ceil(part.length / 4) * 4;
    return this.views.length - 1;
  }

  part(view: number): Uint8Array {
    const part = this.#parts[view];
    if (!part) throw new Error('a view is missing');
    return part;
  }

  bytes(): Bytes {
    const all = new Uint8Array(this.#end);
    for (const [index, part] of this.#parts.entries()) all.set(part, this.views[index]!.byteOffset);
    return all;
  }
}

function bytesBehind(uri: string, siblings: ReadonlyMap<string, Bytes>): Bytes | null {
  const data = /^data:[^,]*;base64,/.exec(uri);
  if (!data) return siblings.get(decodeURIComponent(uri).replace(/^.*\//, '')) ?? null;
  return Uint8Array.from(atob(uri.slice(data[0].length)), (letter) => letter.charCodeAt(0));
}

function within(sources: readonly (Bytes | null)[], { buffer, byteOffset = 0, byteLength }: View) {
  const source = sources[buffer];
  if (!source || byteOffset + byteLength > source.length) throw new Error('a buffer is missing or cut off');
  return source.subarray(byteOffset, byteOffset + byteLength);
}

/** Every view as it is, or as meshopt's decoder unpacks it; indices stay what they were. */
async function takeViews(
  gltf: Gltf,
  sources: readonly (Bytes | null)[],
  parts: Parts,
  codecs: Codecs,
): Promise<void> {
  for (const view of gltf.bufferViews ?? []) {
    const { extensions, ...rest } = view;
    const packed = extensions?.[meshopt!];
    if (!packed) {
      parts.add(within(sources, view), rest);
      continue;
    }
    const { count, byteStride, mode, filter } = packed;
    if (!(count * byteStride <= view.byteLength && view.byteLength <= mostBytes))
      throw new Error('a view is too small for what it holds');
    const target = new Uint8Array(view.byteLength);
    const source = within(sources, packed);
    const decoder = await codecs.meshopt();
    try {
      decoder.decodeGltfBuffer(target, count, byteStride, source, mode, filter);
    } catch {
      throw new DamagedMesh();
    }
    parts.add(target, rest);
  }
}

async function takePictures(
  gltf: Gltf,
  siblings: ReadonlyMap<string, Bytes>,
  parts: Parts,
  codecs: Codecs,
): Promise<void> {
  const images = gltf.images ?? [];
  for (const image of images) {
    const bytes = image.uri === undefined ? null : bytesBehind(image.uri, siblings);
    if (!bytes) continue;
    image.mimeType ??= bytes[0] === 0x89 ? 'image/png' : 'image/jpeg';
    image.bufferView = parts.add(bytes);
    delete image.uri;
  }
  for (const texture of gltf.textures ?? []) {
    for (const kind of browserPictures) {
      const source = texture.extensions?.[kind]?.source;
      if (texture.source === undefined && source !== undefined) texture.source = source;
    }
    for (const kind of browserPictures) delete texture.extensions?.[kind];
  }
  for (const image of images) {
    if (image.bufferView === undefined || !/webp|avif/.test(image.mimeType ?? '')) continue;
    const png = await codecs.png(new Uint8Array(parts.part(image.bufferView)), image.mimeType!);
    if (png) [image.bufferView, image.mimeType] = [parts.add(png), 'image/png'];
  }
}

async function takeDraco(gltf: Gltf, parts: Parts, codecs: Codecs): Promise<void> {
  const accessors = gltf.accessors ?? [];
  for (const { primitives } of gltf.meshes ?? [])
    for (const primitive of primitives) {
      const packed = primitive.extensions?.[draco!];
      if (!packed) continue;
      delete primitive.extensions![draco!];
      if (accessors[primitive.attributes['POSITION']!]?.bufferView !== undefined) continue;
      const mesh = new DecodedMesh(await codecs.draco(), parts.part(packed.bufferView));
      try {
        for (const [name, id] of Object.entries(packed.attributes)) {
          const accessor = accessors[primitive.attributes[name]!];
          if (!accessor) continue;
          const bufferView = parts.add(mesh.attribute(id, accessor));
          primitive.attributes[name] = accessors.push({ ...accessor, bufferView, count: mesh.points }) - 1;
        }
        const corners = { componentType: 5125, type: 'SCALAR', count: 3 * mesh.faces };
        primitive.indices = accessors.push({ ...corners, bufferView: parts.add(mesh.corners()) }) - 1;
        primitive.mode = 4;
      } finally {
        mesh.end();
      }
    }
}

const widths: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

/** A primitive out of Draco's bytes; ended by `end`. */
class DecodedMesh {
  readonly #module: DracoModule;
  readonly #decoder;
  readonly #mesh;

  constructor(module: DracoModule, packed: Uint8Array) {
    this.#module = module;
    this.#decoder = new module.Decoder();
    this.#mesh = new module.Mesh();
    const buffer = new module.DecoderBuffer();
    buffer.Init(new Int8Array(packed), packed.length);
    const isWhole = this.#decoder.DecodeBufferToMesh(buffer, this.#mesh).ok();
    module.destroy(buffer);
    if (isWhole && this.points > 0) return;
    this.end();
    throw new DamagedMesh();
  }

  get points(): number {
    return this.#mesh.num_points();
  }
  get faces(): number {
    return this.#mesh.num_faces();
  }

  attribute(id: number, { componentType, type }: Accessor): Bytes {
    const attribute = this.#decoder.GetAttributeByUniqueId(this.#mesh, id);
    const { DT_INT8, DT_UINT8, DT_INT16, DT_UINT16, DT_UINT32, DT_FLOAT32 } = this.#module;
    const kinds: Record<number, readonly [number, number]> = {
      5120: [DT_INT8, 1],
      5121: [DT_UINT8, 1],
      5122: [DT_INT16, 2],
      5123: [DT_UINT16, 2],
      5125: [DT_UINT32, 4],
      5126: [DT_FLOAT32, 4],
    };
    const [kind, size] = kinds[componentType] ?? [0, 0];
    if (!attribute.ptr || !size || attribute.num_components() !== widths[type]) throw new DamagedMesh();
    const bytes = this.points * widths[type] * size;
    return this.#taken(bytes, (at) =>
      this.#decoder.GetAttributeDataArrayForAllPoints(this.#mesh, attribute, kind, bytes, at),
    );
  }

  corners(): Bytes {
    const bytes = 12 * this.faces;
    return this.#taken(bytes, (at) => this.#decoder.GetTrianglesUInt32Array(this.#mesh, bytes, at));
  }

  end(): void {
    this.#module.destroy(this.#mesh);
    this.#module.destroy(this.#decoder);
  }

  /** note: the heap is another one after it has grown, so it is asked for last. */
  #taken(bytes: number, fill: (at: number) => boolean): Bytes {
    const at = this.#module._malloc(bytes);
    const isFilled = fill(at);
    const taken = this.#module.HEAPU8.slice(at, at + bytes) as Bytes;
    this.#module._free(at);
    if (!isFilled) throw new DamagedMesh();
    return taken;
  }
}

/** Models that are broken or meant to harm, each made of a sound room of six squares by one change. */
import { writeGlb } from '../../web/document/gltf-container.ts';

type Json = any;

const corner = (i: number) => [(i & 1) * 4, ((i >> 1) & 1) * 3, ((i >> 2) & 1) * 5];
const faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]; // prettier-ignore

/** Parts that a change may touch. */
export interface Parts {
  json: Json;
  positions: Float32Array;
  indices: Uint32Array;
}

function sound(): Parts {
  const positions = Float32Array.from(faces.flatMap((face) => face.flatMap(corner)));
  const indices = Uint32Array.from(faces.flatMap((_, f) => [0, 1, 2, 0, 2, 3].map((i) => 4 * f + i)));
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name: 'room', mesh: 0 } as Json],
    materials: [{ name: 'paint', pbrMetallicRoughness: { baseColorFactor: [0.5, 0.5, 0.5, 1] } } as Json],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, material: 0 } as Json] }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 24, type: 'VEC3', min: [0, 0, 0], max: [4, 3, 5] } as Json,
      { bufferView: 1, componentType: 5125, count: 36, type: 'SCALAR' } as Json,
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: 288 },
      { buffer: 0, byteOffset: 288, byteLength: 144 },
    ],
    buffers: [{ byteLength: 432 } as Json],
  };
  return { json, positions, indices };
}

export function changed(change: (parts: Parts) => void): Uint8Array<ArrayBuffer> {
  const parts = sound();
  change(parts);
  const bytes = new Uint8Array(432);
  bytes.set(new Uint8Array(parts.positions.buffer), 0);
  bytes.set(new Uint8Array(parts.indices.buffer), 288);
  return writeGlb(parts.json, bytes);
}

const text = (content: string) => new TextEncoder().encode(content);
const cut = (bytes: Uint8Array<ArrayBuffer>, size: number) => bytes.slice(0, size);
const lying = (bytes: Uint8Array<ArrayBuffer>) => {
  new DataView(bytes.buffer).setUint32(12, 0x7fffffff, true);
  return bytes;
};

/** By name; every one must be refused in one line. */
export const refused: Readonly<Record<string, () => Uint8Array<ArrayBuffer>>> = {
  'count.glb': () => changed(({ json }) => (json.accessors[0].count = 2 ** 31 - 1)),
  'offset.glb': () => changed(({ json }) => (json.bufferViews[0].byteOffset = 2 ** 32 - 4)),
  'index.glb': () => changed(({ indices }) => (indices[5] = 99)),
  'nan.glb': () => changed(({ positions }) => (positions[4] = NaN)),
  'cycle.glb': () => changed(({ json }) => (json.nodes[0].children = [0])),
  'deep.glb': () =>
    changed(({ json }) => {
      json.nodes = Array.from({ length: 1e5 }, (_, i) =>
        i === 99_999 ? { mesh: 0 } : { children: [i + 1] },
      );
    }),
  'instances.glb': () =>
    changed(({ json }) => {
      json.nodes = Array.from({ length: 2e5 }, (_, i) => ({
        mesh: 0,
        translation: [5 * (i % 400), 0, i / 80],
      }));
      json.scenes[0].nodes = json.nodes.map((_: Json, i: number) => i);
    }),
  'parent.gltf': () => outside('../../../../etc/passwd'),
  'address.gltf': () => outside('https://example.com/room.bin'),
  'base64.gltf': () => outside('data:application/octet-stream;base64,*not base64*'),
  'sparse.glb': () =>
    changed(({ json }) => {
      json.accessors[0].sparse = {
        count: 1,
        indices: { bufferView: 1, componentType: 5125, byteOffset: 140 },
        values: { bufferView: 0 },
      };
      json.accessors[0].count = 2;
    }),
  'extension.glb': () =>
    changed(({ json }) => (json.extensionsUsed = json.extensionsRequired = ['XYZ_unheard_of'])),
  'draco.glb': () =>
    changed(({ json }) => {
      json.extensionsUsed = json.extensionsRequired = ['KHR_draco_mesh_compression'];
      json.meshes[0].primitives[0].extensions = {
        KHR_draco_mesh_compression: { bufferView: 0, attributes: { POSITION: 0 } },
      };
      delete json.accessors[0].bufferView;
    }),
  'empty.glb': () => changed(({ json }) => (json.scenes[0].nodes = [])),
  'points.glb': () => changed(({ json }) => (json.meshes[0].primitives[0].mode = 0)),
  'huge.glb': () => changed(({ json }) => (json.nodes[0].scale = [1e30, 1e30, 1e30])),
  'flat.glb': () => changed(({ json }) => (json.nodes[0].scale = [0, 0, 0])),
  'nested.gltf': () => text(`{"asset":{"version":"2.0"},"x":${'['.repeat(30_000)}${']'.repeat(30_000)}}`),
  'page.gltf': () => text('<!doctype html><title>404</title>'),
  'nothing.glb': () => new Uint8Array(0),
  'utf16.gltf': () => new Uint8Array(Uint16Array.from('{"asset":{}}', (c) => c.charCodeAt(0)).buffer),
  'lying.glb': () => lying(changed(() => {})),
  'cut.glb': () =>
    cut(
      changed(() => {}),
      700,
    ),
  'thin.glb': () => changed(({ positions }) => positions.fill(0)),
  'scene.flux': () => text('FLUX but cut off'),
  'lamp.ies': () => text('IESNA:LM-63-2002\nTILT=../file\n1 1000 1 3 1 1 2 0 0 0\n'),
  'bad.ldt': () => text('1\n2\n3'),
  'other.json': () => text('{"some":"thing"}'),
};

function outside(uri: string): Uint8Array<ArrayBuffer> {
  const { json } = sound();
  json.buffers[0].uri = uri;
  return text(JSON.stringify(json));
}
